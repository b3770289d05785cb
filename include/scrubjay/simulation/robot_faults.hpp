/// \file
/// What is wrong with a simulated robot's body. Its firmware's own faults are in FirmwareOptions.
#pragma once

#include <array>
#include <limits>

namespace scrubjay::sim {

/// From a time on, until another [s since the start]. By default never.
struct TimeSpan {
  double from = std::numeric_limits<double>::infinity();
  double until = std::numeric_limits<double>::infinity();

  bool contains(double time) const { return from <= time && time < until; }
  bool operator==(const TimeSpan&) const = default;
};

/// By default nothing is.
struct RobotFaults {
  double battery = 1.0;                   ///< charge at the start, as a share of the capacity, 0 to 1
  TimeSpan lifted;                        ///< it hangs in somebody's hands: the wheels turn freely, the floor is gone
  std::array<TimeSpan, 2> stuck_wheel{};  ///< left, right: the wheel doesn't turn, whatever its motor tries

  bool operator==(const RobotFaults&) const = default;
};

}  // namespace scrubjay::sim
