/// \file
/// A file that grows while something runs, and takes the place of an older one once it is complete.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace scrubjay {

/// Appending never throws, for a full disc must not stop a robot that moves: the first failure is kept, what comes
/// later is dropped, and throw_failure() tells it once.
class GrowingFile {
 public:
  /// What such a file is, for its errors ("the recording"), and whether one is complete.
  struct Kind {
    const char* name;
    bool (*is_whole)(const std::filesystem::path&);
  };

  /// Begins the file anew, with `head`. `end` stands behind all that was appended, until more is; not in a pipe. What
  /// couldn't be written whole is then taken away again.
  ///
  /// An older file of that name is kept beside it with a `~` at its end. A whole one that an earlier run has put aside,
  /// and that was killed before its own one was whole, stays where it is instead. Throws Error (Kind::Failure) if the
  /// file can't be made; the older one is then in its place again.
  GrowingFile(const std::filesystem::path& path, const Kind& kind, std::span<const std::byte> head,
              std::span<const std::byte> end = {});
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;
  ~GrowingFile();  ///< leaves everything as a kill would

  bool open() const { return file_ >= 0; }
  bool writable() const { return open() && !failed_; }
  /// Hands `bytes` to the system.
  void append(std::span<const std::byte> bytes);
  /// Hands over the `last` bytes, more than the end, which they replace, waits until all is on the disc, and closes the
  /// file. The older one is gone then; where anything failed, it is back in its place.
  void complete(std::span<const std::byte> last);
  /// Throws Error (Kind::Failure) once if anything failed.
  void throw_failure();

 private:
  void hand_over(std::span<const std::byte> bytes, std::size_t staying);
  bool write(std::span<const std::byte> bytes);
  void cut_back();
  void put_back();

  std::string name_;
  Kind kind_;
  std::optional<std::filesystem::path> older_;  ///< where the older file of that name is
  std::vector<std::byte> end_;
  std::vector<std::byte> with_end_;  ///< what is handed over next; kept, for large memory is dear to get
  int file_ = -1;
  std::uint64_t size_ = 0;  ///< of all that was appended, the end not counted
  int failure_ = 0;         ///< errno of the first failure that was not told yet
  bool failed_ = false;
};

}  // namespace scrubjay
