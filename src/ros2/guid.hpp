/// \file
/// What tells participants and endpoints apart.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

namespace scrubjay::ros {

/// RTPS 2.3, 9.3.1: twelve bytes that a participant and all that it has share, four of the one entity.
using Guid = std::array<std::uint8_t, 16>;

/// The participant that an endpoint belongs to.
inline Guid participant_of(Guid guid) {
  constexpr std::array<std::uint8_t, 4> kParticipant{0x00, 0x00, 0x01, 0xc1};  // 9.3.1.3
  std::copy(kParticipant.begin(), kParticipant.end(), guid.begin() + 12);
  return guid;
}

}  // namespace scrubjay::ros
