/// \file
/// Bytes of a file that may be far larger than the memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace scrubjay::mcap {

class Source {
 public:
  virtual ~Source() = default;
  /// As it was in the beginning; what a file grows by since isn't seen [bytes].
  virtual std::uint64_t size() const = 0;
  /// Fills `out` from `position` on, all of it within the size. Throws Error if the system fails at that; false if the
  /// file was cut in the meantime.
  virtual bool read(std::uint64_t position, std::span<std::byte> out) const = 0;
};

/// Throws Error if the file can't be read. What has no size (a pipe) is read whole.
std::unique_ptr<Source> open_source(const std::filesystem::path& path);
std::unique_ptr<Source> memory_source(std::vector<std::uint8_t> bytes);

/// Steps through a source, reading some bytes ahead.
class Cursor {
 public:
  explicit Cursor(const Source& source) : source_(source) {}

  std::uint64_t position() const { return position_; }
  std::uint64_t left() const { return source_.size() - position_; }
  /// The next `count` bytes, of kAhead at most; none if there are fewer. Valid until the next call.
  std::span<const std::byte> peek(std::size_t count);
  /// `count` at most left().
  void skip(std::uint64_t count) { position_ += count; }

  static constexpr std::size_t kAhead = 4096;

 private:
  const Source& source_;
  std::uint64_t position_ = 0;
  std::uint64_t ahead_at_ = 0;  ///< where `ahead_` begins
  std::vector<std::byte> ahead_;
};

}  // namespace scrubjay::mcap
