/// \file
/// What the core must know of a robot's body. Defaults: Roomba 600 / Create 2.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <scrubjay/geometry/pose2.hpp>
#include <scrubjay/odometry/differential_drive.hpp>
#include <scrubjay/oi/model.hpp>
#include <scrubjay/robot/frame.hpp>

namespace scrubjay {

/// An infrared light sensor in the bumper: signal = gain * exp(-attenuation * range) + ambient.
/// The curve is create3_sim's (the maker's own for Create 3); bearings for six sensors are our guess.
struct LightSensorModel {
  std::array<Pose2, kLightSensorCount> mount{
      // On a circle of 154 mm at +-65, +-37.5 and +-12.5 degrees, looking outwards.
      Pose2{0.154 * 0.42261826174069943, 0.154 * 0.90630778703664994, radians(65.0)},
      Pose2{0.154 * 0.79335334029123517, 0.154 * 0.60876142900872066, radians(37.5)},
      Pose2{0.154 * 0.97629600711993336, 0.154 * 0.21643961393810290, radians(12.5)},
      Pose2{0.154 * 0.97629600711993336, -0.154 * 0.21643961393810290, radians(-12.5)},
      Pose2{0.154 * 0.79335334029123517, -0.154 * 0.60876142900872066, radians(-37.5)},
      Pose2{0.154 * 0.42261826174069943, -0.154 * 0.90630778703664994, radians(-65.0)}};
  double gain = 3500.0;                   ///< signal at range 0 from a white surface seen square on
  double attenuation = 26.83;             ///< [1/m]
  double ambient = 30.0;                  ///< signal when nothing is near
  double max_range = 0.2;                 ///< useful range [m]
  double beam_half_angle = radians(7.0);  ///< [rad]

  /// Range that a signal implies for a surface of average albedo; max_range or more when it says nothing.
  double range(std::uint16_t signal) const {
    const double above = signal - ambient;
    if (above <= 0.0) return 10.0 * max_range;
    return above >= gain ? 0.0 : log(gain / above) / attenuation;
  }
};

/// Which part of the bumper closes for a contact at which bearing (create_autonomy).
struct BumperModel {
  double half_from = radians(-30.0);  ///< the left half closes from here ... [rad]
  double half_to = radians(90.0);     ///< ... to here; the right half is its mirror image [rad]
};

/// A lidar that turns. Defaults: LDS-01 on a TurtleBot3 Burger (ROBOTIS, data sheet and URDF).
struct LidarModel {
  Pose2 mount{-0.032, 0.0, 0.0};          ///< of the sensor on the robot
  int beams = 360;                        ///< a turn
  double angle_min = 0.0;                 ///< bearing of the first beam [rad]
  double angle_increment = radians(1.0);  ///< to the next one, counter-clockwise [rad]
  double scan_time = 0.2;                 ///< of a turn [s]
  double min_range = 0.12;                ///< [m]
  double max_range = 3.5;                 ///< [m]
  double clear_range = 3.5;               ///< a beam without a return is clear up to here [m]; 0: it says nothing
  double near_accuracy = 0.015;           ///< largest error of a range below 0.5 m [m]
  double accuracy = 0.05;                 ///< the same from there on, as a share of the range
  /// How ranges err, for those who weigh them: standard deviation [m], and what it grows by with the range [m/m].
  /// Three of them are the accuracy above.
  double noise = 0.005;
  double noise_per_range = 0.0167;
};

struct RobotModel {
  /// Speaks iRobot's Open Interface; a robot that doesn't gives frames by itself, and has no bumper.
  bool open_interface = true;
  oi::Model protocol = oi::Model::Create2;  ///< the dialect of the Open Interface that it speaks
  double radius = 0.1735;                   ///< of the disc [m]
  DifferentialDrive drive;
  double max_wheel_speed = 0.5;      ///< [m/s]
  double max_linear_speed = 0.5;     ///< of the base [m/s]
  double max_angular_speed = 4.255;  ///< of the base: both wheels at full speed, against each other [rad/s]
  LightSensorModel light;
  BumperModel bumper;
  /// Left, front left, front right, right (create_autonomy) [m].
  std::array<Point2, kCliffSensorCount> cliff_sensors{Point2(0.07, 0.14), Point2(0.15, 0.04), Point2(0.15, -0.04),
                                                      Point2(0.07, -0.14)};
  bool has_light_sensors = true;
  std::optional<LidarModel> lidar;
};

}  // namespace scrubjay
