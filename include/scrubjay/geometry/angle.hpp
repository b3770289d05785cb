/// \file
/// Angles in radians, counter-clockwise (REP-103).
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scrubjay {

inline constexpr double kPi = std::numbers::pi;

/// The same direction in [-pi, pi].
inline double wrap_angle(double angle) {
  if (angle >= -kPi && angle <= kPi) return angle;
  // Next to an odd multiple of pi, rounding may choose the turn beside.
  return std::clamp(angle - 2.0 * kPi * std::floor((angle + kPi) / (2.0 * kPi)), -kPi, kPi);
}

/// Shortest turn from `from` to `to`, in [-pi, pi].
inline double angle_difference(double to, double from) {
  return wrap_angle(to - from);
}

constexpr double radians(double degrees) {
  return degrees * (kPi / 180.0);
}
constexpr double degrees(double radians) {
  return radians * (180.0 / kPi);
}

}  // namespace scrubjay
