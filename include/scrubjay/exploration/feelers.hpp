/// \file
/// What a robot that drives straight on feels ahead of it and beside it, without touching it.
#pragma once

#include <limits>
#include <optional>
#include <scrubjay/grid/log_odds.hpp>
#include <scrubjay/robot/frame.hpp>
#include <scrubjay/robot/robot_model.hpp>

namespace scrubjay {

/// Something that the disc would touch, driving straight on.
struct Ahead {
  double way = std::numeric_limits<double>::infinity();  ///< until it touches [m]; no less than 0
  std::optional<Point2> point;                           ///< where, in the robot's frame
};

/// The nearest of what the light sensors see in the disc's way. Signals from beyond `trusted` [m] count for nothing.
Ahead ahead_by_light(const Frame& frame, const RobotModel& robot, double trusted = 0.16);

/// Room to the left and the right of the disc together, by the outermost light sensors, which look a little ahead [m];
/// infinity where they don't both see something.
double room_beside(const Frame& frame, const RobotModel& robot);

/// True in front of a dock, looking into it: the robot would charge next, and obey no more.
bool faces_dock(const Frame& frame);

/// How far the floor before the disc is known to be free, over most of its width; no farther than `sight` [m].
double known_ahead(GridView<const LogOdds> map, const Pose2& pose, double radius, double sight);

/// The speed [m/s] from which a robot that brakes by `braking` [m/s^2] stops within `way` [m].
double speed_to_stop(double way, double braking);

}  // namespace scrubjay
