/// \file
/// The direction in which the walls of a house run.
#pragma once

#include <cmath>
#include <scrubjay/geometry/pose2.hpp>

namespace scrubjay {

/// The mean direction of what is driven straight along edges, by its length. Walls stand square to each other, so
/// directions count alike that are quarter turns apart: the mean is taken of four times the angle (Mardia and Jupp,
/// *Directional Statistics*, 2000, sec. 1.4).
class WallAxis {
 public:
  /// A small step along an edge. Bent ones are left out.
  void add(const Pose2& from, const Pose2& to) {
    constexpr double kStraight = 0.3;  // [rad/m]
    const double way = (to.position() - from.position()).norm();
    if (std::fabs(angle_difference(to.yaw, from.yaw)) >= kStraight * way) return;
    const SinCos quadruple = sin_cos(4.0 * to.yaw);
    cos_ += way * quadruple.cos;
    sin_ += way * quadruple.sin;
  }
  /// In [-pi/4, pi/4]; `fallback` as long as nothing is known of walls [rad].
  double heading(double fallback) const { return cos_ == 0.0 && sin_ == 0.0 ? fallback : 0.25 * atan2(sin_, cos_); }

 private:
  double cos_ = 0.0;
  double sin_ = 0.0;
};

}  // namespace scrubjay
