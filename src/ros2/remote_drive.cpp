#include <scrubjay/ros2/remote_drive.hpp>

namespace scrubjay::ros {
namespace {

CostMapParams costs_for(const RobotModel& robot) {
  CostMapParams params;
  params.radius = robot.radius;
  params.through_unknown = !robot.lidar;
  return params;
}

}  // namespace

RemoteDrive::RemoteDrive(const RobotModel& robot, Commands& commands, const RemoteDriveParams& params)
    : commands_(commands), params_(params), costs_(costs_for(robot)), navigator_(robot) {}

Decision RemoteDrive::decide(const Situation& situation) {
  const CellRect costs_changed = costs_.update(situation.map, situation.changed);
  const double now = situation.frame.stamp;
  if (const auto goal = commands_.goal()) {
    navigator_.go_to(goal->position(), goal->yaw);
    to_goal_ = true;
    velocity_ = {};
  }
  if (const auto velocity = commands_.velocity()) {
    velocity_ = *velocity;
    velocity_stamp_ = now;
    to_goal_ = false;
  }
  if (to_goal_) return drive_to_goal(situation, costs_changed);
  const bool stands = velocity_.linear == 0.0 && velocity_.angular == 0.0;
  if (stands || now - velocity_stamp_ >= params_.timeout) return {{}, "waiting"};
  return {velocity_, "driven by others"};
}

Decision RemoteDrive::drive_to_goal(const Situation& situation, const CellRect& costs_changed) {
  if (situation.frame.bumped()) {
    to_goal_ = false;
    return {{}, "bumped on the way to a goal"};
  }
  const Navigator::Step step = navigator_.step(situation, costs_.view(), costs_changed);
  if (step.travel == Travel::Driving) return {step.motion, "to a goal"};
  to_goal_ = false;
  return {{}, step.travel == Travel::Arrived ? "at the goal" : "no way to the goal"};
}

}  // namespace scrubjay::ros
