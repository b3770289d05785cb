/// \file
/// Which stream of the run's random numbers goes to whom.
#pragma once

#include <cstdint>

namespace scrubjay::apps {

inline constexpr std::uint64_t kRobotStream = 1;
inline constexpr std::uint64_t kStrategyStream = 2;

}  // namespace scrubjay::apps
