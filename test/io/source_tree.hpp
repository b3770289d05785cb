/// \file
/// Where the files of this repository are.
#pragma once

#include <filesystem>
#include <string>

namespace scrubjay {

inline std::filesystem::path in_tree(const std::string& path) {
  return std::filesystem::path(SCRUBJAY_SOURCE_DIR) / path;
}

}  // namespace scrubjay
