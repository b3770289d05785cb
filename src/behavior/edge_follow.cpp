#include <algorithm>
#include <cmath>
#include <scrubjay/behavior/edge_follow.hpp>

namespace scrubjay {
namespace {

double sign(Side side) {
  return static_cast<double>(static_cast<int>(side));
}

// The side sensor's range beside a straight wall at `gap` from the shell.
double side_range_at(double gap, const RobotModel& robot) {
  const Pose2& mount = robot.light.mount[static_cast<std::size_t>(LightSensor::Left)];
  return (robot.radius + gap - mount.y) / sin_cos(mount.yaw).sin;
}

}  // namespace

EdgeFollow::EdgeFollow(const RobotModel& robot, Random random, const EdgeFollowParams& params)
    : robot_(robot),
      random_(random),
      params_(params),
      target_side_range_(side_range_at(params.gap, robot)),
      side_(params.preferred_side),
      closure_(params.closure) {}

Decision EdgeFollow::decide(const Situation& now) {
  const Pose2& pose = now.estimate.pose;
  const double turn = sign(side_) * angle_difference(pose.yaw, last_yaw_);
  last_yaw_ = pose.yaw;
  turned_ += turn;
  if (state_ == State::Orbit) orbited_ += turn;

  EdgeView view = edge_view(now.frame, side_, robot_, params_.lost_range);
  if (following()) locate_edge(pose, view);
  const bool forbidden = now.frame.cliff_flags != 0 || now.frame.virtual_wall;
  if (forbidden && state_ != State::Retreat && state_ != State::Turn && state_ != State::Done) begin_retreat(now);
  transition(now, view);
  if (following() && !new_edge_) go_round(now);
  return act(now, view);
}

/// Where the edge is, by light where it is seen. A bumper tells only when it closes, roughly, and exactly when it opens
/// while the robot turns: the contact then leaves its arc, straight to the side.
void EdgeFollow::locate_edge(const Pose2& pose, const EdgeView& view) {
  if (view.point) {
    edge_ = pose * *view.point;
  } else if (view.bump_side && !touching_) {
    const bool cliff = state_ == State::Retreat;  // felt by the sensors in front
    edge_ = pose * Point2(robot_.radius * direction(sign(side_) * radians(cliff ? 15.0 : 45.0)));
  } else if (!view.bump_side && touching_ && state_ == State::Align) {
    edge_ = pose * Point2(0.0, sign(side_) * robot_.radius);
  }
  touching_ = view.bump_side;
}

void EdgeFollow::transition(const Situation& now, const EdgeView& view) {
  switch (state_) {
    case State::Seek:
      return seek(now, view);
    case State::Turn:
      if (std::fabs(angle_difference(target_heading_, now.estimate.pose.yaw)) < radians(2.0)) begin_seek(now);
      return;
    case State::Retreat:
      return retreat(now);
    case State::Align:
      return align(now, view);
    case State::Follow:
      return follow(view);
    case State::Orbit:
      return orbit(now, view);
    case State::GlanceIn:
      return glance_in(view);
    case State::GlanceOut:
      return glance_out(view);
    case State::Done:
      return;
  }
}

void EdgeFollow::seek(const Situation& now, const EdgeView& view) {
  const Pose2& pose = now.estimate.pose;
  const CellIndex before = now.map.geometry.cell_at(pose * Point2(1.2 * robot_.radius, 0.0));
  const double way = (pose.position() - sought_from_).norm();
  const bool unknown = !now.map.contains(before) || trinary(now.map[before]) == kUnknown;
  if (unknown) unknown_crossed_ += way - last_way_;
  last_way_ = way;
  if (ahead(view)) meet_edge(now);
}

void EdgeFollow::begin_seek(const Situation& now) {
  sought_from_ = now.estimate.pose.position();
  unknown_crossed_ = last_way_ = 0.0;
  enter(State::Seek);
}

/// Counts a drive over open floor; one too many in vain is the last.
void EdgeFollow::end_drive() {
  in_vain_ = unknown_crossed_ < params_.worthwhile ? in_vain_ + 1 : 0;
  if (in_vain_ >= params_.patience) enter(State::Done);
}

/// Decides on an edge that the robot has come upon.
void EdgeFollow::meet_edge(const Situation& now) {
  end_drive();
  if (state_ == State::Done) return;
  const Pose2& pose = now.estimate.pose;
  const double obstacle = pose.yaw + obstacle_bearing(now.frame, robot_);
  known_ = !params_.one_edge && beside_known_floor(now.map, {pose.position(), robot_.radius, obstacle}, pose.yaw);
  // Hemmed in, the way out is along the edge; and with its front over a cliff, it must back off first.
  const bool free = last_way_ >= params_.least_drive && now.frame.cliff_flags == 0;
  if (known_ && free && turn_to_unknown(now, obstacle)) return;
  side_ = nearer_side(now.frame, params_.preferred_side);
  new_edge_ = true;
  orbited_ = 0.0;
  edge_ = pose.position() + robot_.radius * direction(obstacle);
  enter(State::Align);
}

/// Follows an edge that is new until it is closed; one that is known only until unknown floor comes in sight.
void EdgeFollow::go_round(const Situation& now) {
  const double edge_bearing = now.estimate.pose.yaw + sign(side_) * kPi / 2.0;
  if (closure_.update(now.estimate)) {
    if (known_) return leave_edge(now, edge_bearing);
    ++loops_closed_;
    if (params_.one_edge) return enter(State::Done);
    if (turn_to_unknown(now, edge_bearing)) return;
    known_ = true;  // once more around it, on the look-out
    return begin_edge(now);
  }
  const bool at_cliff = extra_gap_ >= params_.cliff_gap;  // no place to turn at once
  if (!known_ || at_cliff || closure_.length() - looked_at_ < params_.look_distance) return;
  looked_at_ = closure_.length();
  turn_to_unknown(now, edge_bearing);
}

void EdgeFollow::begin_retreat(const Situation& now) {
  fenced_ = now.frame.virtual_wall;
  extra_gap_ = fenced_ ? 0.0 : params_.cliff_gap;
  retreat_from_ = now.estimate.pose.position();
  retreat_stamp_ = now.frame.stamp;
  // At the end of a drive over open floor, a cliff is an edge that is met.
  if (state_ == State::Seek && fenced_) end_drive();
  if (state_ == State::Seek && !fenced_) meet_edge(now);
  if (state_ != State::Done) enter(State::Retreat);
}

void EdgeFollow::retreat(const Situation& now) {
  const bool forbidden = now.frame.cliff_flags != 0 || now.frame.virtual_wall;
  const double way = (now.estimate.pose.position() - retreat_from_).norm();
  const bool enough = way >= params_.retreat && !forbidden;
  // By the clock, since something behind it may hold it.
  if (!enough && now.frame.stamp - retreat_stamp_ < params_.longest_retreat) return;
  if (fenced_) return leave_edge(now, now.estimate.pose.yaw);
  least_turn_ = params_.cliff_turn;
  enter(State::Align);
}

void EdgeFollow::align(const Situation& now, const EdgeView& view) {
  if (clear(view) && -turned_ >= least_turn_) {
    least_turn_ = 0.0;
    if (new_edge_) begin_edge(now);
    return enter(State::Follow);
  }
  // Shut in on all sides, as far as it can see.
  if (-turned_ > params_.full_turn) leave_edge(now, now.estimate.pose.yaw);
}

void EdgeFollow::follow(const EdgeView& view) {
  const bool at_cliff = extra_gap_ >= params_.cliff_gap;
  if (at_cliff && edge_seen(view)) extra_gap_ = 0.0;  // the cliff has ended at a wall
  if (view.bump_side) {
    const double most = params_.lost_range - target_side_range_ - params_.dark_step;
    extra_gap_ = std::min(extra_gap_ + params_.dark_step, std::max(extra_gap_, most));
  }
  if (view.bump_side || ahead(view)) return enter(State::Align);
  if (edge_seen(view)) orbited_ = 0.0;
  if (edge_seen(view)) return;
  if (!at_cliff) extra_gap_ = 0.0;  // the next surface may be brighter
  enter(State::Orbit);
}

void EdgeFollow::orbit(const Situation& now, const EdgeView& view) {
  // What is ahead on the far side leaves too narrow a gap: aligning makes that the edge that is followed.
  if (ahead(view)) return enter(State::Align);
  if (edge_seen(view)) return enter(State::Follow);
  if (turned_ >= params_.glance_spacing) return enter(State::GlanceIn);
  if (orbited_ > params_.full_turn) leave_edge(now, now.estimate.pose.yaw);
}

void EdgeFollow::glance_in(const EdgeView& view) {
  const bool near = view.bump_side || view.bump_other || view.front_side < params_.clear_range / 2.0 || ahead(view);
  if (edge_seen(view)) orbited_ = 0.0;
  if (near || turned_ >= params_.glance_angle) enter(State::GlanceOut);
}

void EdgeFollow::glance_out(const EdgeView& view) {
  if (turned_ > 0.0) return;  // not yet turned back as far as it had turned in
  if (!clear(view)) return enter(State::Align);
  enter(edge_seen(view) ? State::Follow : State::Orbit);
}

Decision EdgeFollow::act(const Situation& now, const EdgeView& view) const {
  const double towards = sign(side_) * params_.turn_rate;
  switch (state_) {
    case State::Seek:
      return {{params_.forward_speed, 0.0}, "seeking an edge"};
    case State::Turn: {
      const double error = angle_difference(target_heading_, now.estimate.pose.yaw);
      return {{0.0, std::clamp(3.0 * error, -params_.turn_rate, params_.turn_rate)}, "turning to open floor"};
    }
    case State::Retreat:
      return {{-params_.forward_speed, 0.0}, "backing off"};
    case State::Align:
      return {{0.0, -towards}, "turning along the edge"};
    case State::Follow:
      return {{params_.forward_speed, sign(side_) * follow_turn(view)}, "following the edge"};
    case State::Orbit:
      return {{params_.forward_speed, sign(side_) * orbit_turn(now.estimate.pose)}, "rounding a corner"};
    case State::GlanceIn:
      return {{0.0, towards}, "looking for the edge"};
    case State::GlanceOut:
      return {{0.0, -towards}, "looking for the edge"};
    case State::Done:
      return {{}, "done", true};
  }
  return {};
}

double EdgeFollow::follow_turn(const EdgeView& view) const {
  double target = target_side_range_ + extra_gap_;
  // Between two near edges, keep to the middle.
  if (view.other_side < params_.lost_range) target = std::min(target, 0.5 * (view.side + view.other_side));
  return std::clamp(params_.gain * (view.side - target), -params_.turn_rate, params_.turn_rate);
}

/// Straight on until the edge's last point is abeam, then around it at the distance that it has.
double EdgeFollow::orbit_turn(const Pose2& pose) const {
  const Point2 point = edge_in_robot(pose);
  if (point.x() > 0.0) return 0.0;
  const double distance = std::max(point.norm(), robot_.radius);
  const double behind = atan2(-point.x(), std::max(point.y(), 1e-6));
  const double too_far = distance - (robot_.radius + params_.gap + extra_gap_);
  const double turn = params_.forward_speed / distance + 2.0 * behind + 3.0 * too_far;
  return std::clamp(turn, 0.0, 2.0 * params_.turn_rate);
}

void EdgeFollow::enter(State state) {
  // A glance is turned back by as much as it was turned in.
  turned_ = state == State::GlanceOut ? turned_ : 0.0;
  state_ = state;
}

void EdgeFollow::begin_edge(const Situation& now) {
  new_edge_ = false;
  if (!known_) in_vain_ = 0;
  looked_at_ = 0.0;
  closure_.begin(now.estimate);
}

/// Goes where unknown floor is in sight, or else as far away as it can.
void EdgeFollow::leave_edge(const Situation& now, double obstacle) {
  if (params_.one_edge) return enter(State::Done);
  if (turn_to_unknown(now, obstacle)) return;
  const Standpoint here{now.estimate.pose.position(), robot_.radius, obstacle};
  turn_to(longest_heading(now.map, here, random_));
}

bool EdgeFollow::turn_to_unknown(const Situation& now, double obstacle) {
  const Standpoint here{now.estimate.pose.position(), robot_.radius, obstacle};
  const auto heading = heading_to_unknown(now.map, here, random_);
  if (heading) turn_to(*heading);
  return heading.has_value();
}

void EdgeFollow::turn_to(double heading) {
  target_heading_ = heading;
  extra_gap_ = least_turn_ = 0.0;
  new_edge_ = true;
  enter(State::Turn);
}

bool EdgeFollow::ahead(const EdgeView& view) const {
  const double near = params_.ahead_range;
  return view.bump_side || view.bump_other || view.front_side < near || view.front < near || view.other_front < near ||
         view.other_front_side < near;
}

bool EdgeFollow::clear(const EdgeView& view) const {
  return !view.bump_side && !view.bump_other && view.front_side > params_.clear_range &&
         view.front > params_.clear_range && view.other_front > params_.clear_range &&
         view.other_front_side > params_.ahead_range;
}

Point2 EdgeFollow::edge_in_robot(const Pose2& pose) const {
  const Point2 point = inverse(pose) * edge_;
  return {point.x(), sign(side_) * point.y()};
}

}  // namespace scrubjay
