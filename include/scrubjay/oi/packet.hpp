/// \file
/// Every sensor packet and every group of packets of the Open Interface, in one table each.
///
/// Source: iRobot Create 2 Open Interface specification (2016), iRobot Create Open Interface (2006), Roomba Serial
/// Command Interface (2005).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <scrubjay/oi/model.hpp>
#include <string_view>

namespace scrubjay::oi {

/// A sensor packet by its number on the wire. Any number of an enumerator is a packet; no other value is ever made.
enum class PacketId : std::uint8_t {
  BumpsAndWheelDrops = 7,
  Wall,
  CliffLeft,
  CliffFrontLeft,
  CliffFrontRight,
  CliffRight,
  VirtualWall,
  WheelOvercurrents,
  DirtDetect,
  Unused1,
  InfraredCharacterOmni,
  Buttons,
  Distance,
  Angle,
  ChargingState,
  Voltage,
  Current,
  Temperature,
  BatteryCharge,
  BatteryCapacity,
  WallSignal,
  CliffLeftSignal,
  CliffFrontLeftSignal,
  CliffFrontRightSignal,
  CliffRightSignal,
  Unused2,
  Unused3,
  ChargingSourcesAvailable,
  OiMode,
  SongNumber,
  SongPlaying,
  NumberOfStreamPackets,
  RequestedVelocity,
  RequestedRadius,
  RequestedRightVelocity,
  RequestedLeftVelocity,
  LeftEncoderCounts,
  RightEncoderCounts,
  LightBumper,
  LightBumpLeftSignal,
  LightBumpFrontLeftSignal,
  LightBumpCenterLeftSignal,
  LightBumpCenterRightSignal,
  LightBumpFrontRightSignal,
  LightBumpRightSignal,
  InfraredCharacterLeft,
  InfraredCharacterRight,
  LeftMotorCurrent,
  RightMotorCurrent,
  MainBrushMotorCurrent,
  SideBrushMotorCurrent,
  Stasis,
};

inline constexpr std::uint8_t kFirstPacket = 7;
inline constexpr std::uint8_t kLastPacket = 58;
inline constexpr std::size_t kPacketCount = kLastPacket - kFirstPacket + 1;

/// The number on the wire.
constexpr std::uint8_t number(PacketId id) {
  return static_cast<std::uint8_t>(id);
}

/// Values from min to max, both included; empty (none) when min > max.
struct ValueRange {
  std::int32_t min = 1;
  std::int32_t max = 0;

  constexpr bool empty() const { return min > max; }
  constexpr bool contains(std::int32_t value) const { return value >= min && value <= max; }
  bool operator==(const ValueRange&) const = default;
};

/// What the specification says about a packet.
struct PacketInfo {
  PacketId id{};
  std::string_view name;
  std::uint8_t bytes = 0;                      ///< 1 or 2; two bytes come high byte first
  bool is_signed = false;                      ///< two's complement
  std::string_view units;                      ///< "mm", "bits", ...; empty where there is none
  std::array<ValueRange, kModelCount> ranges;  ///< documented, by Model; empty where the model lacks the packet
  ModelSet unused_on{};                        ///< where the bytes mean nothing, so that any value is right

