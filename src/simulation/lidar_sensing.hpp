/// \file
/// A lidar that turns on a robot that moves.
#pragma once

#include <optional>
#include <scrubjay/geometry/random.hpp>
#include <scrubjay/robot/laser_scan.hpp>
#include <scrubjay/simulation/noise.hpp>
#include <scrubjay/simulation/scan_caster.hpp>
#include <vector>

namespace scrubjay::sim {

/// One turn takes a whole number of ticks, so that each scan ends with a frame.
class LidarSensing {
 public:
  /// `index` must outlive it. `tick` [s] is that of the robot, which stands at `robot`.
  LidarSensing(const SegmentIndex& index, const LidarModel& lidar, const NoiseProfile& noise, const Random& random,
               double tick, bool motion_distortion, const Pose2& robot);

  /// One tick later the robot is at `robot`. A scan, if the turn is complete; its ranges are good until the next one.
  std::optional<LaserScan> tick(const Pose2& robot, double stamp);

 private:
  void measure_turn(const Pose2& robot);
  void measure_tick(const Pose2& robot);
  float reported(double range);

  const SegmentIndex* index_;
  LidarModel lidar_;
  NoiseProfile noise_;
  Random random_;
  bool motion_distortion_;
  int ticks_a_turn_;
  double time_increment_;
  ScanCaster caster_;
  Pose2 robot_;                 // a tick ago
  int ticks_ = 0;               // of this turn, so far
  std::uint64_t turns_ = 0;     // so far
  Random turn_random_;          // beam i of a turn takes number i of this
  std::vector<float> ranges_;   // of this turn, so far
  std::vector<float> scanned_;  // of the last one
};

}  // namespace scrubjay::sim
