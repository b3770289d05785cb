/// \file
/// Where a beam ended, as localization sees it.
#pragma once

#include <scrubjay/geometry/pose2.hpp>

namespace scrubjay {

struct ScanEnd {
  Point2 point{0.0, 0.0};   ///< [m]
  Point2 view{0.0, 0.0};    ///< unit vector back to where the beam came from
  double noise = 0.0;       ///< standard deviation of the range, > 0 [m]
  double width = 0.0;       ///< of the beam there: how far the ends of neighbours lie apart, seen head on; > 0 [m]
  Point2 normal{0.0, 0.0};  ///< unit vector across the straight wall that it is of, either way; 0 where none is seen
};

/// Variance of where the beam ended, across a wall that it met at an angle of this cosine to the wall's normal: where
/// in its width a beam ended, nobody knows [m^2].
inline double variance_across(const ScanEnd& end, double cosine) {
  const double square = cosine * cosine;
  return square * end.noise * end.noise + (1.0 - square) * end.width * end.width / 12.0;
}

}  // namespace scrubjay
