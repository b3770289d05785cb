/// \file
/// How far a disc could drive in every direction, by one turn of a lidar.
#pragma once

#include <array>
#include <scrubjay/geometry/pose2.hpp>
#include <scrubjay/robot/laser_scan.hpp>
#include <scrubjay/robot/robot_model.hpp>
#include <span>

namespace scrubjay {

/// Clear ways from where the robot stood when the scan arrived, by bearing in its frame.
class ScanOutlook {
 public:
  static constexpr int kBearings = 72;  ///< evenly around the robot, the first one straight ahead

  /// Nothing is clear.
  ScanOutlook() { clear_.fill(0.0); }
  /// For a disc of `radius` [m] around the robot's origin, while the robot moves with `twist`: a beam that was measured
  /// before `arrival` [s] started from where the robot was then. What is inside of the disc blocks the ways towards it
  /// alone. A beam without a return limits its own direction to LidarModel::clear_range.
  ScanOutlook(const LaserScan& scan, const LidarModel& lidar, const Twist2& twist, double arrival, double radius);

  static double bearing(int i) { return wrap_angle(2.0 * kPi / kBearings * i); }
  double clear(int i) const { return clear_[static_cast<std::size_t>(i)]; }
  /// How far the way in a direction [rad] is clear [m]: the less of the two bearings beside it.
  double clear_along(double direction) const;
  /// The clearest way of all [m].
  double farthest() const;

 private:
  void block(const Point2& point, double radius, std::span<const Point2> directions);

  std::array<double, kBearings> clear_;
};

}  // namespace scrubjay
