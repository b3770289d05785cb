/// \file
/// A lidar robot among straight walls, for tests: scans worked out exactly, noise on request.
#pragma once

#include <algorithm>
#include <limits>
#include <scrubjay/geometry/random.hpp>
#include <scrubjay/geometry/segment2.hpp>
#include <scrubjay/localization/localizer.hpp>
#include <scrubjay/mapping/lidar_mapper.hpp>
#include <vector>

namespace scrubjay {

inline RobotModel lidar_robot() {
  RobotModel robot;
  robot.open_interface = false;
  robot.radius = 0.105;
  robot.drive = {0.160, 0.033, 4096.0};
  robot.lidar = LidarModel{};
  return robot;
}

using Walls = std::vector<Segment2>;

/// A room of 5 x 4 m with a niche, a pillar, and the origin inside.
inline Walls room_walls() {
  return {{{-2.03, -1.51}, {2.97, -1.51}}, {{2.97, -1.51}, {2.97, 2.49}},   {{2.97, 2.49}, {0.5, 2.49}},
          {{0.5, 2.49}, {0.5, 2.0}},       {{0.5, 2.0}, {-0.4, 2.0}},       {{-0.4, 2.0}, {-0.4, 2.49}},
          {{-0.4, 2.49}, {-2.03, 2.49}},   {{-2.03, 2.49}, {-2.03, -1.51}}, {{1.4, -0.6}, {1.8, -0.6}},
          {{1.8, -0.6}, {1.8, -0.2}},      {{1.8, -0.2}, {1.4, -0.2}},      {{1.4, -0.2}, {1.4, -0.6}}};
}

/// Two bare walls, 1.6 m apart, that go on beyond all range.
inline Walls corridor_walls() {
  return {{{-50.0, -0.8}, {50.0, -0.8}}, {{-50.0, 0.8}, {50.0, 0.8}}};
}

/// Distance from `origin` along the unit vector `way` to the nearest wall; infinity if there is none.
inline double distance_to_wall(const Walls& walls, const Point2& origin, const Point2& way) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Segment2& wall : walls) nearest = std::min(nearest, ray_hit(wall, origin, way));
  return nearest;
}

/// Drives a robot along true poses, with a localizer and a mapper that work on what it senses.
class LidarDrive {
 public:
  LidarDrive(Walls walls, Localizer& localizer, Mapper& mapper, double noise = 0.0)
      : walls_(std::move(walls)), localizer_(localizer), mapper_(mapper), noise_(noise) {}

  /// The robot is at `truth` (in the map's frame), and its odometry says that it is at `odometry`, in its own.
  PoseEstimate go(const Pose2& truth, const Pose2& odometry, bool scan = true) {
    Frame frame;
    frame.stamp = stamp_ += 0.2;
    frame.odometry = odometry;
    if (scan) frame.scan = scan_at(truth);
    const PoseEstimate estimate = localizer_.update(frame);
    mapper_.update(frame, estimate);
    return estimate;
  }

  LaserScan scan_at(const Pose2& truth) {
    const Pose2 sensor = truth * lidar_.mount;
    ranges_.clear();
    for (int i = 0; i < lidar_.beams; ++i) {
      const Point2 way = direction(sensor.yaw + i * lidar_.angle_increment);
      const double range = distance_to_wall(walls_, sensor.position(), way) + noise_ * random_.normal();
      ranges_.push_back(range <= lidar_.max_range ? static_cast<float>(range) : std::numeric_limits<float>::infinity());
    }
    return {.stamp = stamp_,
            .angle_increment = lidar_.angle_increment,
            .range_min = lidar_.min_range,
            .range_max = lidar_.max_range,
            .ranges = ranges_};
  }

  Walls& walls() { return walls_; }
  std::vector<float>& ranges() { return ranges_; }

 private:
  Walls walls_;
  Localizer& localizer_;
  Mapper& mapper_;
  double noise_;
  LidarModel lidar_;
  Random random_{11};
  double stamp_ = 0.0;
  std::vector<float> ranges_;
};

}  // namespace scrubjay
