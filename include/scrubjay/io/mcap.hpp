/// \file
/// Bags in one file: MCAP (mcap.dev/spec, version 0), profile `ros2`, as rosbag2, Foxglove and PlotJuggler open it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <scrubjay/io/bag.hpp>
#include <span>
#include <string>
#include <vector>

namespace scrubjay {

struct McapOptions {
  std::size_t chunk_size = std::size_t{1} << 20;  ///< messages are handed to the system in chunks of about this [bytes]
  bool zstd = false;                              ///< chunks are packed
};

/// Writes one.
///
/// Messages are handed over by the chunk: when there is one's size of them, and every second of stamps. Nothing that
/// was handed over is touched again, but for the last bytes: behind the newest chunk stands an end without a summary,
/// which the next one takes the place of. So a run that was killed leaves a file that every reader opens, and that
/// holds all chunks; only where a write itself was interrupted, the file ends in half a chunk, and readers that look
/// for the end first refuse it. A pipe gets no end before the last.
///
/// An older file of that name is kept beside it with a `~` at its end until the new one is complete, and put back if
/// that can't be written.
class McapWriter final : public BagWriter {
 public:
  /// Begins the file anew. Throws Error (Kind::Failure) if it can't be made.
  explicit McapWriter(const std::filesystem::path& path, const McapOptions& options = {});
  McapWriter(const McapWriter&) = delete;
  McapWriter& operator=(const McapWriter&) = delete;
  ~McapWriter() override;  ///< as close(), but silent

  /// The same topic again gives the number that it has. Throws Error for more of them than MCAP can number (65535).
  std::size_t add(const BagTopic& topic) override;
  void write(std::size_t topic, std::int64_t nanoseconds, std::span<const std::byte> bytes) override;
  void close() override;

 private:
  class State;
  std::unique_ptr<State> state_;
};

/// Reads one, anybody's: in chunks (plain, zstd or lz4) or without, with a summary or without.
///
/// Messages come in the order of their log times, across chunks that overlap in time as well, as long as those which do
/// take no more than kWindow bytes. Checksums are checked where there are any. Channels with messages that aren't CDR,
/// ROS 2's encoding, are left out.
class McapReader final : public BagReader {
 public:
  /// What chunks that overlap in time may take, unpacked [bytes]; beyond it they are read on as they are in the file.
  static constexpr std::size_t kWindow = std::size_t{256} << 20;
  /// What one chunk may take, unpacked [bytes]; a larger one is taken for damage.
  static constexpr std::size_t kLargestChunk = std::size_t{1} << 30;

  /// Throws Error if the file can't be read, is no MCAP file, has another version, or has channels of which none is
  /// ROS 2's. A file cut anywhere behind its first bytes isn't an error.
  explicit McapReader(const std::filesystem::path& path);
  /// The same from memory; `name` stands in the errors.
  McapReader(std::vector<std::uint8_t> file, const std::string& name);
  McapReader(const McapReader&) = delete;
  McapReader& operator=(const McapReader&) = delete;
  ~McapReader() override;

  const std::vector<BagTopic>& topics() const override;
  std::optional<BagMessage> next() override;
  bool cut() const override;

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace scrubjay
