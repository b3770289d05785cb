/// \file
/// Security's files as the properties of DDS Security's built-in plugins.
#pragma once

#include <scrubjay/ros2/keystore.hpp>
#include <string>
#include <utility>
#include <vector>

namespace scrubjay::ros {

/// Names and values, as rmw_fastrtps sets them (DDS Security 1.1, 9).
std::vector<std::pair<std::string, std::string>> security_properties(const SecurityFiles& files);

}  // namespace scrubjay::ros
