/// \file
/// What a file is, by what it holds.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace scrubjay {

enum class FileKind : std::uint8_t {
  Recording,
  World,
  HouseExpoPlan,
  MapYaml,
  Scenario,
  Image,
  Urdf,
  Trajectory,
  CarmenLog,
  Octomap,
  Calibration,
  Bag,
  Unknown
};

/// "recording", "world", ...
std::string_view to_string(FileKind kind);

/// Looks at the beginning, whatever the name; a folder may be a bag. Throws Error if the file can't be read.
FileKind file_kind(const std::filesystem::path& path);

}  // namespace scrubjay
