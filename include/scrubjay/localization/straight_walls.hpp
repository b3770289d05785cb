/// \file
/// The straight walls that a scan shows.
#pragma once

#include <cstddef>
#include <scrubjay/localization/scan_end.hpp>
#include <span>
#include <vector>

namespace scrubjay {

/// Neighbouring ends of a scan that lie on one line, as far as the noise of their ranges lets anybody tell.
struct StraightWall {
  std::size_t first = 0;        ///< of the scan's ends
  std::size_t count = 0;        ///< of them, side by side
  Point2 along{1.0, 0.0};       ///< unit vector, either way
  double length = 0.0;          ///< [m]
  double angle_variance = 0.0;  ///< of the direction of `along` [rad^2]
};

/// Finds the walls of half a metre and more in `ends`, which are in the order of a scan's beams. Where there is a gap
/// between neighbours a wall ends, and where the ends bend away from the line of least squares it is taken in two
/// (iterative end point fit, as in V. Nguyen et al., *A Comparison of Line Extraction Algorithms Using 2D Range Data
/// for Indoor Mobile Robotics*, Autonomous Robots 23, 2007). Replaces what is in `walls`.
void find_straight_walls(std::span<const ScanEnd> ends, std::vector<StraightWall>& walls);

}  // namespace scrubjay
