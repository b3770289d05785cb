/// \file
/// What a topic's writer offers, or its reader asks for.
#pragma once

#include <cstdint>

namespace scrubjay::ros {

enum class Reliability : std::uint8_t { BestEffort, Reliable };
enum class Durability : std::uint8_t { Volatile, TransientLocal };

/// The part of a DDS endpoint's quality of service that we choose; all else is rmw's default.
struct Qos {
  Reliability reliability = Reliability::Reliable;
  Durability durability = Durability::Volatile;
  int depth = 10;  ///< samples kept, of the newest (KEEP_LAST)

  bool operator==(const Qos&) const = default;
};

/// Who comes late gets the newest one.
inline constexpr Qos kLatched{Reliability::Reliable, Durability::TransientLocal, 1};

}  // namespace scrubjay::ros
