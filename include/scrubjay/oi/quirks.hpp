/// \file
/// What real firmware does otherwise than the specification says, as data; and the rules of Safe mode.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <scrubjay/oi/mode.hpp>
#include <string_view>

namespace scrubjay::oi {

/// A release of the firmware.
struct Release {
  int major_number = 0;
  int minor_number = 0;
  int patch = 0;
  auto operator<=>(const Release&) const = default;
};

/// The release that a boot banner names, as in "r3_robot/tags/release-3.5.2:6058 CLEAN" or "release-stm32-3.7.5",
/// anywhere in the text; none if it names none.
std::optional<Release> parse_release(std::string_view banner);

/// Defaults: firmware that keeps to the specification, but for the encoders' signs, which no firmware knows.
struct FirmwareQuirks {
  double angle_divisor = 1.0;           ///< packet 20 divided by it is degrees
  bool distance_wrong = false;          ///< packet 19 says nothing: use the encoders
  bool requested_radius_wrong = false;  ///< packet 40 says nothing
  bool mode_one_too_high = false;       ///< packet 35 reports 2 for Passive, 3 for Safe, 4 for Full
  bool sign_from_command = true;        ///< encoders count the way the wheels were told to turn, not the way they do
  bool swapped_encoders = false;        ///< 43 is the right wheel and 44 the left one, as the Roomba 500 document says
  bool operator==(const FirmwareQuirks&) const = default;
};

/// The quirks that follow from the release. `mode_one_too_high` (some Wi-Fi robots of the 600 series) and
/// `swapped_encoders` don't: they are found out on the robot.
constexpr FirmwareQuirks quirks_of(const Release& release) {
  FirmwareQuirks quirks;
  if (release < Release{3, 4, 1}) quirks.angle_divisor = 0.324056;
  quirks.distance_wrong = quirks.requested_radius_wrong = release < Release{3, 3, 0};
  return quirks;
}

/// Degrees turned, counter-clockwise, from a reading of packet 20.
constexpr double corrected_angle(std::int32_t reported, const FirmwareQuirks& quirks) {
  return reported / quirks.angle_divisor;
}

/// The mode from a reading of packet 35; none if the reading is no mode.
constexpr std::optional<OiMode> corrected_mode(std::int32_t reported, const FirmwareQuirks& quirks) {
  const std::int32_t mode = reported - (quirks.mode_one_too_high ? 1 : 0);
  if (mode < 0 || mode > 3) return {};
  return static_cast<OiMode>(mode);
}

/// Whether a reading of packet 35 is one too high, of a robot that is known to be in `mode`.
constexpr bool is_one_too_high(std::int32_t reported, OiMode mode) {
  return reported == static_cast<std::int32_t>(mode) + 1;
}

/// Encoder counts as those of the wheels.
struct EncoderCounts {
  std::int32_t left = 0;
  std::int32_t right = 0;
  bool operator==(const EncoderCounts&) const = default;
};

/// The wheels' counts from readings of packets 43 and 44.
constexpr EncoderCounts corrected_encoders(std::int32_t packet43, std::int32_t packet44, const FirmwareQuirks& quirks) {
  return quirks.swapped_encoders ? EncoderCounts{packet44, packet43} : EncoderCounts{packet43, packet44};
}

/// Counts from `before` to `now`, -32768 to 32767, of a 16-bit counter that wraps around; readings may be signed or
/// not.
constexpr std::int32_t encoder_difference(std::int32_t now, std::int32_t before) {
  return static_cast<std::int16_t>(static_cast<std::uint16_t>(now) - static_cast<std::uint16_t>(before));
}

/// What Safe mode watches.
struct SafetyInputs {
  bool wheel_drop = false;
  bool cliff = false;
  bool charger = false;    ///< plugged in and live
  int right_velocity = 0;  ///< commanded [mm/s]
  int left_velocity = 0;   ///< commanded [mm/s]
  bool operator==(const SafetyInputs&) const = default;
};

/// Whether a robot that drives like this heeds its cliff sensors: forward, or backward on an arc of a radius smaller
/// than its own, which swings the front. Not while it stands or spins in place.
bool heeds_cliffs(int right_velocity, int left_velocity);

/// The mode that follows. Safe falls back to Passive when a wheel drops, a charger is plugged in, or a cliff opens that
/// the robot heeds; the other modes stay (OI specification, "Safe Mode").
OiMode mode_after_safety(OiMode mode, const SafetyInputs& inputs);

}  // namespace scrubjay::oi
