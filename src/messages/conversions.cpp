#include <algorithm>
#include <cmath>
#include <limits>
#include <scrubjay/messages/conversions.hpp>

namespace scrubjay::ros {
namespace {

constexpr float kNotMeasured = std::numeric_limits<float>::quiet_NaN();

/// Rows and columns of x, y and yaw in a matrix of six.
constexpr std::array<std::size_t, 3> kPlane{0, 1, 5};

std::array<double, 36> covariance_message(const Eigen::Matrix3d& covariance) {
  std::array<double, 36> all{};
  for (std::size_t row = 0; row < kPlane.size(); ++row) {
    for (std::size_t column = 0; column < kPlane.size(); ++column) {
      all[6 * kPlane[row] + kPlane[column]] =
          covariance(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column));
    }
  }
  return all;
}

std::vector<std::int8_t> trinary_cells(GridView<const LogOdds> map, const CellRect& cells) {
  const std::int32_t width = cells.high.x - cells.low.x;
  std::vector<std::int8_t> values(static_cast<std::size_t>(width) *
                                  static_cast<std::size_t>(cells.high.y - cells.low.y));
  auto to = values.begin();
  for (std::int32_t y = cells.low.y; y < cells.high.y; ++y) {
    const LogOdds* row = &map[{cells.low.x, y}];
    to = std::transform(row, row + width, to, trinary);
  }
  return values;
}

}  // namespace

Quaternion quaternion(double yaw) {
  const SinCos half = sin_cos(0.5 * yaw);
  return {0.0, 0.0, half.sin, half.cos};
}

double yaw_of(const Quaternion& q) {
  return atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z));
}

Pose pose_message(const Pose2& pose) {
  return {{pose.x, pose.y, 0.0}, quaternion(pose.yaw)};
}

Pose2 pose_of(const Pose& pose) {
  return {pose.position.x, pose.position.y, yaw_of(pose.orientation)};
}

Transform transform_message(const Pose2& pose) {
  return {{pose.x, pose.y, 0.0}, quaternion(pose.yaw)};
}

Pose2 pose_of(const Transform& transform) {
  return {transform.translation.x, transform.translation.y, yaw_of(transform.rotation)};
}

TransformStamped transform_stamped(const Header& header, const std::string& child, const Pose2& pose) {
  return {header, child, transform_message(pose)};
}

Odometry odometry_message(const Header& header, const std::string& child, const PoseEstimate& estimate) {
  Odometry message{header, child, {}, {}};
  message.pose = {pose_message(estimate.pose), covariance_message(estimate.covariance)};
  message.twist.twist = {{estimate.twist.linear, estimate.twist.lateral, 0.0}, {0.0, 0.0, estimate.twist.angular}};
  message.twist.covariance = covariance_message(estimate.twist_covariance);
  return message;
}

LaserScan scan_message(const Header& header, const scrubjay::LaserScan& scan) {
  const auto beams = static_cast<double>(scan.ranges.size());
  LaserScan message;
  message.header = header;
  message.angle_min = static_cast<float>(scan.angle_min);
  message.angle_max = static_cast<float>(scan.angle_min + (beams - 1.0) * scan.angle_increment);
  message.angle_increment = static_cast<float>(scan.angle_increment);
  message.time_increment = static_cast<float>(scan.time_increment);
  message.scan_time = static_cast<float>(scan.time_increment * beams);
  message.range_min = static_cast<float>(scan.range_min);
  message.range_max = static_cast<float>(scan.range_max);
  message.ranges.assign(scan.ranges.begin(), scan.ranges.end());
  return message;
}

Bumper bumper_message(const Header& header, const Frame& frame) {
  const auto& signal = frame.light_signal;
  return {header,
          frame.bump_left,
          frame.bump_right,
          frame.sees(LightSensor::Left),
          frame.sees(LightSensor::FrontLeft),
          frame.sees(LightSensor::CenterLeft),
          frame.sees(LightSensor::CenterRight),
          frame.sees(LightSensor::FrontRight),
          frame.sees(LightSensor::Right),
          signal[0],
          signal[1],
          signal[2],
          signal[3],
          signal[4],
          signal[5]};
}

