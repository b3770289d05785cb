// A Burger that drives in circles in a house that it has mapped: what it takes to match a scan of 360 beams.
#include <benchmark/benchmark.h>

#include <scrubjay/localization/scan_matching.hpp>
#include <scrubjay/mapping/lidar_mapper.hpp>
#include <scrubjay/simulation/scan_caster.hpp>

#include "stage.hpp"

namespace scrubjay::bench {
namespace {

constexpr int kScansALap = 150;

RobotModel burger_model() {
  RobotModel robot;
  robot.drive = {0.160, 0.033, 4096.0};
  robot.lidar = LidarModel{};
  return robot;
}

/// The scans of a lap of 1 m across, with an LDS-01's noise, and the odometry between them, 2 % too long.
class Lap {
 public:
  Lap() {
    const Stage stage(kHouse);
    sim::ScanCaster caster(stage.index, lidar_);
    Random random(4);
    for (int i = 0; i < kScansALap; ++i) {
      const Pose2 pose = stage.start * at(i);
      for (const double range : caster.cast(pose * lidar_.mount)) {
        const double noise = lidar_.noise + lidar_.noise_per_range * range;
        ranges_.push_back(static_cast<float>(range + noise * random.normal()));
      }
    }
  }

  /// The next frame; scans are 0.2 s apart.
  Frame next() {
    const int i = count_++ % kScansALap;
    const Pose2 step = inverse(at(i)) * at(i + 1);
    odometry_ = odometry_ * Pose2{1.02 * step.x, 1.02 * step.y, 1.02 * step.yaw};
    Frame frame;
    frame.stamp = 0.2 * count_;
    frame.odometry = odometry_;
    const auto beams = static_cast<std::size_t>(lidar_.beams);
    const auto first = static_cast<std::size_t>((i + 1) % kScansALap) * beams;
    frame.scan = LaserScan{.stamp = frame.stamp,
                           .angle_increment = lidar_.angle_increment,
                           .range_min = lidar_.min_range,
                           .range_max = lidar_.max_range,
                           .ranges = std::span(ranges_).subspan(first, beams)};
    return frame;
  }

 private:
  static Pose2 at(int i) {
    const double angle = 2.0 * kPi * i / kScansALap;
    const SinCos turn = sin_cos(angle);
    return {0.5 * turn.sin, 0.5 - 0.5 * turn.cos, wrap_angle(angle)};
  }

  LidarModel lidar_;
  std::vector<float> ranges_;
  int count_ = 0;
  Pose2 odometry_;
};

/// The localizer alone, on a map that stays as three laps made it.
void MatchScan(benchmark::State& state) {
  const RobotModel robot = burger_model();
  LidarMapper mapper(robot, 0.05);
  ScanMatching localizer(robot, mapper);
  Lap lap;
  for (int i = 0; i < 3 * kScansALap; ++i) {
    const Frame frame = lap.next();
    mapper.update(frame, localizer.update(frame));
  }
  for (auto _ : state) benchmark::DoNotOptimize(localizer.update(lap.next()));
}
BENCHMARK(MatchScan)->Unit(benchmark::kMicrosecond);

/// A look at all cells of a scan's reach, of which `state.range(0)` changed.
void LikelihoodFieldFollows(benchmark::State& state) {
  const GridGeometry grid{0.05, {0.0, 0.0}, 140, 140};
  std::vector<LogOdds> cells(grid.size());
  LikelihoodField field;
  field.follow({grid, cells.data()}, cells_of(grid));
  Random random(1);
  for (auto _ : state) {
    for (std::int64_t i = 0; i < state.range(0); ++i) {
      LogOdds& cell = cells[random.below(static_cast<std::uint32_t>(cells.size()))];
      cell = static_cast<LogOdds>(cell == 0 ? 50 : 0);
    }
    field.follow({grid, cells.data()}, cells_of(grid));
    benchmark::ClobberMemory();
  }
}
BENCHMARK(LikelihoodFieldFollows)->Arg(0)->Arg(20)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace scrubjay::bench
