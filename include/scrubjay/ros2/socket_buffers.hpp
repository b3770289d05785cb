/// \file
/// Whether the system gives sockets the room that a map wants.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <scrubjay/finding.hpp>

namespace scrubjay::ros {

/// Asked for, so that a map of 4 MB goes through without a loss [bytes].
inline constexpr std::uint32_t kSocketBuffer = 4 * 1024 * 1024;

/// That the system's limits leave less than kSocketBuffer, and how they are raised; none if they don't. `net_core`: the
/// folder with `rmem_max` and `wmem_max`.
std::optional<Finding> clamped_buffers(const std::filesystem::path& net_core = "/proc/sys/net/core");

}  // namespace scrubjay::ros
