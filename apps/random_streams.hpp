/// \file
/// Which stream of the run's random numbers goes to whom.
#pragma once

#include <cstdint>

namespace scrubjay::apps {

inline constexpr std::uint64_t kRobotStream = 1;
inline constexpr std::uint64_t kStrategyStream = 2;
inline constexpr std::uint64_t kWireStream = 3;
inline constexpr std::uint64_t kStreamsPerRobot = 16;  ///< those of robot i start at i times this

}  // namespace scrubjay::apps
