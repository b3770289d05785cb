#include <algorithm>
#include <scrubjay/ros2/remote_drive.hpp>

namespace scrubjay::ros {
namespace {

CostMapParams costs_for(const RobotModel& robot) {
  CostMapParams params;
  params.radius = robot.radius;
  params.through_unknown = !robot.lidar;
  return params;
}

/// As near to the point as the map goes.
Point2 nearest_within(const GridGeometry& map, const Point2& point) {
  if (map.size() == 0 || map.contains(map.cell_at(point))) return point;
  const Point2 low = map.center({0, 0});
  const Point2 high = map.center({map.width - 1, map.height - 1});
  return {std::clamp(point.x(), low.x(), high.x()), std::clamp(point.y(), low.y(), high.y())};
}

}  // namespace

RemoteDrive::RemoteDrive(const RobotModel& robot, Commands& commands, const RemoteDriveParams& params)
    : commands_(commands), params_(params), costs_(costs_for(robot)), navigator_(robot), feels_its_way_(!robot.lidar) {}

Decision RemoteDrive::decide(const Situation& situation) {
  const CellRect costs_changed = costs_.update(situation.map, situation.changed);
  const double now = situation.frame.stamp;
  take(commands_.wishes(), situation.map.geometry, now);
  if (goal_) return drive_to_goal(situation, costs_changed);
  if (velocity_ == Motion{} || now - velocity_stamp_ >= params_.timeout) return {{}, "waiting"};
  return {velocity_, "driven by others"};
}

void RemoteDrive::take(const Wishes& wishes, const GridGeometry& map, double now) {
  if (wishes.dock) {
    goal_.reset();
    velocity_ = {};
  }
  if (wishes.velocity && wishes.goal_is_newer) take_velocity(*wishes.velocity, now);
  if (wishes.goal) take_goal(*wishes.goal, map);
  if (wishes.velocity && !wishes.goal_is_newer) take_velocity(*wishes.velocity, now);
}

void RemoteDrive::take_velocity(const Motion& velocity, double now) {
  const bool rested = rests_ && now - velocity_stamp_ < params_.timeout;
  rests_ = velocity == Motion{};
  velocity_stamp_ = now;
  if (rested && rests_) return;  // nothing new
  velocity_ = velocity;
  goal_.reset();
}

void RemoteDrive::take_goal(const Pose2& goal, const GridGeometry& map) {
  goal_ = goal;
  velocity_ = {};
  set_out(map);
}

void RemoteDrive::set_out(const GridGeometry& map) {
  const Point2 target = feels_its_way_ ? nearest_within(map, goal_->position()) : goal_->position();
  const bool whole_way = target == goal_->position();
  navigator_.go_to(target, whole_way ? std::optional(goal_->yaw) : std::nullopt);
}

Decision RemoteDrive::drive_to_goal(const Situation& situation, const CellRect& costs_changed) {
  if (situation.frame.bumped()) {
    goal_.reset();
    return {{}, "bumped on the way to a goal"};
  }
  const bool part_of_the_way = navigator_.goal() != goal_->position();
  if (part_of_the_way && nearest_within(situation.map.geometry, goal_->position()) != navigator_.goal()) {
    set_out(situation.map.geometry);
  }
  const Navigator::Step step = navigator_.step(situation, costs_.view(), costs_changed);
  if (step.travel == Travel::Driving) return {step.motion, "to a goal"};
  const bool arrived = step.travel == Travel::Arrived && navigator_.goal() == goal_->position();
  goal_.reset();
  return {{}, arrived ? "at the goal" : "no way to the goal"};
}

}  // namespace scrubjay::ros
