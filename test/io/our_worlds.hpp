/// \file
/// The worlds of this repository.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace scrubjay::test {

/// Their names, sorted, without a folder or an extension.
inline std::vector<std::string> our_worlds() {
  std::vector<std::string> names;
  for (const auto& file : std::filesystem::directory_iterator(std::filesystem::path(SCRUBJAY_SOURCE_DIR) / "worlds")) {
    if (file.path().extension() == ".yaml") names.push_back(file.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace scrubjay::test
