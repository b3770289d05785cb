/// \file
/// Files that are there whole or not at all.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace scrubjay {

/// Writes a file so that whoever looks, even after a crash, finds the old content or the new, never a part.
///
/// The bytes go to a temporary file in the same folder, which is synced and then renamed over `path`. A symbolic link
/// is followed, so that the file it names is replaced. A file that was there keeps its permissions. Throws Error
/// (Kind::Failure) with the path and the system's reason when that fails (no such folder, no permission, disc full, not
/// a regular file); `path` is then as it was, and the temporary file is gone.
void write_file_atomically(const std::filesystem::path& path, std::span<const std::byte> content);
void write_file_atomically(const std::filesystem::path& path, std::string_view content);

/// Files that belong together, each written as above, and none of them put in place before all are on the disc: a disc
/// that fills up leaves every older one as it was.
class AtomicFiles {
 public:
  AtomicFiles();
  AtomicFiles(const AtomicFiles&) = delete;
  AtomicFiles& operator=(const AtomicFiles&) = delete;
  ~AtomicFiles();  ///< drops what was added since the last commit()

  /// Writes `content` under a temporary name. Throws Error (Kind::Failure).
  void add(const std::filesystem::path& path, std::span<const std::byte> content);
  void add(const std::filesystem::path& path, std::string_view content);
  /// Puts all of them in place, one by one and in order. Throws Error (Kind::Failure).
  void commit();

 private:
  class TemporaryFile;
  std::vector<std::unique_ptr<TemporaryFile>> files_;
};

}  // namespace scrubjay
