/// \file
/// An axis-aligned rectangle of floor.
#pragma once

#include <scrubjay/geometry/pose2.hpp>

namespace scrubjay {

/// From the lower left corner to the upper right one.
struct Bounds2 {
  Point2 low{0.0, 0.0};   ///< [m]
  Point2 high{0.0, 0.0};  ///< [m]

  bool contains(const Point2& p) const {
    return p.x() >= low.x() && p.y() >= low.y() && p.x() <= high.x() && p.y() <= high.y();
  }
  bool operator==(const Bounds2&) const = default;
};

}  // namespace scrubjay