  constexpr ValueRange range(Model model) const { return ranges[static_cast<std::size_t>(model)]; }
  constexpr bool exists_on(Model model) const { return !range(model).empty(); }
  /// All that the bytes can say.
  constexpr ValueRange width() const {
    const std::int32_t count = bytes == 1 ? 0x100 : 0x10000;
    return is_signed ? ValueRange{-count / 2, count / 2 - 1} : ValueRange{0, count - 1};
  }
};

namespace detail {

using Ranges = std::array<ValueRange, kModelCount>;
constexpr Ranges ranges(ValueRange create2, ValueRange create1 = {}, ValueRange roomba400 = {}) {
  return {create2, create1, roomba400};
}
constexpr Ranges everywhere(std::int32_t min, std::int32_t max) {
  return ranges({min, max}, {min, max}, {min, max});
}
constexpr Ranges on_create(std::int32_t min, std::int32_t max) {
  return ranges({min, max}, {min, max});
}
constexpr Ranges on_create2(std::int32_t min, std::int32_t max) {
  return ranges({min, max});
}

// clang-format off
inline constexpr std::array<PacketInfo, kPacketCount> kPacketRows{{
    {PacketId::BumpsAndWheelDrops, "bumps_and_wheel_drops", 1, false, "bits", ranges({0, 15}, {0, 31}, {0, 31})},
    {PacketId::Wall, "wall", 1, false, "bool", everywhere(0, 1)},
    {PacketId::CliffLeft, "cliff_left", 1, false, "bool", everywhere(0, 1)},
    {PacketId::CliffFrontLeft, "cliff_front_left", 1, false, "bool", everywhere(0, 1)},
    {PacketId::CliffFrontRight, "cliff_front_right", 1, false, "bool", everywhere(0, 1)},
    {PacketId::CliffRight, "cliff_right", 1, false, "bool", everywhere(0, 1)},
    {PacketId::VirtualWall, "virtual_wall", 1, false, "bool", everywhere(0, 1)},
    {PacketId::WheelOvercurrents, "wheel_overcurrents", 1, false, "bits", everywhere(0, 31)},
    {PacketId::DirtDetect, "dirt_detect", 1, false, "level", everywhere(0, 255)},
    {PacketId::Unused1, "unused_1", 1, false, "", ranges({0, 0}, {0, 0}, {0, 255}), Model::Create2 | Model::Create1},
    {PacketId::InfraredCharacterOmni, "infrared_character_omni", 1, false, "char", everywhere(0, 255)},
    {PacketId::Buttons, "buttons", 1, false, "bits", everywhere(0, 255)},
    {PacketId::Distance, "distance", 2, true, "mm", everywhere(-32768, 32767)},
    {PacketId::Angle, "angle", 2, true, "deg", everywhere(-32768, 32767)},
    {PacketId::ChargingState, "charging_state", 1, false, "enum", everywhere(0, 5)},
    {PacketId::Voltage, "voltage", 2, false, "mV", everywhere(0, 65535)},
    {PacketId::Current, "current", 2, true, "mA", everywhere(-32768, 32767)},
    {PacketId::Temperature, "temperature", 1, true, "degC", everywhere(-128, 127)},
    {PacketId::BatteryCharge, "battery_charge", 2, false, "mAh", everywhere(0, 65535)},
    {PacketId::BatteryCapacity, "battery_capacity", 2, false, "mAh", everywhere(0, 65535)},
    {PacketId::WallSignal, "wall_signal", 2, false, "raw", ranges({0, 1023}, {0, 4095})},
    {PacketId::CliffLeftSignal, "cliff_left_signal", 2, false, "raw", on_create(0, 4095)},
    {PacketId::CliffFrontLeftSignal, "cliff_front_left_signal", 2, false, "raw", on_create(0, 4095)},
    {PacketId::CliffFrontRightSignal, "cliff_front_right_signal", 2, false, "raw", on_create(0, 4095)},
    {PacketId::CliffRightSignal, "cliff_right_signal", 2, false, "raw", on_create(0, 4095)},
    {PacketId::Unused2, "unused_2", 1, false, "", ranges({0, 255}, {0, 31}), Model::Create2},
    {PacketId::Unused3, "unused_3", 2, false, "", ranges({0, 65535}, {0, 1023}), Model::Create2},
    {PacketId::ChargingSourcesAvailable, "charging_sources_available", 1, false, "bits", on_create(0, 3)},
    {PacketId::OiMode, "oi_mode", 1, false, "enum", on_create(0, 3)},
    {PacketId::SongNumber, "song_number", 1, false, "", on_create(0, 15)},
    {PacketId::SongPlaying, "song_playing", 1, false, "bool", on_create(0, 1)},
    {PacketId::NumberOfStreamPackets, "number_of_stream_packets", 1, false, "", ranges({0, 108}, {0, 43})},
    {PacketId::RequestedVelocity, "requested_velocity", 2, true, "mm/s", on_create(-500, 500)},
    {PacketId::RequestedRadius, "requested_radius", 2, true, "mm", on_create(-32768, 32767)},
    {PacketId::RequestedRightVelocity, "requested_right_velocity", 2, true, "mm/s", on_create(-500, 500)},
    {PacketId::RequestedLeftVelocity, "requested_left_velocity", 2, true, "mm/s", on_create(-500, 500)},
    {PacketId::LeftEncoderCounts, "left_encoder_counts", 2, true, "counts", on_create2(-32768, 32767)},
    {PacketId::RightEncoderCounts, "right_encoder_counts", 2, true, "counts", on_create2(-32768, 32767)},
    {PacketId::LightBumper, "light_bumper", 1, false, "bits", on_create2(0, 127)},
    {PacketId::LightBumpLeftSignal, "light_bump_left_signal", 2, false, "raw", on_create2(0, 4095)},
    {PacketId::LightBumpFrontLeftSignal, "light_bump_front_left_signal", 2, false, "raw", on_create2(0, 4095)},
    {PacketId::LightBumpCenterLeftSignal, "light_bump_center_left_signal", 2, false, "raw", on_create2(0, 4095)},
    {PacketId::LightBumpCenterRightSignal, "light_bump_center_right_signal", 2, false, "raw", on_create2(0, 4095)},
    {PacketId::LightBumpFrontRightSignal, "light_bump_front_right_signal", 2, false, "raw", on_create2(0, 4095)},
    {PacketId::LightBumpRightSignal, "light_bump_right_signal", 2, false, "raw", on_create2(0, 4095)},
    {PacketId::InfraredCharacterLeft, "infrared_character_left", 1, false, "char", on_create2(0, 255)},
    {PacketId::InfraredCharacterRight, "infrared_character_right", 1, false, "char", on_create2(0, 255)},
    {PacketId::LeftMotorCurrent, "left_motor_current", 2, true, "mA", on_create2(-32768, 32767)},
    {PacketId::RightMotorCurrent, "right_motor_current", 2, true, "mA", on_create2(-32768, 32767)},
    {PacketId::MainBrushMotorCurrent, "main_brush_motor_current", 2, true, "mA", on_create2(-32768, 32767)},
    {PacketId::SideBrushMotorCurrent, "side_brush_motor_current", 2, true, "mA", on_create2(-32768, 32767)},
    {PacketId::Stasis, "stasis", 1, false, "bits", on_create2(0, 3)},
}};
// clang-format on

}  // namespace detail

/// The table of packets, in the order of their numbers.
inline constexpr const std::array<PacketInfo, kPacketCount>& kPackets = detail::kPacketRows;

constexpr const PacketInfo& packet_info(PacketId id) {
  return kPackets[static_cast<std::size_t>(number(id) - kFirstPacket)];
}

/// The values that a decoder takes for real.
///
/// The documented range, with two exceptions: unused packets may say anything; and some Wi-Fi Roombas of the 600 series
/// report the mode (35) one too high, so that 4 is a reading (see quirks.hpp) and not noise.
constexpr ValueRange accepted_range(PacketId id, Model model) {
  const PacketInfo& info = packet_info(id);
  if (info.unused_on.contains(model)) return info.width();
  if (id == PacketId::OiMode && model == Model::Create2) return {0, 4};
  return info.range(model);
}

/// A run of packets that is asked for, and sent, as one.
struct GroupInfo {
  std::uint8_t id = 0;
  PacketId first{};
  PacketId last{};
  std::uint8_t bytes = 0;               ///< of all its packets
  std::uint8_t stream_frame_bytes = 0;  ///< of a stream frame that holds this group alone

