/// \file
/// Whether the system gives sockets the room that a map wants.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace scrubjay::ros {

/// Asked for, so that a map of 4 MB goes through without a loss [bytes].
inline constexpr std::uint32_t kSocketBuffer = 4 * 1024 * 1024;

/// What the system's limits make of kSocketBuffer, and how they are raised; empty if nothing. `net_core`: the folder
/// with `rmem_max` and `wmem_max`.
std::string buffer_remark(const std::filesystem::path& net_core = "/proc/sys/net/core");

}  // namespace scrubjay::ros
