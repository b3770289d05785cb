#include <benchmark/benchmark.h>

#include <scrubjay/world/score.hpp>
#include <scrubjay/world/segment_index.hpp>
#include <world/generated.hpp>

namespace scrubjay {
namespace {

/// A house of `rooms` x `rooms` rooms: 5 make about 180 segments in 20 x 20 m, 40 about 12,000 in 160 x 160 m.
std::vector<SolidSegment> house(const benchmark::State& state) {
  Random random(1);
  return solid_segments(test::random_house(random, static_cast<int>(state.range(0)), 4.0));
}

/// Points in the house, and directions all around.
std::vector<Pose2> viewpoints(const benchmark::State& state) {
  Random random(2);
  std::vector<Pose2> poses;
  const double side = 4.0 * static_cast<double>(state.range(0));
  for (int i = 0; i < 4096; ++i) {
    const Point2 p = test::random_point(random, 0.0, side);
    poses.push_back({p.x(), p.y(), random.uniform(-kPi, kPi)});
  }
  return poses;
}

void report_segments(benchmark::State& state, const SegmentIndex& index) {
  state.counters["segments"] = static_cast<double>(index.segments().size());
}

void Cast(benchmark::State& state) {
  const SegmentIndex index(house(state));
  struct Ray {
    Point2 origin, direction;
  };
  std::vector<Ray> rays;
  for (const Pose2& pose : viewpoints(state)) rays.push_back({pose.position(), direction(pose.yaw)});
  std::size_t i = 0;
  for (auto _ : state) {
    const Ray& ray = rays[++i % rays.size()];
    benchmark::DoNotOptimize(index.cast(ray.origin, ray.direction, 3.5));
  }
  report_segments(state, index);
}

/// As a scan does: 360 rays from one place.
void CastScan(benchmark::State& state) {
  const SegmentIndex index(house(state));
  std::vector<Point2> directions;
  for (int i = 0; i < 360; ++i) directions.push_back(direction(radians(i)));
  const std::vector<Pose2> poses = viewpoints(state);
  std::size_t i = 0;
  for (auto _ : state) {
    const Point2 origin = poses[++i % poses.size()].position();
    for (const Point2& beam : directions) benchmark::DoNotOptimize(index.cast(origin, beam, 3.5));
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * 360);
  report_segments(state, index);
}

void Within(benchmark::State& state) {
  const SegmentIndex index(house(state));
  const std::vector<Pose2> poses = viewpoints(state);
  std::vector<std::uint32_t> found;
  std::size_t i = 0;
  for (auto _ : state) {
    index.within(poses[++i % poses.size()].position(), 0.2, found);
    benchmark::DoNotOptimize(found.data());
  }
  report_segments(state, index);
}

void Distance(benchmark::State& state) {
  const SegmentIndex index(house(state));
  const std::vector<Pose2> poses = viewpoints(state);
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(index.distance(poses[++i % poses.size()].position(), 5.0));
  report_segments(state, index);
}

void Build(benchmark::State& state) {
  const std::vector<SolidSegment> segments = house(state);
  for (auto _ : state) {
    const SegmentIndex index(segments);
    benchmark::DoNotOptimize(index.segments().data());
  }
}

/// The truth of a house of rooms of 4 x 4 m, in cells of 5 cm.
void Truth(benchmark::State& state) {
  Random random(1);
  const World world = test::random_house(random, static_cast<int>(state.range(0)), 4.0);
  const Pose2 start = starting_pose(world, 0.1735);
  for (auto _ : state) benchmark::DoNotOptimize(ground_truth(world, start, 0.1735, 0.05).reachable_count);
}

void StartingPose(benchmark::State& state) {
  Random random(1);
  const World world = test::random_house(random, static_cast<int>(state.range(0)), 4.0);
  for (auto _ : state) benchmark::DoNotOptimize(starting_pose(world, 0.1735).x);
}

BENCHMARK(Cast)->Arg(5)->Arg(40);
BENCHMARK(CastScan)->Arg(5)->Arg(40);
BENCHMARK(Within)->Arg(5)->Arg(40);
BENCHMARK(Distance)->Arg(5)->Arg(40);
BENCHMARK(Build)->Arg(5)->Arg(40);
BENCHMARK(Truth)->Arg(2)->Arg(3)->Unit(benchmark::kMillisecond);
BENCHMARK(StartingPose)->Arg(3)->Arg(40)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace scrubjay
