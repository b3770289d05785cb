/// \file
/// The modes of the Open Interface (packet 35).
#pragma once

#include <cstdint>

namespace scrubjay::oi {

enum class OiMode : std::uint8_t {
  Off,      ///< listens to Start alone
  Passive,  ///< tells what it senses, drives as it likes
  Safe,     ///< obeys, until a wheel drops, a cliff opens or a charger is plugged in
  Full,     ///< obeys, whatever happens
};

/// Some of the modes.
class ModeSet {
 public:
  constexpr ModeSet() = default;
  constexpr ModeSet(OiMode mode) : bits_(static_cast<std::uint8_t>(1U << static_cast<unsigned>(mode))) {}
  constexpr bool contains(OiMode mode) const { return (bits_ & ModeSet(mode).bits_) != 0; }
  friend constexpr ModeSet operator|(ModeSet a, ModeSet b) {
    ModeSet both;
    both.bits_ = a.bits_ | b.bits_;
    return both;
  }
  bool operator==(const ModeSet&) const = default;

 private:
  std::uint8_t bits_ = 0;
};

constexpr ModeSet operator|(OiMode a, OiMode b) {
  return ModeSet(a) | ModeSet(b);
}

inline constexpr ModeSet kActingModes = OiMode::Safe | OiMode::Full;                 ///< motors and lights obey
inline constexpr ModeSet kListeningModes = kActingModes | ModeSet(OiMode::Passive);  ///< all but Off
inline constexpr ModeSet kAnyMode = kListeningModes | ModeSet(OiMode::Off);

}  // namespace scrubjay::oi
