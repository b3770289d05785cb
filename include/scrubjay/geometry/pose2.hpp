/// \file
/// Poses and velocities in the plane (REP-103: x forward, y left, yaw counter-clockwise).
#pragma once

#include <Eigen/Core>
#include <scrubjay/geometry/angle.hpp>
#include <scrubjay/geometry/elementary.hpp>

namespace scrubjay {

using Point2 = Eigen::Vector2d;  ///< [m]

/// Unit vector at `angle` [rad].
inline Point2 direction(double angle) {
  const SinCos turn = sin_cos(angle);
  return {turn.cos, turn.sin};
}

/// `v` turned by the angle that `turn` is of.
inline Point2 turned(const SinCos& turn, const Point2& v) {
  return {turn.cos * v.x() - turn.sin * v.y(), turn.sin * v.x() + turn.cos * v.y()};
}

/// Position and heading of a frame in its parent: `parent_from_child`.
struct Pose2 {
  double x = 0.0;    ///< [m]
  double y = 0.0;    ///< [m]
  double yaw = 0.0;  ///< [rad], wrapped to [-pi, pi] by the operations here

  Point2 position() const { return {x, y}; }
  bool operator==(const Pose2&) const = default;
};

/// Composition: `a_from_c = a_from_b * b_from_c`.
inline Pose2 operator*(const Pose2& a, const Pose2& b) {
  const SinCos turn = sin_cos(a.yaw);
  return {a.x + turn.cos * b.x - turn.sin * b.y, a.y + turn.sin * b.x + turn.cos * b.y, wrap_angle(a.yaw + b.yaw)};
}

/// The point `p` of the child frame in the parent's.
inline Point2 operator*(const Pose2& pose, const Point2& p) {
  const SinCos turn = sin_cos(pose.yaw);
  return {pose.x + turn.cos * p.x() - turn.sin * p.y(), pose.y + turn.sin * p.x() + turn.cos * p.y()};
}

inline Pose2 inverse(const Pose2& pose) {
  const SinCos turn = sin_cos(pose.yaw);
  return {-turn.cos * pose.x - turn.sin * pose.y, turn.sin * pose.x - turn.cos * pose.y, wrap_angle(-pose.yaw)};
}

/// Velocity of a planar base in its own frame.
struct Twist2 {
  double linear = 0.0;   ///< forward [m/s]
  double lateral = 0.0;  ///< left [m/s]; 0 for a differential drive that doesn't slip
  double angular = 0.0;  ///< counter-clockwise [rad/s]

  bool operator==(const Twist2&) const = default;
};

}  // namespace scrubjay
