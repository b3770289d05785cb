/// \file
/// Line segments: nearest points and ray hits.
#pragma once

#include <algorithm>
#include <limits>
#include <scrubjay/geometry/pose2.hpp>

namespace scrubjay {

struct Segment2 {
  Point2 a{0.0, 0.0};
  Point2 b{0.0, 0.0};

  double length() const { return (b - a).norm(); }
};

/// The point of the segment nearest to `p`.
inline Point2 nearest_point(const Segment2& s, const Point2& p) {
  const Point2 along = s.b - s.a;
  const double squared = along.squaredNorm();
  if (squared <= 0.0) return s.a;
  return s.a + std::clamp((p - s.a).dot(along) / squared, 0.0, 1.0) * along;
}

inline double squared_distance(const Segment2& s, const Point2& p) {
  return (nearest_point(s, p) - p).squaredNorm();
}

/// Distance along the ray from `origin` in unit `direction` to the segment; infinity where it misses.
/// A ray that runs along the segment meets its nearer end.
inline double ray_hit(const Segment2& s, const Point2& origin, const Point2& direction) {
  constexpr double kMiss = std::numeric_limits<double>::infinity();
  const Point2 along = s.b - s.a;
  const Point2 to_a = s.a - origin;
  const double cross = direction.x() * along.y() - direction.y() * along.x();
  const double offset = to_a.x() * direction.y() - to_a.y() * direction.x();
  if (cross == 0.0) {
    if (offset != 0.0) return kMiss;
    const double near_end = std::min(to_a.dot(direction), (s.b - origin).dot(direction));
    const double far_end = std::max(to_a.dot(direction), (s.b - origin).dot(direction));
    if (far_end < 0.0) return kMiss;
    return std::max(near_end, 0.0);
  }
  const double t = (to_a.x() * along.y() - to_a.y() * along.x()) / cross;
  const double u = offset / cross;
  return t >= 0.0 && u >= 0.0 && u <= 1.0 ? t : kMiss;
}

}  // namespace scrubjay
