/// \file
/// A room that a lidar sees exactly, or with noise.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <scrubjay/geometry/bounds.hpp>
#include <scrubjay/geometry/random.hpp>
#include <scrubjay/geometry/segment2.hpp>
#include <scrubjay/mapping/lidar_mapper.hpp>
#include <vector>

namespace scrubjay::test {

/// A lidar in the robot's middle; a beam without a return is clear up to 3 m.
inline RobotModel lidar_robot() {
  RobotModel robot;
  robot.lidar.emplace();
  robot.lidar->mount = {};
  robot.lidar->clear_range = 3.0;
  return robot;
}

inline PoseEstimate at(const Pose2& pose, const Twist2& twist = {}) {
  PoseEstimate estimate;
  estimate.pose = pose;
  estimate.twist = twist;
  return estimate;
}

/// The same scan again and again.
class Scans {
 public:
  explicit Scans(std::vector<float> ranges, double increment = 0.0, double range_max = 3.5)
      : ranges_(std::move(ranges)), increment_(increment), range_max_(range_max) {}

  Frame next() const {
    Frame frame;
    LaserScan& scan = frame.scan.emplace();
    scan.angle_increment = increment_;
    scan.range_min = 0.12;
    scan.range_max = range_max_;
    scan.ranges = ranges_;
    return frame;
  }

 private:
  std::vector<float> ranges_;
  double increment_;
  double range_max_;
};

/// From (-2.01, -1.51) to (2.02, 1.52), and a box in it if there is one.
class Room {
 public:
  static constexpr double kLeft = -2.01, kBottom = -1.51, kRight = 2.02, kTop = 1.52;

  std::optional<Bounds2> box;

  RobotModel robot() const { return lidar_robot(); }
  /// How far `p` is from the nearest wall; less than 0 outside.
  double clearance(const Point2& p) const {
    return std::min({p.x() - kLeft, kRight - p.x(), p.y() - kBottom, kTop - p.y()});
  }
  std::vector<Point2> points_on_walls(double step) const {
    std::vector<Point2> points;
    for (double x = kLeft + 0.01; x < kRight; x += step)
      points.insert(points.end(), {{x, kBottom - 1e-3}, {x, kTop + 1e-3}});
    for (double y = kBottom + 0.01; y < kTop; y += step)
      points.insert(points.end(), {{kLeft - 1e-3, y}, {kRight + 1e-3, y}});
    return points;
  }

  /// What the robot sees there; valid until the next one.
  Frame frame(const Pose2& pose, double noise = 0.0, Random* random = nullptr) const {
    ranges_.clear();
    for (int i = 0; i < kBeams; ++i) {
      const double range = cast(pose.position(), direction(pose.yaw + radians(i)));
      ranges_.push_back(static_cast<float>(random != nullptr ? range * (1.0 + noise * random->normal()) : range));
    }
    return frame_of(0.0);
  }
  void scan(LidarMapper& mapper, const Pose2& pose, double noise = 0.0, Random* random = nullptr) const {
    mapper.update(frame(pose, noise, random), at(pose));
  }
  /// A turn of 0.2 s that ends at `pose`; `told` is what the mapper believes of the robot's speed.
  void scan_while_moving(LidarMapper& mapper, const Pose2& pose, const Twist2& turning, const Twist2& told) const {
    constexpr double kTimeIncrement = 0.2 / kBeams;
    ranges_.clear();
    for (int i = 0; i < kBeams; ++i) {
      const double yaw = pose.yaw - turning.angular * (kBeams - 1 - i) * kTimeIncrement;
      ranges_.push_back(static_cast<float>(cast(pose.position(), direction(yaw + radians(i)))));
    }
    mapper.update(frame_of(kTimeIncrement), at(pose, told));
  }
  /// Once across, turning.
  void drive(LidarMapper& mapper) const {
    for (int i = 0; i < 40; ++i) scan(mapper, {-1.6 + 0.08 * i, 0.03 * i - 0.5, 0.05 * i});
  }

 private:
  static constexpr int kBeams = 360;

  Frame frame_of(double time_increment) const {
    Frame frame;
    LaserScan& scan = frame.scan.emplace();
    scan.stamp = -(kBeams - 1) * time_increment;
    scan.angle_increment = radians(1.0);
    scan.time_increment = time_increment;
    scan.range_min = 0.02;
    scan.range_max = 10.0;
    scan.ranges = ranges_;
    return frame;
  }

  double cast(const Point2& from, const Point2& beam) const {
    double range = std::numeric_limits<double>::infinity();
    const auto meet = [&](const Bounds2& b) {
      const Point2 corners[] = {b.low, {b.high.x(), b.low.y()}, b.high, {b.low.x(), b.high.y()}};
      for (std::size_t i = 0; i < 4; ++i)
        range = std::min(range, ray_hit({corners[i], corners[(i + 1) % 4]}, from, beam));
    };
    meet({{kLeft, kBottom}, {kRight, kTop}});
    if (box) meet(*box);
    return range;
  }

  mutable std::vector<float> ranges_;
};

}  // namespace scrubjay::test
