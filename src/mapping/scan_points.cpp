#include <algorithm>
#include <cmath>
#include <limits>
#include <scrubjay/error.hpp>
#include <scrubjay/mapping/scan_points.hpp>

namespace scrubjay {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The pose after moving at constant `twist` for `time` [s], in the frame of the start: an arc.
Pose2 motion(const Twist2& twist, double time) {
  const double turn = twist.angular * time;
  // Chord over arc and the chord's slant, by half the turn; without dividing by a small angle.
  const double half = 0.5 * turn;
  const SinCos middle = sin_cos(half);
  const double chord = std::fabs(half) > 1e-4 ? middle.sin / half : 1.0 - half * half / 6.0;
  const double forward = chord * twist.linear * time;
  const double left = chord * twist.lateral * time;
  return {middle.cos * forward - middle.sin * left, middle.sin * forward + middle.cos * left, turn};
}

}  // namespace

std::span<const Beam> ScanPoints::beams(const LaserScan& scan, double stamp, const Twist2& twist) {
  learn_bearings(scan);
  beams_.clear();
  places_.clear();
  const Point2 origin = lidar_.mount.position();
  const double clear_range = std::min(lidar_.clear_range, params_.max_range);
  for (const Bearing& bearing : bearings_) {
    const double range = static_cast<double>(scan.ranges[bearing.beam]);
    double length = range + params_.hit_depth;
    bool hit = true;
    if (range > scan.range_max || range == kInfinity || range == 0.0) {
      length = clear_range;
      hit = false;
    } else if (range > params_.max_range) {
      length = params_.max_range;
      hit = false;
    } else if (!(range >= scan.range_min)) {
      continue;
    }
    if (!(length > 0.0)) continue;
    beams_.push_back({origin, origin + length * bearing.direction, hit});
    places_.push_back(bearing.beam);
  }
  const bool moved = twist.linear != 0.0 || twist.lateral != 0.0 || twist.angular != 0.0;
  if (scan.time_increment != 0.0 && moved) deskew(scan, stamp, twist);
  return beams_;
}

void ScanPoints::learn_bearings(const LaserScan& scan) {
  const std::size_t count = scan.ranges.size();
  if (count == count_ && scan.angle_min == angle_min_ && scan.angle_increment == angle_increment_) return;
  count_ = count;
  angle_min_ = scan.angle_min;
  angle_increment_ = scan.angle_increment;
  bearings_.clear();
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = scan.angle_min + static_cast<double>(i) * scan.angle_increment + lidar_.mount.yaw;
    if (std::fabs(wrap_angle(angle)) > params_.forward_cone) continue;
    bearings_.push_back({i, direction(angle)});
  }
}

void ScanPoints::deskew(const LaserScan& scan, double stamp, const Twist2& twist) {
  for (std::size_t i = 0; i < beams_.size(); ++i) {
    const double time = scan.stamp + static_cast<double>(places_[i]) * scan.time_increment - stamp;
    const Pose2 robot = motion(twist, time);  // then, seen from the frame's time
    Beam& beam = beams_[i];
    beam.origin = robot * beam.origin;
    beam.end = robot * beam.end;
    if (!std::isfinite(beam.end.x() + beam.end.y())) {
      throw Error("a scan can't be put right for a robot that moved at (" + std::to_string(twist.linear) + " m/s, " +
                      std::to_string(twist.angular) + " rad/s): the twist estimate has gone astray",
                  Error::Kind::Failure);
    }
  }
}

}  // namespace scrubjay
