/// \file
/// What really happens to a simulated robot. Nothing of it may reach an estimator.
#pragma once

#include <cstdint>
#include <scrubjay/geometry/pose2.hpp>

namespace scrubjay::sim {

struct Truth {
  Pose2 pose;               ///< in the world's frame
  double distance = 0.0;    ///< driven so far [m]
  std::uint64_t bumps = 0;  ///< times that the bumper closed
  std::uint64_t ticks = 0;
};

}  // namespace scrubjay::sim
