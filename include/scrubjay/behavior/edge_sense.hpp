/// \file
/// The edge that a robot follows, seen as if it were always on the left.
#pragma once

#include <optional>
#include <scrubjay/geometry/pose2.hpp>
#include <scrubjay/robot/frame.hpp>
#include <scrubjay/robot/robot_model.hpp>

namespace scrubjay {

enum class Side : std::int8_t { Left = 1, Right = -1 };

inline Side opposite(Side side) {
  return side == Side::Left ? Side::Right : Side::Left;
}

/// Ranges of the three light sensors of each half, the followed side first [m]; large where nothing is seen.
struct EdgeView {
  double side = 0.0;         ///< 65 degrees towards the edge
  double front_side = 0.0;   ///< 37.5
  double front = 0.0;        ///< 12.5
  double other_front = 0.0;  ///< 12.5 away from the edge
  double other_front_side = 0.0;
  double other_side = 0.0;
  bool bump_side = false;   ///< the half towards the edge was hit
  bool bump_other = false;  ///< the half away from it was hit
  /// The point of the edge that is seen farthest back, in the robot's frame (not mirrored); none if none is seen.
  std::optional<Point2> point;
};

/// `point_range` is how near a light return must be to count as a point of the edge [m]. Cliffs count as touched.
EdgeView edge_view(const Frame& frame, Side side, const RobotModel& robot, double point_range);

/// Where whatever is in front of the robot lies, from straight ahead, as well as the bumper or the light tell [rad].
double obstacle_bearing(const Frame& frame, const RobotModel& robot);

/// The side on which whatever is in front of the robot can be followed; `preferred` where both would do.
Side nearer_side(const Frame& frame, Side preferred);

}  // namespace scrubjay
