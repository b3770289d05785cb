/// \file
/// Walls as a compass: most of those of a house stand square to each other.
#pragma once

#include <optional>
#include <scrubjay/localization/straight_walls.hpp>
#include <span>

namespace scrubjay {

/// Our own choices, tried where ScanMatchingParams were.
struct WallCompassParams {
  double deviation = radians(0.7);  ///< by which walls stand askew, in standard deviations [rad]
  double gate = radians(8.0);       ///< those farther askew than this are of another kind [rad]
  double least_share = 0.7;         ///< of the walls in sight, by length, that must not be
  double trust = 0.3;               ///< what a scan's word counts: the next one sees the same walls
};

/// A heading, held against walls.
struct HeadingError {
  double off = 0.0;          ///< to be added to the heading [rad]
  double information = 0.0;  ///< inverse variance of that [1/rad^2]
};

/// Tells what a heading errs by from the directions of the walls in sight. How the house stands, it learns from the
/// walls as they come, so that the first ones, which were seen before a heading could drift, have most to say. A house
/// of straight walls stays straight then, however many rooms lie between its ends. The same knowledge is used by
/// B. Peasley, S. Birchfield, A. Cunningham, F. Dellaert, *Accurate On-Line 3D Occupancy Grids Using Manhattan World
/// Constraints*, IROS 2012. Where walls run in all directions, it has nothing to say.
class WallCompass {
 public:
  explicit WallCompass(const WallCompassParams& params = {}) : params_(params) {}

  /// `walls` are those of a scan in the robot's frame, `yaw` is its heading as believed. The first walls that are
  /// square to each other tell how the house stands; there is no error then, nor where walls are not.
  std::optional<HeadingError> read(std::span<const StraightWall> walls, double yaw);

 private:
  WallCompassParams params_;
  /// Sum over walls seen, of unit vectors at four times their angle: directions count alike that are quarter turns
  /// apart (Mardia and Jupp, *Directional Statistics*, 2000, sec. 1.4).
  Point2 axis_{0.0, 0.0};
};

}  // namespace scrubjay
