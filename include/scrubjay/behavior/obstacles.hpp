/// \file
/// What stands in a Roomba's way, as its strategies see it.
#pragma once

#include <scrubjay/robot/frame.hpp>
#include <scrubjay/robot/robot_model.hpp>

namespace scrubjay {

/// Ranges at which light signals count as something in the way. Own choice: a fifth of the sensors' useful range, so
/// that a robot at 0.1 m/s stops before it touches.
struct ObstacleParams {
  double ahead_range = 0.05;  ///< [m]
};

/// Where something is near, touched, or the floor ends.
struct Obstacles {
  bool left = false;   ///< towards 30 to 90 degrees
  bool ahead = false;  ///< within 30 degrees of straight ahead
  bool right = false;  ///< towards -30 to -90 degrees

  bool any() const { return left || ahead || right; }
};

/// Turns frames into obstacles, with thresholds worked out once.
class ObstacleSense {
 public:
  explicit ObstacleSense(const RobotModel& robot, const ObstacleParams& params = {});

  Obstacles operator()(const Frame& frame) const;

 private:
  std::uint16_t near_signal_;
};

/// The light signal of an average surface at `range` [m].
std::uint16_t light_signal_at(double range, const RobotModel& robot);

}  // namespace scrubjay
