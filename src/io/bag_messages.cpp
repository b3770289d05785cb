#include "bag_messages.hpp"

#include <algorithm>
#include <cmath>
#include <scrubjay/io/recording.hpp>
#include <scrubjay/io/world_reader.hpp>

#include "transform_tree.hpp"

namespace scrubjay {
namespace {

constexpr double kFar = 1e6;          // [m]
constexpr double kLongestScan = 2.0;  // what claims to take longer is taken for one moment [s]

std::optional<Pose2> in_world(const std::optional<Pose2>& pose) {
  if (!pose || std::fabs(pose->x) > kWorldExtent || std::fabs(pose->y) > kWorldExtent) return std::nullopt;
  return pose;
}

/// Between two beams [rad]. A whole turn's is known better than a float tells it.
double increment_of(const ros::LaserScan& scan) {
  const double told = static_cast<double>(scan.angle_increment);
  const double whole = std::copysign(2.0 * kPi / static_cast<double>(scan.ranges.size()), told);
  return static_cast<float>(whole) == scan.angle_increment ? whole : told;
}

double time_increment_of(const ros::LaserScan& scan) {
  const double told = static_cast<double>(scan.time_increment);
  const double whole = told * static_cast<double>(scan.ranges.size());
  return told > 0.0 && whole <= kLongestScan ? told : 0.0;
}

std::uint8_t flags_of(std::initializer_list<bool> set) {
  unsigned flags = 0;
  unsigned bit = 1;
  for (const bool is_set : set) {
    if (is_set) flags |= bit;
    bit <<= 1;
  }
  return static_cast<std::uint8_t>(flags);
}

}  // namespace

std::int64_t stamp_of(const ros::Header& header, const BagMessage& message) {
  constexpr std::int64_t kLatest = 4'000'000'000'000'000'000;  // so that differences fit, too; a header's is earlier
  if (header.stamp != ros::Time{}) return ros::to_nanoseconds(header.stamp);
  return std::clamp(message.nanoseconds, -kLatest, kLatest);
}

std::optional<Pose2> pose_of(const ros::Odometry& odometry) {
  return in_world(in_plane(odometry.pose.pose.position, odometry.pose.pose.orientation));
}

std::optional<Pose2> pose_of(const ros::TransformStamped& transform) {
  const ros::Vector3& t = transform.transform.translation;
  return in_world(in_plane({t.x, t.y, t.z}, transform.transform.rotation));
}

bool is_sound(const ros::LaserScan& scan) {
  constexpr float kMostTurned = 1e3F;  // [rad]
  const float step = std::fabs(scan.angle_increment);
  return scan.ranges.size() >= 2 && std::fabs(scan.angle_min) <= kMostTurned && step > 0.0F && step <= 3.2F &&
         scan.range_min >= 0.0F && scan.range_max > scan.range_min;
}

LidarModel lidar_of(const ros::LaserScan& scan) {
  LidarModel lidar;
  lidar.mount = {};
  lidar.beams = static_cast<int>(scan.ranges.size());
  lidar.angle_min = static_cast<double>(scan.angle_min);
  lidar.angle_increment = increment_of(scan);
  lidar.scan_time = scan.scan_time > 0.0F && scan.scan_time < 100.0F ? static_cast<double>(scan.scan_time) : 0.0;
  lidar.min_range = static_cast<double>(scan.range_min);
  lidar.max_range = std::min(static_cast<double>(scan.range_max), kFar);
  // No data sheet: good to 1 or 2 cm, far and near, as most are.
  lidar.clear_range = 0.0;
  lidar.noise = 0.02;
  lidar.noise_per_range = 0.0;
  return lidar;
}

TimedScan scan_of(ros::LaserScan scan, std::int64_t nanoseconds, bool upside_down) {
  const double turning = upside_down ? -1.0 : 1.0;
  const double time_increment = time_increment_of(scan);
  TimedScan timed;
  timed.shape.stamp = stamp_from_nanoseconds(nanoseconds);
  timed.shape.angle_min = turning * static_cast<double>(scan.angle_min);
  timed.shape.angle_increment = turning * increment_of(scan);
  timed.shape.time_increment = time_increment;
  timed.shape.range_min = static_cast<double>(scan.range_min);
  timed.shape.range_max = std::min(static_cast<double>(scan.range_max), kFar);
  const double duration = time_increment * static_cast<double>(scan.ranges.size() - 1);
  timed.end = nanoseconds + std::llround(duration * 1e9);
  timed.ranges = std::move(scan.ranges);
  return timed;
}

BumperState bumper_of(const ros::Bumper& bumper) {
  return {bumper.is_left_pressed,
          bumper.is_right_pressed,
          flags_of({bumper.is_light_left, bumper.is_light_front_left, bumper.is_light_center_left,
                    bumper.is_light_center_right, bumper.is_light_front_right, bumper.is_light_right}),
          {bumper.light_signal_left, bumper.light_signal_front_left, bumper.light_signal_center_left,
           bumper.light_signal_center_right, bumper.light_signal_front_right, bumper.light_signal_right}};
}

CliffState cliff_of(const ros::Cliff& cliff) {
  return {flags_of({cliff.is_cliff_left, cliff.is_cliff_front_left, cliff.is_cliff_front_right, cliff.is_cliff_right})};
}

}  // namespace scrubjay
