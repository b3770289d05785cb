/// \file
/// Worlds from files: our own YAML (docs/worlds.md), HouseExpo floor plans, and nav2 maps.
#pragma once

#include <filesystem>
#include <scrubjay/mapping/occupancy_grid.hpp>
#include <scrubjay/world/world.hpp>
#include <string>
#include <string_view>

namespace scrubjay {

/// Limits on what a file may ask for; beyond them it is refused.
inline constexpr double kWorldExtent = 1000.0;                ///< coordinates lie within +- this [m]
inline constexpr std::size_t kMaxWorldPoints = 1'000'000;     ///< corners in all
inline constexpr std::size_t kMaxWorldText = 16 * (1 << 20);  ///< [bytes]

/// Reads a world by what the file holds, whatever its name: our YAML, HouseExpo JSON, or the YAML of a nav2 map, whose
/// picture becomes walls (see world_from_map). A world without a name gets that of the file.
/// Throws Error with file, line, field, its value, and what would be right.
World read_world(const std::filesystem::path& path);

/// The same from memory, for our YAML and HouseExpo; `file` stands in the errors.
World parse_world(std::string_view text, const std::string& file);

/// A world with walls along the border between free cells and all others, so that a robot stays where the map knows it
/// is free. Each closed border is one wall, its straight runs merged.
World world_from_map(const OccupancyGrid& map);

}  // namespace scrubjay