  /// A model has a group when it has the last packet of it.
  constexpr bool exists_on(Model model) const { return packet_info(last).exists_on(model); }
};

/// The table of groups, ascending.
inline constexpr std::array<GroupInfo, 11> kGroups{{
    {0, PacketId::BumpsAndWheelDrops, PacketId::BatteryCapacity, 26, 30},
    {1, PacketId::BumpsAndWheelDrops, PacketId::Unused1, 10, 14},
    {2, PacketId::InfraredCharacterOmni, PacketId::Angle, 6, 10},
    {3, PacketId::ChargingState, PacketId::BatteryCapacity, 10, 14},
    {4, PacketId::WallSignal, PacketId::ChargingSourcesAvailable, 14, 18},
    {5, PacketId::OiMode, PacketId::RequestedLeftVelocity, 12, 16},
    {6, PacketId::BumpsAndWheelDrops, PacketId::RequestedLeftVelocity, 52, 56},
    {100, PacketId::BumpsAndWheelDrops, PacketId::Stasis, 80, 84},
    {101, PacketId::LeftEncoderCounts, PacketId::Stasis, 28, 32},
    {106, PacketId::LightBumpLeftSignal, PacketId::LightBumpRightSignal, 12, 16},
    {107, PacketId::LeftMotorCurrent, PacketId::Stasis, 9, 13},
}};

/// The group of that number; null if there is none.
constexpr const GroupInfo* group_info(std::uint8_t id) {
  for (const GroupInfo& group : kGroups) {
    if (group.id == id) return &group;
  }
  return nullptr;
}

namespace detail {

/// Where each packet begins in the run of all packets, and one past the end.
inline constexpr auto kOffsets = [] {
  std::array<std::uint8_t, kPacketCount + 1> offsets{};
  for (std::size_t i = 0; i < kPacketCount; ++i) {
    offsets[i + 1] = static_cast<std::uint8_t>(offsets[i] + kPackets[i].bytes);
  }
  return offsets;
}();

constexpr bool tables_add_up() {
  for (std::size_t i = 0; i < kPacketCount; ++i) {
    const PacketInfo& packet = kPackets[i];
    if (number(packet.id) != kFirstPacket + i) return false;
    for (const ValueRange& range : packet.ranges) {
      if (range.empty()) continue;
      if (!packet.width().contains(range.min) || !packet.width().contains(range.max)) return false;
    }
  }
  for (const GroupInfo& group : kGroups) {
    const std::size_t first = static_cast<std::size_t>(number(group.first) - kFirstPacket);
    const std::size_t last = static_cast<std::size_t>(number(group.last) - kFirstPacket);
    if (kOffsets[last + 1] - kOffsets[first] != group.bytes) return false;
    if (group.bytes + 4 != group.stream_frame_bytes) return false;  // header, length, id, checksum
  }
  return true;
}
static_assert(tables_add_up(), "a row is out of order, a range exceeds its bytes, or a group isn't its packets' sum");

}  // namespace detail

}  // namespace scrubjay::oi
