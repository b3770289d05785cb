#include "lidar_sensing.hpp"

#include <algorithm>
#include <cmath>

namespace scrubjay::sim {
namespace {

constexpr float kNothing = std::numeric_limits<float>::infinity();   // REP-117: no return
constexpr float kTooNear = -std::numeric_limits<float>::infinity();  // REP-117: something, nearer than can be measured

/// Where a robot was at `share` of the way from one pose to the other.
Pose2 between(const Pose2& from, const Pose2& to, double share) {
  return {from.x + share * (to.x - from.x), from.y + share * (to.y - from.y),
          wrap_angle(from.yaw + share * angle_difference(to.yaw, from.yaw))};
}

}  // namespace

LidarSensing::LidarSensing(const SegmentIndex& index, const LidarModel& lidar, const NoiseProfile& noise,
                           const Random& random, double tick, bool motion_distortion, const Pose2& robot)
    : index_(&index),
      lidar_(lidar),
      noise_(noise),
      random_(random),
      motion_distortion_(motion_distortion),
      ticks_a_turn_(std::max(1, static_cast<int>(std::lround(lidar.scan_time / tick)))),
      time_increment_(ticks_a_turn_ * tick / lidar.beams),
      caster_(index, lidar),
      robot_(robot),
      turn_random_(random.fork(0)),
      ranges_(static_cast<std::size_t>(lidar.beams)),
      scanned_(ranges_.size()) {}

std::optional<LaserScan> LidarSensing::tick(const Pose2& robot, double stamp) {
  if (motion_distortion_) measure_tick(robot);
  robot_ = robot;
  if (++ticks_ < ticks_a_turn_) return std::nullopt;
  if (!motion_distortion_) measure_turn(robot);
  ticks_ = 0;
  turn_random_ = random_.fork(++turns_);
  std::swap(ranges_, scanned_);
  const double between_beams = motion_distortion_ ? time_increment_ : 0.0;
  return LaserScan{stamp - (lidar_.beams - 1) * between_beams,
                   lidar_.angle_min,
                   lidar_.angle_increment,
                   between_beams,
                   lidar_.min_range,
                   lidar_.max_range,
                   scanned_};
}

/// All beams at once, from where the robot is now.
void LidarSensing::measure_turn(const Pose2& robot) {
  const std::span<const double> ranges = caster_.cast(robot * lidar_.mount);
  for (std::size_t i = 0; i < ranges_.size(); ++i) ranges_[i] = reported(ranges[i]);
}

/// The beams whose time is in this tick, each from where the robot was then. Of n beams, beam i (from 0 on) has its
/// time when the share (i + 1) / n of the turn is over: the last one has that of the frame.
void LidarSensing::measure_tick(const Pose2& robot) {
  const int begin = ticks_ * lidar_.beams / ticks_a_turn_;
  const int end = (ticks_ + 1) * lidar_.beams / ticks_a_turn_;
  for (int i = begin; i < end; ++i) {
    const double share = static_cast<double>(i + 1) * ticks_a_turn_ / lidar_.beams - ticks_;
    const Pose2 sensor = between(robot_, robot, share) * lidar_.mount;
    const auto beam = static_cast<std::size_t>(i);
    const Point2 along = Pose2{0.0, 0.0, sensor.yaw} * caster_.beams()[beam];
    ranges_[beam] = reported(index_->cast(sensor.position(), along, lidar_.max_range).range);
  }
}

/// What the lidar says of a range: with its noise, if it can measure that at all.
float LidarSensing::reported(double range) {
  // Every beam has its number, whether it needs it or not: noise doesn't depend on what else there is to see.
  const bool noisy = noise_.lidar_noise > 0.0 || noise_.lidar_noise_share > 0.0;
  if (noisy && range >= lidar_.min_range && range <= lidar_.max_range) {
    constexpr double kNear = 0.5;  // [m]
    const double limit = range < kNear ? lidar_.near_accuracy : lidar_.accuracy * range;
    const double deviation = noise_.lidar_noise + noise_.lidar_noise_share * range;
    range += std::clamp(deviation * turn_random_.normal(), -limit, limit);
  } else {
    turn_random_.next();
  }
  const auto rounded = static_cast<float>(range);
  if (rounded < lidar_.min_range) return kTooNear;
  return rounded > lidar_.max_range ? kNothing : rounded;
}

}  // namespace scrubjay::sim
