// A lidar's scans, and the whole robot that carries it.
//
// What a ray costs otherwise, on the same kind of machine and in the same houses: Box2D's tree 176 to 449 ns; a walk
// through a raster of 5, 2 or 1 cm 70, 123 or 200 ns; a distance field of these 65, 79 or 104 ns, and both of them are
// centimetres short. SegmentIndex::cast is exact and takes 30 to 50 ns (SingleRays); a whole scan at once, with the
// same result to the last bit, 4 to 12 ns a beam (WholeScan).
#include <benchmark/benchmark.h>

#include <scrubjay/simulation/scan_caster.hpp>
#include <scrubjay/simulation/simulated_turtlebot.hpp>

#include "stage.hpp"

namespace scrubjay::bench {
namespace {

sim::RobotSpec burger() {
  return read_robot(SCRUBJAY_SOURCE_DIR "/urdf/turtlebot3_burger.urdf");
}

/// Turns on the spot while something is ahead, and drives on while nothing is.
Motion wander(const LaserScan& scan) {
  for (const std::size_t beam : {0u, 15u, 30u, 345u, 330u}) {
    if (scan.ranges[beam] < 0.35f) return {0.0, 1.5};
  }
  return {0.22, 0.1};
}

/// Poses of the lidar on a way through the house, one a scan.
std::vector<Pose2> way(const Stage& stage) {
  sim::SimulatedTurtlebot robot(stage.world, stage.index, burger(), {}, Random(1), stage.start);
  std::vector<Pose2> poses;
  while (poses.size() < 3000) {
    const std::optional<Frame> frame = robot.next();
    if (!frame->scan) continue;
    poses.push_back(robot.truth().pose * burger().model.lidar->mount);
    robot.drive(wander(*frame->scan));
  }
  return poses;
}

void report(benchmark::State& state, std::size_t scans) {
  const double count = static_cast<double>(scans) * static_cast<double>(state.iterations());
  state.counters["scan"] = benchmark::Counter(count, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["beam"] = benchmark::Counter(360.0 * count, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void cast_singly(const SegmentIndex& index, std::span<const Point2> beams, const Pose2& pose) {
  const SinCos turn = sin_cos(pose.yaw);
  for (const Point2& beam : beams) {
    const Point2 along(turn.cos * beam.x() - turn.sin * beam.y(), turn.sin * beam.x() + turn.cos * beam.y());
    benchmark::DoNotOptimize(index.cast(pose.position(), along, 3.5));
  }
}

void SingleRays(benchmark::State& state) {
  const Stage stage(static_cast<int>(state.range(0)));
  const std::vector<Pose2> poses = way(stage);
  const sim::ScanCaster caster(stage.index, LidarModel{});
  for (auto _ : state) {
    for (const Pose2& pose : poses) cast_singly(stage.index, caster.beams(), pose);
  }
  report(state, poses.size());
}
BENCHMARK(SingleRays)->Arg(kHouse)->Arg(kEstate)->Unit(benchmark::kMillisecond);

void WholeScan(benchmark::State& state) {
  const Stage stage(static_cast<int>(state.range(0)));
  const std::vector<Pose2> poses = way(stage);
  sim::ScanCaster caster(stage.index, LidarModel{});
  for (auto _ : state) {
    for (const Pose2& pose : poses) benchmark::DoNotOptimize(caster.cast(pose).data());
  }
  report(state, poses.size());
}
BENCHMARK(WholeScan)->Arg(kHouse)->Arg(kEstate)->Unit(benchmark::kMillisecond);

/// Chair legs of sixteen sides, so many of them on 20 x 20 m: where single rays catch up.
void Crowd(benchmark::State& state, bool whole) {
  Random random(3);
  World world;
  for (int i = 0; i < state.range(0); ++i) {
    world.furniture.push_back({"leg", {disc(test::random_point(random, 0.0, 20.0), 0.03)}});
  }
  const SegmentIndex index(solid_segments(world));
  sim::ScanCaster caster(index, LidarModel{});
  double x = 0.0;
  for (auto _ : state) {
    x = x > 16.0 ? 4.0 : x + 0.044;
    const Pose2 pose{x, 10.0, 0.1 * x};
    if (whole) {
      benchmark::DoNotOptimize(caster.cast(pose).data());
    } else {
      cast_singly(index, caster.beams(), pose);
    }
  }
  report(state, 1);
}
BENCHMARK_CAPTURE(Crowd, single_rays, false)->Arg(300)->Arg(1200)->Arg(3000)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(Crowd, whole_scan, true)->Arg(300)->Arg(1200)->Arg(3000)->Unit(benchmark::kMicrosecond);

/// The whole robot, driven by its own scans for ten minutes: x_real_time is simulated seconds per second of CPU time.
void Turtlebot(benchmark::State& state, const char* profile, bool motion_distortion, int rooms) {
  const Stage stage(rooms);
  const sim::RobotSpec spec = burger();
  const sim::NoiseProfile errors = noise(profile);
  constexpr int kTicks = 30'000;
  for (auto _ : state) {
    sim::SimulatedTurtlebot robot(stage.world, stage.index, spec, errors, Random(1), stage.start, {motion_distortion});
    for (int i = 0; i < kTicks; ++i) {
      const std::optional<Frame> frame = robot.next();
      if (frame->scan) robot.drive(wander(*frame->scan));
    }
    benchmark::DoNotOptimize(robot.truth());
  }
  const double ticks = kTicks * static_cast<double>(state.iterations());
  state.counters["x_real_time"] =
      benchmark::Counter(sim::SimulatedTurtlebot::kTick * ticks, benchmark::Counter::kIsRate);
}
BENCHMARK_CAPTURE(Turtlebot, none, "none", false, kHouse)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(Turtlebot, hard_floor, "hard-floor", false, kHouse)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(Turtlebot, hard_floor_distorted, "hard-floor", true, kHouse)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(Turtlebot, hard_floor_12000, "hard-floor", false, kEstate)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace scrubjay::bench