Cliff cliff_message(const Header& header, const Frame& frame) {
  const auto sees = [&](CliffSensor sensor) { return (frame.cliff_flags >> static_cast<int>(sensor) & 1) != 0; };
  Cliff message{header};
  message.is_cliff_left = sees(CliffSensor::Left);
  message.is_cliff_front_left = sees(CliffSensor::FrontLeft);
  message.is_cliff_front_right = sees(CliffSensor::FrontRight);
  message.is_cliff_right = sees(CliffSensor::Right);
  return message;
}

BatteryState battery_message(const Header& header, const Battery& battery) {
  BatteryState message;
  message.header = header;
  message.voltage = static_cast<float>(battery.voltage);
  message.temperature = static_cast<float>(battery.temperature);
  message.current = static_cast<float>(battery.current);
  message.charge = static_cast<float>(battery.charge);
  message.capacity = static_cast<float>(battery.capacity);
  message.design_capacity = kNotMeasured;
  message.percentage = battery.capacity > 0.0 ? static_cast<float>(battery.charge / battery.capacity) : kNotMeasured;
  message.power_supply_status = battery.charging        ? BatteryState::kStatusCharging
                                : battery.current < 0.0 ? BatteryState::kStatusDischarging
                                                        : BatteryState::kStatusNotCharging;
  message.power_supply_technology = BatteryState::kTechnologyNimh;
  message.present = battery.voltage > 0.0;
  return message;
}

OccupancyGrid map_message(const Header& header, GridView<const LogOdds> map, const CellRect& cells) {
  const GridGeometry& grid = map.geometry;
  OccupancyGrid message;
  message.header = header;
  message.info.map_load_time = header.stamp;
  message.info.resolution = static_cast<float>(grid.resolution);
  message.info.width = static_cast<std::uint32_t>(cells.high.x - cells.low.x);
  message.info.height = static_cast<std::uint32_t>(cells.high.y - cells.low.y);
  message.info.origin = pose_message(
      {grid.origin.x() + cells.low.x * grid.resolution, grid.origin.y() + cells.low.y * grid.resolution, 0.0});
  message.data = trinary_cells(map, cells);
  return message;
}

OccupancyGridUpdate map_update_message(const Header& header, GridView<const LogOdds> map, const CellRect& published,
                                       const CellRect& cells) {
  return {header,
          cells.low.x - published.low.x,
          cells.low.y - published.low.y,
          static_cast<std::uint32_t>(cells.high.x - cells.low.x),
          static_cast<std::uint32_t>(cells.high.y - cells.low.y),
          trinary_cells(map, cells)};
}

Path path_message(const Header& header, std::span<const Point2> points) {
  Path message{header, {}};
  for (std::size_t i = 0; i < points.size(); ++i) {
    // Each looks at the next one, and the last one where it came from the one before it.
    const std::size_t from = i + 1 < points.size() || i == 0 ? i : i - 1;
    const std::size_t to = std::min(from + 1, points.size() - 1);
    const Point2 way = points[to] - points[from];
    const double yaw = way.squaredNorm() > 0.0 ? atan2(way.y(), way.x()) : 0.0;
    message.poses.push_back({header, pose_message({points[i].x(), points[i].y(), yaw})});
  }
  return message;
}

Path path_message(const Header& header, std::span<const Pose2> poses) {
  Path message{header, {}};
  for (const Pose2& pose : poses) message.poses.push_back({header, pose_message(pose)});
  return message;
}

MarkerArray points_message(const Header& header, std::string_view name, std::span<const Point2> points, double size) {
  Marker marker;
  marker.header = header;
  marker.ns = name;
  marker.type = Marker::kPoints;
  marker.action = points.empty() ? Marker::kDelete : Marker::kAdd;
  marker.pose.orientation.w = 1.0;
  marker.scale = {size, size, 0.0};
  marker.color = {0.2F, 0.6F, 1.0F, 1.0F};
  for (const Point2& p : points) marker.points.push_back({p.x(), p.y(), 0.0});
  return {{marker}};
}

}  // namespace scrubjay::ros
