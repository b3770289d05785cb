/// \file
/// Maps as nav2 reads and writes them: a YAML file that describes an image.
#pragma once

#include <cstdint>
#include <filesystem>
#include <scrubjay/io/atomic_file.hpp>
#include <scrubjay/mapping/occupancy_grid.hpp>
#include <string>
#include <vector>

namespace scrubjay {

/// What a pixel says. p is its darkness, or its lightness where the map is negated, from 0 to 1.
enum class MapMode : std::uint8_t {
  Trinary,  ///< p >= occupied_thresh: 100; p <= free_thresh: 0; else unknown
  Scale,    ///< the same at the ends, and 0 to 100 in proportion between; not fully opaque: unknown
  Raw,      ///< the pixel's value is the cell's; above 100: unknown
};

/// Reads a map by its YAML file, whose fields are
/// - `image`: a PGM or PNG, relative to the YAML file; `~/` is the user's home;
/// - `resolution` [m per pixel], `origin` [x, y, yaw] of the lower left corner, in metres;
/// - `free_thresh`, `occupied_thresh`, `negate` (a number or a boolean), and `mode`: trinary (the default), scale or
/// raw.
///
/// The image's top row is the map's last. Throws Error with file, line and field; a yaw other than 0 is refused, since
/// nothing here could honour it. Where the file is valid but likely means something else than its author believes, a
/// line is added to `warnings`.
OccupancyGrid read_map(const std::filesystem::path& path, std::vector<std::string>* warnings = nullptr);

/// Writes `stem`.yaml and its image, `stem`.pgm, or `stem`.png for Scale, both whole or not at all.
///
/// Trinary writes 0 for cells of 65 and more, 254 for cells of 0 to 19, 205 for the rest. Scale and Raw keep every
/// value. Numbers have as many decimals as it takes to read back the same, three or more. Throws Error (Kind::Failure).
void write_map(const std::filesystem::path& stem, GridView<const Occupancy> map, MapMode mode = MapMode::Trinary);
/// The same as two of several files that belong together.
void add_map(AtomicFiles& files, const std::filesystem::path& stem, GridView<const Occupancy> map,
             MapMode mode = MapMode::Trinary);

}  // namespace scrubjay
