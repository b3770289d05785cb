/// \file
/// A robot that others drive.
#pragma once

#include <scrubjay/behavior/behavior.hpp>
#include <scrubjay/planning/cost_map.hpp>
#include <scrubjay/planning/navigator.hpp>
#include <scrubjay/robot/robot_model.hpp>
#include <scrubjay/ros2/commands.hpp>

namespace scrubjay::ros {

struct RemoteDriveParams {
  double timeout = 0.5;  ///< a velocity that isn't told again for this long is over [s]
};

/// Drives by the velocities that are told; or, once a goal is, to the goal by the map so far. The newest has the say;
/// to be sent to the dock ends both. Never ends by itself.
///
/// On the way to a goal, a velocity of zeros is a wish to stop if it comes out of silence or behind another velocity.
/// One that was told again and again before, within RemoteDriveParams::timeout each, is that of a joystick at rest, and
/// leaves the goal alone.
///
/// A robot without a lidar feels its way: it may cross unknown floor, also beyond the map, which grows as it goes; and
/// it stops at what it bumps into.
class RemoteDrive final : public Behavior {
 public:
  /// `commands` must outlive it.
  RemoteDrive(const RobotModel& robot, Commands& commands, const RemoteDriveParams& params = {});

  Decision decide(const Situation& situation) override;
  std::span<const Point2> plan() const override { return goal_ ? navigator_.path() : std::span<const Point2>(); }

 private:
  void take(const Wishes& wishes, const GridGeometry& map, double now);
  void take_velocity(const Motion& velocity, double now);
  void take_goal(const Pose2& goal, const GridGeometry& map);
  void set_out(const GridGeometry& map);
  Decision drive_to_goal(const Situation& situation, const CellRect& costs_changed);

  Commands& commands_;
  RemoteDriveParams params_;
  CostMap costs_;
  Navigator navigator_;
  bool feels_its_way_;
  std::optional<Pose2> goal_;
  Motion velocity_;              // to drive by, while there is no goal
  double velocity_stamp_ = 0.0;  // when one was told last [s]
  bool rests_ = false;           // who told it, as far as that one says
};

}  // namespace scrubjay::ros
