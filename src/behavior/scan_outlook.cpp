#include <algorithm>
#include <cmath>
#include <scrubjay/behavior/scan_outlook.hpp>
#include <scrubjay/odometry/arc.hpp>

namespace scrubjay {
namespace {

constexpr double kStep = 2.0 * kPi / ScanOutlook::kBearings;

/// Where a robot was `age` [s] ago, seen from where it is.
Pose2 pose_before(const Twist2& twist, double age) {
  const Arc back{-twist.linear * age, -twist.angular * age};
  const Point2 way = chord(back) * direction(0.5 * back.turn);
  return {way.x(), way.y(), back.turn};
}

std::size_t index_of(double bearing) {
  const int i = static_cast<int>(std::floor(wrap_angle(bearing) / kStep));
  return static_cast<std::size_t>((i + ScanOutlook::kBearings) % ScanOutlook::kBearings);
}

}  // namespace

ScanOutlook::ScanOutlook(const LaserScan& scan, const LidarModel& lidar, const Twist2& twist, double arrival,
                         double radius) {
  clear_.fill(scan.range_max);
  std::array<Point2, kBearings> directions;
  for (int i = 0; i < kBearings; ++i) directions[static_cast<std::size_t>(i)] = direction(kStep * i);
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const double beam = static_cast<double>(i);
    const double age = scan.time_increment > 0.0 ? arrival - (scan.stamp + beam * scan.time_increment) : 0.0;
    const Pose2 sensor = pose_before(twist, age) * lidar.mount;
    const double bearing = sensor.yaw + scan.angle_min + beam * scan.angle_increment;
    if (const std::optional<double> obstacle = scan.obstacle(scan.ranges[i])) {
      block(sensor.position() + *obstacle * direction(bearing), radius, directions);
    } else {
      double& clear = clear_[index_of(bearing + 0.5 * kStep)];
      clear = std::min(clear, std::max(0.0, lidar.clear_range - radius));
    }
  }
}

void ScanOutlook::block(const Point2& point, double radius, std::span<const Point2> directions) {
  const double far = point.squaredNorm();
  const double squared = radius * radius;
  for (std::size_t i = 0; i < clear_.size(); ++i) {
    const double along = point.dot(directions[i]);
    const double half_chord = squared - (far - along * along);
    if (along <= 0.0 || half_chord <= 0.0) continue;
    clear_[i] = std::min(clear_[i], std::max(0.0, along - std::sqrt(half_chord)));
  }
}

double ScanOutlook::clear_along(double direction) const {
  const std::size_t below = index_of(direction);
  return std::min(clear_[below], clear_[(below + 1) % clear_.size()]);
}

double ScanOutlook::farthest() const {
  return *std::max_element(clear_.begin(), clear_.end());
}

}  // namespace scrubjay
