#include <algorithm>
#include <cmath>
#include <limits>
#include <scrubjay/behavior/wander.hpp>

namespace scrubjay {
namespace {

constexpr double kForEver = std::numeric_limits<double>::infinity();
constexpr double kTurned = radians(3.0);        // as good as turned
constexpr double kBackwards = radians(120.0);   // a way is one back from here on
constexpr double kScansMissed = 2.5;            // so many turns of the lidar without a scan, and it sees nothing
constexpr double kLeastTurn = radians(30.0);    // without a lidar: away from an obstacle ...
constexpr double kFenceTurn = radians(120.0);   // ... or a virtual wall
constexpr double kMostTurn = radians(170.0);    // ... up to here
constexpr double kFurtherTurn = radians(10.0);  // ... and on, while something is ahead

bool touched(const Frame& frame) {
  return frame.bumped() || frame.cliff_flags != 0 || frame.wheel_dropped();
}

}  // namespace

Wander::Wander(const RobotModel& robot, Random random, const WanderParams& params)
    : robot_(robot), params_(params), random_(random), sense_(robot), guard_(robot) {
  params_.speed = std::min(robot.lidar ? params.speed : params.blind_speed, robot.max_linear_speed);
  params_.turn_rate = std::min(params.turn_rate, robot.max_angular_speed);
}

Decision Wander::decide(const Situation& situation) {
  const Frame& frame = situation.frame;
  look(situation);
  if (robot_.lidar && !(scan_stamp_ && frame.stamp - *scan_stamp_ <= kScansMissed * robot_.lidar->scan_time)) {
    return {{}, "waiting for the lidar"};
  }
  // A touch that backing off doesn't end is turned away from. If a whole turn doesn't, either, the other way is tried.
  const bool in_vain = state_ == State::Turning && frame.stamp - turn_since_ > 2.0 * kPi / params_.turn_rate;
  if (touched(frame) && (state_ == State::Driving || in_vain)) {
    state_ = State::BackingOff;
    met_ = obstacles_;
    back_until_ = frame.stamp + params_.back_off / params_.blind_speed;
  }
  Decision decision;
  switch (state_) {
    case State::Driving:
      decision = drive(situation);
      break;
    case State::Turning:
      decision = turn(situation);
      break;
    case State::BackingOff:
      decision = back_off(frame);
      break;
  }
  decision.motion = guard_.limit(decision.motion);
  return decision;
}

void Wander::look(const Situation& now) {
  Frame sensed = now.frame;
  // A virtual wall is seen from everywhere in its beam: what counts is to meet it. Then it is to be left behind.
  sensed.virtual_wall = now.frame.virtual_wall && !was_fenced_;
  was_fenced_ = now.frame.virtual_wall;
  obstacles_ = sense_(sensed);

  const double turned = angle_difference(now.estimate.pose.yaw, yaw_);
  yaw_ = now.estimate.pose.yaw;
  to_turn_ -= turned;
  turned_ += std::fabs(turned);

  guard_.sense(now.frame);
  if (now.frame.scan && robot_.lidar) look_around(now);
}

void Wander::look_around(const Situation& now) {
  scan_stamp_ = now.frame.stamp;
  scan_pose_ = now.estimate.pose;
  const auto outlook = [&](double margin) {
    return ScanOutlook(*now.frame.scan, *robot_.lidar, now.estimate.twist, now.frame.stamp, robot_.radius + margin);
  };
  outlook_ = outlook(params_.margin);
  if (outlook_.farthest() < params_.least_leg) outlook_ = outlook(params_.slim_margin);
}

Decision Wander::drive(const Situation& now) {
  const Pose2& pose = now.estimate.pose;
  by_touch_ = by_touch_ && obstacles_.ahead;
  const bool driven = (pose.position() - leg_from_).squaredNorm() >= leg_ * leg_;
  const double clear = clear_ahead(pose);
  if (driven || clear < params_.stop_before || (obstacles_.ahead && !by_touch_)) {
    met_ = obstacles_;
    begin_turn(now.frame.stamp);
    return turn(now);
  }
  return {{safe_speed(clear, now.frame.stamp - scan_stamp_.value_or(now.frame.stamp)), 0.0}, "forward"};
}

Decision Wander::turn(const Situation& now) {
  const Pose2& pose = now.estimate.pose;
  const bool turned = side_ != 0 && side_ * to_turn_ < kTurned;
  if (turned && !touched(now.frame) && may_set_off(pose)) {
    set_off(pose);
    return {{}, "forward"};
  }
  if ((side_ == 0 || turned) && !aim(pose)) return {{}, "boxed in"};
  const double rate = std::min(params_.turn_rate, 2.0 * std::fabs(to_turn_) + 0.1);  // arrives without overshooting
  return {{0.0, side_ * rate}, side_ > 0 ? "turning left" : "turning right"};
}

Decision Wander::back_off(const Frame& frame) {
  if (frame.stamp >= back_until_) {
    begin_turn(frame.stamp);
    return {{}, "backing off"};
  }
  return {{-params_.blind_speed, 0.0}, "backing off"};
}

void Wander::begin_turn(double stamp) {
  state_ = State::Turning;
  turn_since_ = stamp;
  side_ = 0;
  turned_ = 0.0;
}

/// Chooses how far to turn; the side is chosen with the first of a turn's aims. False if there is nowhere to go.
bool Wander::aim(const Pose2& pose) {
  if (!robot_.lidar) {
    if (side_ != 0) {
      to_turn_ = side_ * kFurtherTurn;
      return true;
    }
    const bool one_side = met_.left != met_.right;
    side_ = (one_side ? met_.right : random_.below(2) == 0) ? 1 : -1;
    to_turn_ = side_ * random_.uniform(was_fenced_ ? kFenceTurn : kLeastTurn, kMostTurn);
    return true;
  }
  const auto heading = draw_heading(pose);
  if (!heading) return false;
  to_turn_ = angle_difference(*heading, pose.yaw);
  if (side_ == 0) side_ = to_turn_ < 0.0 ? -1 : 1;
  if (side_ * to_turn_ < 0.0) to_turn_ += side_ * 2.0 * kPi;
  return true;
}

/// A heading that is clear for long enough, by chance.
std::optional<double> Wander::draw_heading(const Pose2& pose) {
  const auto weight = [&](int i) {
    const double clear = outlook_.clear(i);
    if (clear < params_.least_leg) return 0.0;
    const double turn = angle_difference(scan_pose_.yaw + ScanOutlook::bearing(i), pose.yaw);
    return clear * clear * (std::fabs(turn) > kBackwards ? params_.back_weight : 1.0);
  };
  double sum = 0.0;
  for (int i = 0; i < ScanOutlook::kBearings; ++i) sum += weight(i);
  if (sum <= 0.0) return std::nullopt;
  double left = random_.uniform(0.0, sum);
  int chosen = 0;
  for (int i = 0; i < ScanOutlook::kBearings; ++i) {
    if (weight(i) <= 0.0) continue;
    chosen = i;
    left -= weight(i);
    if (left < 0.0) break;
  }
  return wrap_angle(scan_pose_.yaw + ScanOutlook::bearing(chosen));
}

bool Wander::may_set_off(const Pose2& pose) const {
  // Where light sensors see something all around, touch has to do.
  const bool tight = !robot_.lidar && turned_ > 2.0 * kPi;
  return clear_ahead(pose) >= params_.least_leg && (!obstacles_.ahead || tight);
}

void Wander::set_off(const Pose2& pose) {
  state_ = State::Driving;
  by_touch_ = obstacles_.ahead;
  leg_from_ = pose.position();
  leg_ = robot_.lidar ? clear_ahead(pose) * random_.uniform(0.5, 1.0) : kForEver;
}

double Wander::clear_ahead(const Pose2& pose) const {
  if (!robot_.lidar) return kForEver;
  const double driven = std::sqrt((pose.position() - scan_pose_.position()).squaredNorm());
  return outlook_.clear_along(angle_difference(pose.yaw, scan_pose_.yaw)) - driven;
}

/// The speed from which it comes to rest within the clear way, if it begins to brake only after a while.
double Wander::safe_speed(double clear, double scan_age) const {
  if (!robot_.lidar) return params_.speed;
  const double wait = params_.reaction + scan_age;
  const double rest = std::sqrt(wait * wait + 2.0 * clear / params_.braking) - wait;
  return std::clamp(params_.braking * rest, 0.0, params_.speed);
}

}  // namespace scrubjay
