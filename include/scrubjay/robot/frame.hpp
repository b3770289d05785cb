/// \file
/// What a robot sensed in one tick, whatever robot it is.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <scrubjay/geometry/pose2.hpp>
#include <scrubjay/oi/mode.hpp>
#include <scrubjay/oi/sensor_views.hpp>
#include <scrubjay/robot/laser_scan.hpp>

namespace scrubjay {

inline constexpr int kLightSensorCount = 6;
inline constexpr int kCliffSensorCount = 4;

/// Order of light signals, as in the Open Interface: left to right across the bumper.
enum class LightSensor : std::uint8_t { Left, FrontLeft, CenterLeft, CenterRight, FrontRight, Right };
/// Order of cliff sensors, as in the Open Interface.
enum class CliffSensor : std::uint8_t { Left, FrontLeft, FrontRight, Right };

struct Battery {
  double voltage = 0.0;      ///< [V]
  double current = 0.0;      ///< positive while charging [A]
  double charge = 0.0;       ///< [Ah]
  double capacity = 0.0;     ///< [Ah]
  double temperature = 0.0;  ///< [deg C]
  bool charging = false;
  oi::ChargingState charger = oi::ChargingState::NotCharging;  ///< what it does, from a robot that tells
};

/// All that the robot sensed in one tick (15 ms on the Open Interface, 20 ms on a TurtleBot3).
struct Frame {
  double stamp = 0.0;         ///< time of arrival [s]; starts at the robot's first frame or the channel's clock
  double left_travel = 0.0;   ///< rolled by the left wheel since the frame before [m]
  double right_travel = 0.0;  ///< rolled by the right wheel since the frame before [m]
  bool bump_left = false;
  bool bump_right = false;
  bool wheel_drop_left = false;
  bool wheel_drop_right = false;
  std::uint8_t light_flags = 0;                                 ///< bit i: LightSensor i sees something
  std::array<std::uint16_t, kLightSensorCount> light_signal{};  ///< 0 to 4095, grows as things come near
  std::uint8_t cliff_flags = 0;                                 ///< bit i: CliffSensor i sees no floor
  bool wall = false;                                            ///< wall sensor, right side
  std::uint16_t wall_signal = 0;
  bool virtual_wall = false;
  std::uint8_t infrared_omni = 0;  ///< infrared characters, as in the OI specification; 0 is none
  std::uint8_t infrared_left = 0;
  std::uint8_t infrared_right = 0;
  std::uint8_t dirt = 0;  ///< dirt detector's level
  oi::OiMode mode = oi::OiMode::Off;
  Battery battery;
  /// The robot's own odometry: its pose in its `odom` frame, from a robot that tells that instead of wheel travel.
  std::optional<Pose2> odometry;
  /// A scan that was complete by this frame; its ranges are valid until the robot's next one.
  std::optional<LaserScan> scan;

  bool bumped() const { return bump_left || bump_right; }
  bool wheel_dropped() const { return wheel_drop_left || wheel_drop_right; }
  bool sees(LightSensor sensor) const { return (light_flags >> static_cast<int>(sensor) & 1) != 0; }
};

}  // namespace scrubjay
