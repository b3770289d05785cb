/// \file
/// A whole file in memory.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace scrubjay {

/// Throws Error with the path and the system's reason.
std::vector<std::uint8_t> read_file(const std::filesystem::path& path);

}  // namespace scrubjay
