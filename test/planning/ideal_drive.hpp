/// \file
/// A differential drive that does as told, as fast as its motors allow.
#pragma once

#include <algorithm>
#include <cmath>
#include <scrubjay/odometry/arc.hpp>
#include <scrubjay/robot/motion.hpp>
#include <scrubjay/robot/robot_model.hpp>

namespace scrubjay::test {

/// As urdf/turtlebot3_burger.* has it.
inline RobotModel burger() {
  RobotModel robot;
  robot.open_interface = false;
  robot.radius = 0.105;
  robot.drive.wheel_separation = 0.160;
  robot.max_linear_speed = 0.22;
  robot.max_angular_speed = 2.84;
  robot.max_wheel_speed = 0.2272;
  robot.has_light_sensors = false;
  return robot;
}

inline RobotModel roomba() {
  return {};
}

class IdealDrive {
 public:
  static constexpr double kTick = 0.015;  // [s]

  IdealDrive(const RobotModel& robot, const Pose2& pose)
      : drive_(robot.drive),
        acceleration_(robot.open_interface ? 0.4 : 1.0),
        braking_(robot.open_interface ? 0.3 : 1.0),
        pose_(pose) {}

  void drive(const Motion& motion) {
    const double across = 0.5 * motion.angular * drive_.wheel_separation;
    left_ = approach(left_, motion.linear - across);
    right_ = approach(right_, motion.linear + across);
    const Arc arc = arc_of({left_ * kTick, right_ * kTick}, drive_);
    const Point2 step = chord(arc) * direction(pose_.yaw + 0.5 * arc.turn);
    pose_ = {pose_.x + step.x(), pose_.y + step.y(), wrap_angle(pose_.yaw + arc.turn)};
    stamp_ += kTick;
  }
  /// A tick in which something holds it.
  void stand_still() {
    left_ = right_ = 0.0;
    stamp_ += kTick;
  }
  const Pose2& pose() const { return pose_; }
  double stamp() const { return stamp_; }

 private:
  double approach(double speed, double wanted) const {
    const bool faster = wanted * speed >= 0.0 && std::fabs(wanted) > std::fabs(speed);
    const double limit = (faster ? acceleration_ : braking_) * kTick;
    return speed + std::clamp(wanted - speed, -limit, limit);
  }

  DifferentialDrive drive_;
  double acceleration_, braking_;  // of a wheel [m/s^2]
  Pose2 pose_;
  double left_ = 0.0, right_ = 0.0;  // [m/s]
  double stamp_ = 0.0;
};

}  // namespace scrubjay::test
