/// \file
/// Where something was, and when.
#pragma once

#include <scrubjay/geometry/pose2.hpp>

namespace scrubjay {

struct StampedPose {
  double stamp = 0.0;  ///< [s]
  Pose2 pose;

  bool operator==(const StampedPose&) const = default;
};

}  // namespace scrubjay
