/// \file
/// One turn of a lidar.
#pragma once

#include <optional>
#include <span>

namespace scrubjay {

/// As sensor_msgs/LaserScan, over somebody else's ranges. The sensor's pose on the robot is in RobotModel::lidar.
struct LaserScan {
  double stamp = 0.0;             ///< of the first beam [s]; the last beam's is that of the frame which brings the scan
  double angle_min = 0.0;         ///< bearing of the first beam in the sensor's frame [rad]
  double angle_increment = 0.0;   ///< to the next one, counter-clockwise [rad]
  double time_increment = 0.0;    ///< between two beams [s]; 0: all were measured at once, when the frame arrived
  double range_min = 0.0;         ///< what is nearer isn't measured [m]
  double range_max = 0.0;         ///< what is farther isn't measured [m]
  std::span<const float> ranges;  ///< [m]; anything outside of [range_min, range_max], or NaN, is no reading

  bool returned(float range) const { return range >= range_min && range <= range_max; }
  /// How far the obstacle is that a beam met, if it met one. What is too near to be measured, which REP-117 writes as
  /// minus infinity, is taken to be at range_min. Zero is no obstacle: drivers write it where nothing came back.
  std::optional<double> obstacle(float range) const {
    if (returned(range)) return range;
    if (range < range_min && range != 0.0f) return range_min;
    return std::nullopt;
  }
};

}  // namespace scrubjay
