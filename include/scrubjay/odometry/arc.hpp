/// \file
/// The arc that a differential drive rolls, as length, turn and chord.
#pragma once

#include <cmath>
#include <scrubjay/odometry/differential_drive.hpp>

namespace scrubjay {

/// An arc as length and turn.
struct Arc {
  double length = 0.0;  ///< [m]
  double turn = 0.0;    ///< [rad]
};

inline Arc arc_of(const WheelTravel& travel, const DifferentialDrive& drive) {
  return {0.5 * (travel.right + travel.left), (travel.right - travel.left) / drive.wheel_separation};
}

/// Length of an arc's chord: length * sin(turn / 2) / (turn / 2), without dividing by a small angle.
inline double chord(const Arc& arc) {
  const double half = 0.5 * arc.turn;
  if (std::fabs(half) > 0.1) return arc.length * sin_cos(half).sin / half;
  const double z = half * half;
  return arc.length * (1.0 - z / 6 * (1.0 - z / 20 * (1.0 - z / 42 * (1.0 - z / 72))));
}

}  // namespace scrubjay
