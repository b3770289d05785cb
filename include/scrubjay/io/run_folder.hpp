/// \file
/// The folder that a run is to leave its files in.
#pragma once

#include <filesystem>
#include <vector>

namespace scrubjay {

/// Makes a folder, with those above it that are missing, and finds out whether it can be written to: before a run, so
/// that none is in vain. What it made and nothing came into goes with it.
class RunFolder {
 public:
  /// Throws Error (Kind::Failure) if it can't be made, or isn't to be written to.
  explicit RunFolder(const std::filesystem::path& folder);
  RunFolder(RunFolder&&) = default;
  RunFolder& operator=(RunFolder&&) = delete;
  ~RunFolder();

  const std::filesystem::path& path() const { return path_; }

 private:
  RunFolder(std::filesystem::path folder, std::vector<std::filesystem::path> missing);

  std::filesystem::path path_;
  std::vector<std::filesystem::path> made_;  ///< the lowest first
};

}  // namespace scrubjay
