/// \file
/// What a robot is told to do.
#pragma once

namespace scrubjay {

/// Wanted velocity of a differential drive's base.
struct Motion {
  double linear = 0.0;   ///< forward [m/s]
  double angular = 0.0;  ///< counter-clockwise [rad/s]

  bool operator==(const Motion&) const = default;
};

}  // namespace scrubjay
