/// \file
/// Another robot, as far as one has to do with it.
#pragma once

#include <scrubjay/geometry/pose2.hpp>

namespace scrubjay::sim {

/// Stands on the floor, blocks, and is felt and seen. It isn't moved by who drives against it.
struct Disc {
  Point2 center{0.0, 0.0};  ///< in the world's frame [m]
  double radius = 0.0;      ///< [m]
};

}  // namespace scrubjay::sim
