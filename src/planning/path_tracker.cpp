#include <algorithm>
#include <cmath>
#include <scrubjay/geometry/segment2.hpp>
#include <scrubjay/planning/path_tracker.hpp>
#include <utility>

namespace scrubjay {
namespace {

// Of what the robot can: quick turns cost a scan matcher and a wheel odometry more than they save.
constexpr double kComfortableTurn = 0.4;
constexpr double kMaxComfortableTurn = 1.2;  // [rad/s]
// A turn on the spot goes on until the error is this small a part of what began it.
constexpr double kTurnedAway = 0.2;
// Motors don't turn at lower speeds.
constexpr double kSlowest = 0.025;           // [m/s]
constexpr double kSlowestTurn = 0.15;        // [rad/s]
constexpr double kShortestLookahead = 0.06;  // [m]
// The place on the path is looked for this far ahead of the last one, so that it never jumps to another branch.
constexpr double kSearchAhead = 0.5;  // [m]
// The time in which the robot may get to the point that it looks at.
constexpr double kLookaheadTime = 0.5;  // [s]

double bearing(const Point2& from, const Point2& to) {
  return atan2(to.y() - from.y(), to.x() - from.x());
}

}  // namespace

PathTracker::PathTracker(const RobotModel& robot, const PathTrackerParams& params)
    : params_(params), max_wheel_speed_(robot.max_wheel_speed), half_axle_(0.5 * robot.drive.wheel_separation) {
  if (params_.max_linear <= 0.0) params_.max_linear = robot.max_linear_speed;
  if (params_.max_angular <= 0.0) {
    params_.max_angular = std::min(kMaxComfortableTurn, kComfortableTurn * robot.max_angular_speed);
  }
  params_.max_linear = std::min(params_.max_linear, robot.max_linear_speed);
  params_.max_angular = std::min(params_.max_angular, robot.max_angular_speed);
}

void PathTracker::follow(std::vector<Point2> path, std::optional<double> heading) {
  path_ = std::move(path);
  heading_ = heading;
  next_ = path_.size() > 1 ? 1 : 0;
  state_ = path_.empty() ? State::Arrived : State::Along;
}

double PathTracker::remaining() const {
  const std::span<const Point2> way = ahead();
  double length = 0.0;
  for (std::size_t i = 1; i < way.size(); ++i) length += (way[i] - way[i - 1]).norm();
  return length;
}

double PathTracker::off_path(const Point2& position) const {
  if (path_.empty()) return 0.0;
  if (next_ == 0) return (path_.front() - position).norm();
  return std::sqrt(squared_distance({path_[next_ - 1], path_[next_]}, position));
}

PathTracker::Step PathTracker::track(const Pose2& pose) {
  if (state_ == State::Arrived) return {{}, true};
  move_on(pose.position());
  const bool last = next_ + 1 >= path_.size();
  if (state_ != State::Facing && last && (path_.back() - pose.position()).norm() <= params_.reached) {
    state_ = heading_ ? State::Facing : State::Arrived;
  }
  switch (state_) {
    case State::Facing:
      return face(pose);
    case State::Arrived:
      return {{}, true};
    case State::Along:
    case State::Turning:
      return along(pose);
  }
  return {};
}

/// Finds the robot's place on the path, which moves forwards only.
void PathTracker::move_on(const Point2& position) {
  if (next_ == 0) return;
  std::size_t nearest_leg = next_;
  Point2 place = nearest_point({path_[next_ - 1], path_[next_]}, position);
  double way = (path_[next_] - place).norm();
  for (std::size_t leg = next_ + 1; leg < path_.size() && way < kSearchAhead; ++leg) {
    const Point2 candidate = nearest_point({path_[leg - 1], path_[leg]}, position);
    if ((candidate - position).squaredNorm() < (place - position).squaredNorm()) {
      nearest_leg = leg;
      place = candidate;
    }
    way += (path_[leg] - path_[leg - 1]).norm();
  }
  next_ = nearest_leg;
  path_[next_ - 1] = place;
}

/// The point of the path to drive at: `lookahead` ahead, or nearer where the straight line to it would cut a corner.
Point2 PathTracker::target() const {
  if (next_ == 0) return path_.front();
  const Point2 place = path_[next_ - 1];
  double way = 0.0;
  Point2 best = path_[next_];
  for (std::size_t leg = next_; leg < path_.size(); ++leg) {
    const Point2 begin = path_[leg - 1];
    const double length = (path_[leg] - begin).norm();
    // In small steps along the leg: each must leave all corners before it near to the straight line.
    constexpr double kStep = 0.01;
    for (double along = std::min(kStep, length);; along = std::min(along + kStep, length)) {
      const Point2 candidate = length > 0.0 ? Point2(begin + (path_[leg] - begin) * (along / length)) : begin;
      if (way + along > params_.lookahead) return best;
      bool cuts = false;
      for (std::size_t corner = next_; corner < leg && !cuts; ++corner) {
        cuts = squared_distance({place, candidate}, path_[corner]) > params_.cut * params_.cut;
      }
      if (cuts && way + along > kShortestLookahead) return best;
      best = candidate;
      if (along >= length) break;
    }
    way += length;
  }
  return best;
}

/// So slow that the robot can stop at the end, and can turn where a corner asks for a turn on the spot.
double PathTracker::allowed_speed(const Point2& position) const {
  double speed = params_.max_linear;
  Point2 before = position;
  double way = 0.0;
  for (std::size_t i = next_; i < path_.size(); ++i) {
    way += (path_[i] - before).norm();
    double at_point = 0.0;
    if (i + 1 < path_.size()) {
      const double turn = std::fabs(angle_difference(bearing(path_[i], path_[i + 1]), bearing(before, path_[i])));
      at_point = params_.max_linear * std::max(0.0, 1.0 - turn / params_.turn_in_place);
    }
    speed = std::min(speed, std::sqrt(at_point * at_point + 2.0 * params_.braking * way));
    before = path_[i];
    if (2.0 * params_.braking * way > params_.max_linear * params_.max_linear) break;
  }
  return speed;
}

PathTracker::Step PathTracker::along(const Pose2& pose) {
  const Point2 goal = target();
  const double error = angle_difference(bearing(pose.position(), goal), pose.yaw);
  if (state_ == State::Along && std::fabs(error) > params_.turn_in_place) state_ = State::Turning;
  if (state_ == State::Turning && std::fabs(error) < kTurnedAway * params_.turn_in_place) state_ = State::Along;
  if (state_ == State::Turning) return {turn(error)};

  const double distance = (goal - pose.position()).norm();
  const double curvature = 2.0 * sin_cos(error).sin / std::max(distance, kShortestLookahead);
  double speed = std::min(allowed_speed(pose.position()), std::max(distance, kShortestLookahead) / kLookaheadTime);
  speed *= std::max(0.0, 1.0 - std::fabs(error) / params_.turn_in_place);
  speed = std::clamp(speed, std::min(kSlowest, params_.max_linear), params_.max_linear);
  // No faster round the curve than the robot and its outer wheel can.
  speed = std::min(speed, max_wheel_speed_ / (1.0 + std::fabs(curvature) * half_axle_));
  if (std::fabs(curvature) * speed > params_.max_angular) speed = params_.max_angular / std::fabs(curvature);
  return {{speed, curvature * speed}};
}

PathTracker::Step PathTracker::face(const Pose2& pose) {
  const double error = angle_difference(*heading_, pose.yaw);
  if (std::fabs(error) > params_.heading_reached) return {turn(error)};
  state_ = State::Arrived;
  return {{}, true};
}

Motion PathTracker::turn(double error) const {
  const double braking = std::sqrt(2.0 * params_.turn_braking * std::fabs(error));
  const double rate = std::clamp(braking, std::min(kSlowestTurn, params_.max_angular), params_.max_angular);
  return {0.0, std::copysign(rate, error)};
}

}  // namespace scrubjay
