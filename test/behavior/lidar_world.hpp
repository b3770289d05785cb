/// \file
/// A disc with a lidar among straight walls: motion and rays, nothing else.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <scrubjay/behavior/behavior.hpp>
#include <scrubjay/geometry/random.hpp>
#include <scrubjay/geometry/segment2.hpp>
#include <scrubjay/robot/robot_model.hpp>
#include <utility>
#include <vector>

namespace scrubjay::test {

/// A TurtleBot3 Burger, by its data sheet.
inline RobotModel burger() {
  RobotModel robot;
  robot.open_interface = false;
  robot.radius = 0.105;
  robot.drive.wheel_separation = 0.160;
  robot.max_linear_speed = 0.22;
  robot.max_angular_speed = 2.84;
  robot.has_light_sensors = false;
  robot.lidar = LidarModel{};
  return robot;
}

/// The four sides of a rectangle.
inline std::vector<Segment2> box_segments(const Point2& low, const Point2& high) {
  const Point2 right{high.x(), low.y()};
  const Point2 left{low.x(), high.y()};
  return {{low, right}, {right, high}, {high, left}, {left, low}};
}

/// 50 frames a second. Wheels speed up and brake; each beam is measured at its own time, with an error.
class LidarWorld {
 public:
  static constexpr double kTick = 0.02;

  LidarWorld(std::vector<Segment2> walls, const Pose2& start, std::uint64_t seed, double range_error = 0.01)
      : walls_(std::move(walls)), random_(seed), range_error_(range_error) {
    estimate_.pose = start;
    ranges_.resize(static_cast<std::size_t>(robot_.lidar->beams));
    filling_.resize(ranges_.size());
  }

  /// One tick of a behavior that needs no map.
  Decision step(Behavior& behavior) {
    const Frame& frame = sense();
    const Decision decision = behavior.decide({frame, estimate(), {}, {}});
    move(decision.motion);
    return decision;
  }
  /// What it senses at the next tick; good until then.
  const Frame& sense() {
    frame_ = Frame{};
    frame_.stamp = kTick * static_cast<double>(ticks_++);
    frame_.bump_left = bump_;
    frame_.bump_right = bump_;
    frame_.left_travel = way_ - 0.5 * robot_.drive.wheel_separation * turn_;
    frame_.right_travel = way_ + 0.5 * robot_.drive.wheel_separation * turn_;
    measure();
    return frame_;
  }
  /// The truth.
  const PoseEstimate& estimate() const { return estimate_; }
  /// Drives like this for a tick.
  void move(const Motion& wanted) {
    constexpr double kLinear = 0.5 * kTick;  // [m/s^2] times a tick
    constexpr double kAngular = 5.0 * kTick;
    Twist2& twist = estimate_.twist;
    Pose2& pose = estimate_.pose;
    twist.linear += std::clamp(wanted.linear - twist.linear, -kLinear, kLinear);
    twist.angular += std::clamp(wanted.angular - twist.angular, -kAngular, kAngular);
    way_ = twist.linear * kTick;
    turn_ = twist.angular * kTick;
    const Point2 moved = way_ * direction(pose.yaw + 0.5 * turn_);
    pose = {pose.x + moved.x(), pose.y + moved.y(), wrap_angle(pose.yaw + turn_)};
    distance_ += std::fabs(way_);
  }
  void press_bumper(bool pressed) { bump_ = pressed; }
  void put_walls(std::vector<Segment2> walls) { walls_ = std::move(walls); }

  const RobotModel& robot() const { return robot_; }
  const Pose2& pose() const { return estimate_.pose; }
  double distance() const { return distance_; }
  /// Between the disc and the nearest wall; negative when it is in the wall [m].
  double clearance() const {
    double squared = std::numeric_limits<double>::infinity();
    for (const Segment2& wall : walls_) squared = std::min(squared, squared_distance(wall, pose().position()));
    return std::sqrt(squared) - robot_.radius;
  }

 private:
  void measure() {
    const LidarModel& lidar = *robot_.lidar;
    const int per_tick = static_cast<int>(std::lround(lidar.beams * kTick / lidar.scan_time));
    const Pose2 sensor = pose() * lidar.mount;
    for (int i = 0; i < per_tick; ++i, ++beam_) {
      const Point2 ray = direction(sensor.yaw + lidar.angle_min + beam_ * lidar.angle_increment);
      double range = std::numeric_limits<double>::infinity();
      for (const Segment2& wall : walls_) range = std::min(range, ray_hit(wall, sensor.position(), ray));
      range += range_error_ * random_.normal();
      const bool measured = range >= lidar.min_range && range <= lidar.max_range;
      filling_[static_cast<std::size_t>(beam_)] = measured ? static_cast<float>(range) : 0.0f;
    }
    if (beam_ < lidar.beams) return;
    beam_ = 0;
    std::swap(ranges_, filling_);
    LaserScan scan;
    scan.time_increment = lidar.scan_time / lidar.beams;
    scan.stamp = frame_.stamp - lidar.scan_time + kTick;
    scan.angle_min = lidar.angle_min;
    scan.angle_increment = lidar.angle_increment;
    scan.range_min = lidar.min_range;
    scan.range_max = lidar.max_range;
    scan.ranges = ranges_;
    frame_.scan = scan;
  }

  RobotModel robot_ = burger();
  std::vector<Segment2> walls_;
  PoseEstimate estimate_;
  double way_ = 0.0;   // of the last tick [m]
  double turn_ = 0.0;  // [rad]
  Random random_;
  double range_error_;
  Frame frame_;
  std::vector<float> ranges_, filling_;
  int beam_ = 0;
  bool bump_ = false;
  long ticks_ = 0;
  double distance_ = 0.0;
};

}  // namespace scrubjay::test
