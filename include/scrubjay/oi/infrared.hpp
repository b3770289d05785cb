/// \file
/// Infrared characters (packets 17, 52 and 53): remote controls, docks, virtual walls, lighthouses.
///
/// Source: iRobot Create 2 Open Interface specification (2016), "Characters sent by iRobot devices".
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <scrubjay/oi/model.hpp>
#include <string_view>

namespace scrubjay::oi {

enum class InfraredSource : std::uint8_t { Remote, SchedulingRemote, Dock600, VirtualWall, DiscoveryDock };

struct InfraredCharacter {
  std::uint8_t value = 0;
  std::string_view name;
  InfraredSource source{};
};

/// The table of characters, ascending. The lighthouses' are patterns (see `lighthouse`), "none" depends on the model.
inline constexpr std::array<InfraredCharacter, 32> kInfraredCharacters{{
    {129, "left", InfraredSource::Remote},
    {130, "forward", InfraredSource::Remote},
    {131, "right", InfraredSource::Remote},
    {132, "spot", InfraredSource::Remote},
    {133, "max", InfraredSource::Remote},
    {134, "small", InfraredSource::Remote},
    {135, "medium", InfraredSource::Remote},
    {136, "large/clean", InfraredSource::Remote},
    {137, "stop/pause", InfraredSource::Remote},
    {138, "power", InfraredSource::Remote},
    {139, "arc left", InfraredSource::Remote},
    {140, "arc right", InfraredSource::Remote},
    {141, "drive stop", InfraredSource::Remote},
    {142, "download/send all", InfraredSource::SchedulingRemote},
    {143, "seek dock", InfraredSource::SchedulingRemote},
    {160, "reserved", InfraredSource::Dock600},
    {161, "force field", InfraredSource::Dock600},
    {162, "virtual wall", InfraredSource::VirtualWall},
    {164, "green buoy", InfraredSource::Dock600},
    {165, "green buoy + force field", InfraredSource::Dock600},
    {168, "red buoy", InfraredSource::Dock600},
    {169, "red buoy + force field", InfraredSource::Dock600},
    {172, "red + green buoy", InfraredSource::Dock600},
    {173, "red + green buoy + force field", InfraredSource::Dock600},
    {240, "reserved", InfraredSource::DiscoveryDock},
    {242, "force field", InfraredSource::DiscoveryDock},
    {244, "green buoy", InfraredSource::DiscoveryDock},
    {246, "green buoy + force field", InfraredSource::DiscoveryDock},
    {248, "red buoy", InfraredSource::DiscoveryDock},
    {250, "red buoy + force field", InfraredSource::DiscoveryDock},
    {252, "red + green buoy", InfraredSource::DiscoveryDock},
    {254, "red + green buoy + force field", InfraredSource::DiscoveryDock},
}};

/// The row of a character; null if it has none.
constexpr const InfraredCharacter* infrared_character(std::uint8_t value) {
  for (const InfraredCharacter& row : kInfraredCharacters) {
    if (row.value == value) return &row;
  }
  return nullptr;
}

/// What a receiver reports when it receives nothing.
constexpr std::uint8_t no_character(Model model) {
  return model == Model::Create2 ? 0 : 255;
}

inline constexpr std::uint8_t kVirtualWall = 162;

/// Which of a dock's beams are received together. The way in lies where both buoys are seen.
struct DockBeams {
  bool red = false;
  bool green = false;
  bool force_field = false;  ///< near the dock, all around
  bool any() const { return red || green || force_field; }
  bool operator==(const DockBeams&) const = default;
};

/// The beams in the character of a dock of either kind; none if it isn't one.
constexpr std::optional<DockBeams> dock_beams(std::uint8_t character) {
  const InfraredCharacter* row = infrared_character(character);
  if (row == nullptr || character == 160 || character == 240) return {};
  if (row->source == InfraredSource::Dock600) {
    return DockBeams{(character & 8) != 0, (character & 4) != 0, (character & 1) != 0};
  }
  if (row->source == InfraredSource::DiscoveryDock) {
    return DockBeams{(character & 8) != 0, (character & 4) != 0, (character & 2) != 0};
  }
  return {};
}

/// What the dock of the 600 series makes a receiver report in these beams; 0 in none.
constexpr std::uint8_t dock_character(DockBeams beams) {
  const int bits = (beams.red ? 8 : 0) | (beams.green ? 4 : 0) | (beams.force_field ? 1 : 0);
  return static_cast<std::uint8_t>(bits == 0 ? 0 : 160 | bits);
}

/// A beam of a virtual wall of the "auto on" or lighthouse kind.
struct Lighthouse {
  enum class Beam : std::uint8_t { Fence, ForceField, Green, Red };
  std::uint8_t id = 0;  ///< 1 to 10; 11 while not bound
  bool bound = true;    ///< false: nobody gave the lighthouse an id yet
  Beam beam{};
  bool operator==(const Lighthouse&) const = default;
};

/// The lighthouse in a character 0LLLL0BB; none if it isn't one.
constexpr std::optional<Lighthouse> lighthouse(std::uint8_t character) {
  const auto id = static_cast<std::uint8_t>(character >> 3 & 15);
  if ((character & 0b10000100) != 0 || id < 1 || id > 11) return {};
  return Lighthouse{id, id != 11, static_cast<Lighthouse::Beam>(character & 3)};
}

}  // namespace scrubjay::oi
