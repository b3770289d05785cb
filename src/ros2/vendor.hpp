/// \file
/// Whose DDS it is.
#pragma once

#include <cstdint>
#include <string>

namespace scrubjay::ros {

/// By the registry of the Object Management Group, as far as a middleware of ROS 2 is in it; `vendor 1.32` for others.
std::string vendor_name(std::uint8_t first, std::uint8_t second);

}  // namespace scrubjay::ros
