/// \file
/// What the data of commands is made of: speeds, radii, notes, times.
#pragma once

#include <cstdint>
#include <optional>
#include <scrubjay/oi/bounded.hpp>
#include <tuple>

namespace scrubjay::oi {

using Velocity = Bounded<-500, 500>;  ///< [mm/s]
using Duty = Bounded<-255, 255>;      ///< of a wheel's PWM, of 255
using SongSlot = Bounded<0, 15>;      ///< Create 2 has slots 0 to 4 only; the others 0 to 15
using Hour = Bounded<0, 23>;
using Minute = Bounded<0, 59>;
using Ascii = Bounded<32, 126>;

/// Radius of the arc that Drive drives [mm], measured to the robot's centre: left turns are positive.
class Radius {
 public:
  /// Straight ahead.
  constexpr Radius() = default;
  /// From a literal in -2000 to 2000; 1 and -1 spin in place.
  consteval Radius(int literal) : Radius(Bounded<-2000, 2000>(literal)) {}
  constexpr Radius(Bounded<-2000, 2000> radius) : value_(static_cast<std::int16_t>(radius.value())) {}
  static constexpr Radius straight() { return {}; }
  static constexpr Radius spin_clockwise() { return Bounded<-2000, 2000>::clamped(-1); }
  static constexpr Radius spin_counter_clockwise() { return Bounded<-2000, 2000>::clamped(1); }
  /// From -2000 to 2000, or one of the two numbers for straight (-32768 and 32767); none otherwise.
  static constexpr std::optional<Radius> of(int value) {
    if (value == kStraight || value == 0x7FFF) return straight();
    if (const auto radius = Bounded<-2000, 2000>::of(value)) return Radius(*radius);
    return {};
  }

  constexpr bool is_straight() const { return value_ == kStraight; }
  /// As on the wire [mm].
  constexpr int value() const { return value_; }
  bool operator==(const Radius&) const = default;

 private:
  static constexpr std::int16_t kStraight = -0x8000;
  std::int16_t value_ = kStraight;
};

/// Anything that lists its members in the order of the wire.
template <typename T>
concept Fielded = requires {
  T::kFields;
};

template <Fielded T>
constexpr bool operator==(const T& a, const T& b) {
  return std::apply([&](auto... field) { return (... && (a.*field == b.*field)); }, T::kFields);
}

/// One tone of a song. Pitches are MIDI notes, 31 (G, 49.0 Hz) to 127; any other is a rest.
struct Note {
  std::uint8_t pitch = 0;
  std::uint8_t duration = 0;  ///< [1/64 s]
  static constexpr auto kFields = std::tuple{&Note::pitch, &Note::duration};
};

/// When a day's cleaning begins.
struct TimeOfDay {
  Hour hour;
  Minute minute;
  static constexpr auto kFields = std::tuple{&TimeOfDay::hour, &TimeOfDay::minute};
};

}  // namespace scrubjay::oi
