/// \file
/// Packets that are bits or enumerations, by name.
#pragma once

#include <cstdint>
#include <scrubjay/oi/sensors.hpp>

namespace scrubjay::oi {

/// Packet 7.
struct BumpsAndWheelDrops {
  bool bump_right = false;
  bool bump_left = false;
  bool wheel_drop_right = false;
  bool wheel_drop_left = false;
  bool wheel_drop_caster = false;  ///< Create 1 and older
  bool bumped() const { return bump_right || bump_left; }
  bool wheel_dropped() const { return wheel_drop_right || wheel_drop_left || wheel_drop_caster; }
  bool operator==(const BumpsAndWheelDrops&) const = default;
};

/// Packet 14, as on Roombas. Create 1 has its low side drivers 1, 0 and 2 in place of the first three.
struct WheelOvercurrents {
  bool side_brush = false;
  bool vacuum = false;  ///< older than the 500 series
  bool main_brush = false;
  bool right_wheel = false;
  bool left_wheel = false;
  bool operator==(const WheelOvercurrents&) const = default;
};

/// Packet 18, whatever the model's order of bits. Buttons that the model lacks are never pressed; a known bug of the
/// firmware keeps `schedule` and `clock` from being reported.
struct PressedButtons {
  bool clean = false;  ///< Play on Create 1
  bool spot = false;
  bool dock = false;  ///< Advance on Create 1
  bool minute = false;
  bool hour = false;
  bool day = false;
  bool schedule = false;
  bool clock = false;
  bool max = false;    ///< Roomba 400
  bool power = false;  ///< Roomba 400
  bool operator==(const PressedButtons&) const = default;
};

/// Packet 21.
enum class ChargingState : std::uint8_t { NotCharging, Reconditioning, FullCharging, TrickleCharging, Waiting, Fault };

/// Packet 34.
struct ChargingSources {
  bool internal_charger = false;
  bool home_base = false;
  bool operator==(const ChargingSources&) const = default;
};

/// Packet 45, in the order of its bits: left to right across the bumper.
struct LightBumper {
  bool left = false;
  bool front_left = false;
  bool center_left = false;
  bool center_right = false;
  bool front_right = false;
  bool right = false;
  bool operator==(const LightBumper&) const = default;
};

/// Packet 58.
struct Stasis {
  bool toggling = false;  ///< the caster turns: forward progress
  bool disabled = false;  ///< the sensor is too dirty to tell
  bool operator==(const Stasis&) const = default;
};

/// Bit `index` of a packet's value.
constexpr bool bit(const Sensors& sensors, PacketId id, int index) {
  return (sensors[id] >> index & 1) != 0;
}

constexpr BumpsAndWheelDrops bumps_and_wheel_drops(const Sensors& s) {
  constexpr PacketId kId = PacketId::BumpsAndWheelDrops;
  return {bit(s, kId, 0), bit(s, kId, 1), bit(s, kId, 2), bit(s, kId, 3), bit(s, kId, 4)};
}

constexpr WheelOvercurrents wheel_overcurrents(const Sensors& s) {
  constexpr PacketId kId = PacketId::WheelOvercurrents;
  return {bit(s, kId, 0), bit(s, kId, 1), bit(s, kId, 2), bit(s, kId, 3), bit(s, kId, 4)};
}

constexpr PressedButtons pressed_buttons(const Sensors& s, Model model) {
  const auto pressed = [&s](int index) { return bit(s, PacketId::Buttons, index); };
  switch (model) {
    case Model::Create1:
      return {.clean = pressed(0), .dock = pressed(2)};
    case Model::Roomba400:
      return {.clean = pressed(1), .spot = pressed(2), .max = pressed(0), .power = pressed(3)};
    case Model::Create2:
      break;
  }
  return {.clean = pressed(0),
          .spot = pressed(1),
          .dock = pressed(2),
          .minute = pressed(3),
          .hour = pressed(4),
          .day = pressed(5),
          .schedule = pressed(6),
          .clock = pressed(7)};
}

constexpr ChargingState charging_state(const Sensors& s) {
  return static_cast<ChargingState>(s[PacketId::ChargingState]);
}

constexpr bool is_charging(ChargingState state) {
  return state == ChargingState::Reconditioning || state == ChargingState::FullCharging ||
         state == ChargingState::TrickleCharging;
}

constexpr ChargingSources charging_sources(const Sensors& s) {
  return {bit(s, PacketId::ChargingSourcesAvailable, 0), bit(s, PacketId::ChargingSourcesAvailable, 1)};
}

constexpr LightBumper light_bumper(const Sensors& s) {
  constexpr PacketId kId = PacketId::LightBumper;
  return {bit(s, kId, 0), bit(s, kId, 1), bit(s, kId, 2), bit(s, kId, 3), bit(s, kId, 4), bit(s, kId, 5)};
}

constexpr Stasis stasis(const Sensors& s) {
  return {bit(s, PacketId::Stasis, 0), bit(s, PacketId::Stasis, 1)};
}

}  // namespace scrubjay::oi
