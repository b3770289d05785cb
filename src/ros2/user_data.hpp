/// \file
/// The words `key=value;` that participants and endpoints of ROS 2 carry for one another.
#pragma once

#include <string>
#include <string_view>

namespace scrubjay::ros {

/// `enclave=/;`, `typehash=RIHS01_...;`
inline std::string user_data(std::string_view key, std::string_view value) {
  return std::string(key) + "=" + std::string(value) + ";";
}

/// The value of `key`; empty if there is none.
inline std::string value_in(std::string_view data, std::string_view key) {
  while (!data.empty()) {
    const std::string_view word = data.substr(0, data.find(';'));
    data.remove_prefix(std::min(data.size(), word.size() + 1));
    if (word.size() > key.size() && word.starts_with(key) && word[key.size()] == '=') {
      return std::string(word.substr(key.size() + 1));
    }
  }
  return {};
}

/// `nav_msgs::msg::dds_::Path_` as ROS has it, `nav_msgs/msg/Path`; another name as it is.
std::string ros_type_name(std::string_view dds_name);

}  // namespace scrubjay::ros
