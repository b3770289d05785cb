#include <algorithm>
#include <cmath>
#include <scrubjay/behavior/leg_drive.hpp>

namespace scrubjay {
namespace {

/// Speed from which braking by `slowing` ends after `left`, within limits.
double ending(double left, double slowing, double slowest, double fastest) {
  return std::clamp(std::sqrt(2.0 * slowing * std::max(left, 0.0)), slowest, fastest);
}

}  // namespace

LegDrive::LegDrive(std::span<const Leg> legs, const LegDriveParams& params) : params_(params) {
  count_ = std::min(legs.size(), kMaxLegs);
  std::copy_n(legs.begin(), count_, legs_.begin());
}

Decision LegDrive::decide(const Situation& situation) {
  const Frame& frame = situation.frame;
  follow_turn(situation.estimate.pose);
  if (frame.bumped() || frame.wheel_dropped() || frame.cliff_flags != 0) state_ = State::Failed;
  switch (state_) {
    case State::Resting:
      return rest(frame);
    case State::Rolling:
      return roll(situation);
    case State::Turning:
      return turn(frame);
    case State::Done:
      return {{}, "done", true};
    case State::Failed:
      return {{}, "blocked", true};
  }
  return {};
}

void LegDrive::follow_turn(const Pose2& pose) {
  if (!started_) {
    line_ = pose;
    heading_ = wanted_ = last_yaw_ = pose.yaw;
  }
  heading_ += angle_difference(pose.yaw, last_yaw_);
  last_yaw_ = pose.yaw;
}

void LegDrive::begin_rest(const Frame& frame, State next) {
  state_ = State::Resting;
  next_ = next;
  rest_stamp_ = frame.stamp;
}

Decision LegDrive::rest(const Frame& frame) {
  const bool moved = frame.left_travel != 0.0 || frame.right_travel != 0.0;
  if (!started_ || moved) rest_stamp_ = frame.stamp;
  started_ = true;
  if (frame.stamp - rest_stamp_ >= params_.rest) {
    state_ = leg_ == count_ ? State::Done : next_;
    if (state_ == State::Turning) wanted_ += legs_[leg_].turn;
  }
  return {{}, "resting"};
}

Decision LegDrive::roll(const Situation& situation) {
  const Pose2 seen = inverse(line_) * situation.estimate.pose;  // from the leg's line, x along it
  const double left = legs_[leg_].way - seen.x;
  if (legs_[leg_].way == 0.0 || left <= 0.0) {
    begin_rest(situation.frame, State::Turning);
    return {{}, "resting"};
  }
  const double aim = std::clamp(-params_.line_steering * seen.y, -0.5, 0.5);
  const double speed = ending(left, params_.slowing, params_.slowest, params_.speed);
  return {
      {speed, std::clamp(params_.steering * angle_difference(aim, seen.yaw), -params_.turn_rate, params_.turn_rate)},
      "straight on"};
}

Decision LegDrive::turn(const Frame& frame) {
  const double way = legs_[leg_].turn < 0.0 ? -1.0 : 1.0;
  const double left = way * (wanted_ - heading_);
  if (left <= 0.0) {
    end_leg();
    begin_rest(frame, State::Rolling);
    return {{}, "resting"};
  }
  const double rate = ending(left, params_.turn_slowing, params_.slowest_turn, params_.turn_rate);
  return {{0.0, way * rate}, "turning"};
}

void LegDrive::end_leg() {
  line_ = line_ * Pose2{legs_[leg_].way, 0.0, wrap_angle(legs_[leg_].turn)};
  ++leg_;
}

}  // namespace scrubjay
