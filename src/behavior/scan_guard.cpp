#include <algorithm>
#include <cmath>
#include <limits>
#include <scrubjay/behavior/scan_guard.hpp>

namespace scrubjay {
namespace {

constexpr double kClear = std::numeric_limits<double>::infinity();

}  // namespace

double clear_way(const LaserScan& scan, const Pose2& mount, double radius, bool backwards, double at_most) {
  const double offset = std::sqrt(mount.x * mount.x + mount.y * mount.y);
  double clear = at_most;
  double bearing = scan.angle_min + mount.yaw;
  for (const float range : scan.ranges) {
    const std::optional<double> obstacle = scan.obstacle(range);
    if (obstacle && *obstacle < at_most + radius + offset) {
      const Point2 point = mount.position() + *obstacle * direction(bearing);
      const double along = backwards ? -point.x() : point.x();
      const double half_chord = radius * radius - point.y() * point.y();
      if (along > 0.0 && half_chord > 0.0) clear = std::min(clear, along - std::sqrt(half_chord));
    }
    bearing += scan.angle_increment;
  }
  return clear;
}

ScanGuard::ScanGuard(const RobotModel& robot, const ScanGuardParams& params)
    : mount_(robot.lidar ? robot.lidar->mount : Pose2{}),
      disc_(robot.radius * (1.0 - params.graze)),
      front_(robot.radius - disc_ + params.margin),
      // As far as matters at full speed, and as a robot may get before the next scan.
      sight_(front_ + robot.max_linear_speed * (params.reaction + (robot.lidar ? robot.lidar->scan_time : 0.0))),
      reaction_(params.reaction),
      ahead_(kClear),
      behind_(kClear) {}

void ScanGuard::sense(const Frame& frame) {
  const double rolled = 0.5 * (frame.left_travel + frame.right_travel);
  travel_ += rolled;
  if (!frame.scan) {
    ahead_ -= rolled;
    behind_ += rolled;
    return;
  }
  // Beams that were measured one after the other may be as old as the turn: all the way since may be gone already.
  const double since = frame.scan->time_increment > 0.0 ? travel_ : 0.0;
  ahead_ = clear_way(*frame.scan, mount_, disc_, false, sight_) - std::max(0.0, since);
  behind_ = clear_way(*frame.scan, mount_, disc_, true, sight_) - std::max(0.0, -since);
  travel_ = 0.0;
}

Motion ScanGuard::limit(const Motion& wanted) const {
  const double forwards = std::max(0.0, ahead_ - front_) / reaction_;
  const double backwards = std::max(0.0, behind_ - front_) / reaction_;
  return {std::clamp(wanted.linear, -backwards, forwards), wanted.angular};
}

}  // namespace scrubjay
