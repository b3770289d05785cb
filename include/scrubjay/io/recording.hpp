/// \file
/// Recordings of all bytes between us and a robot (`.oilog`), from which a run can be repeated exactly.
///
/// The layout, byte by byte, is in docs/recordings.md.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <scrubjay/robot/byte_channel.hpp>
#include <span>
#include <string>
#include <vector>

namespace scrubjay {

/// Stamps are whole nanoseconds in a recording. `stamp` must lie within +-9e9 s; what doesn't is moved to the end.
std::int64_t stamp_to_nanoseconds(double stamp);
/// The double nearest to so many nanoseconds. There and back gives the same double for every stamp that it gave once.
double stamp_from_nanoseconds(std::int64_t nanoseconds);

/// Which way bytes went.
enum class Direction : std::uint8_t { Received, Sent };  ///< from the robot, to the robot

/// How the mission ended that a recording is of. What the robot said while it was stopped is in the recording as well,
/// and is no part of the mission.
struct RecordedEnd {
  std::uint64_t frames = 0;  ///< that the mission took
  std::string why;           ///< as to_string(Ended) has it, UTF-8

  bool operator==(const RecordedEnd&) const = default;
};

/// The most recent chunk of each length from 1 to 255 bytes: what the next one of that length is compared with.
class ChunkHistory {
 public:
  static constexpr std::size_t kMaxLength = 255;
  /// The last chunk of `length`, all zeros at first; 1 <= length <= kMaxLength.
  std::span<std::uint8_t> of_length(std::size_t length) { return {chunks_[length - 1].data(), length}; }

 private:
  std::array<std::array<std::uint8_t, kMaxLength>, kMaxLength> chunks_{};
};

class GrowingFile;

/// Appends to a recording.
///
/// Bytes are handed to the system every 64 KiB and every second of stamps; whatever interrupts the writing, all whole
/// records before it can be read. record() never throws, for a full disc must not stop a robot that moves: the first
/// failure is kept, later bytes are dropped, and flush() or close() throws it once.
class RecordingWriter {
 public:
  /// Begins the file anew. `scenario` is UTF-8 YAML: all that is needed to repeat the run.
  ///
  /// An older file of that name is kept beside it with a `~` at its end until the new one is complete, and put back if
  /// that can't be written. Throws Error (Kind::Failure) if the file can't be made.
  RecordingWriter(const std::filesystem::path& path, const std::string& scenario);
  RecordingWriter(const RecordingWriter&) = delete;
  RecordingWriter& operator=(const RecordingWriter&) = delete;
  ~RecordingWriter();  ///< as close(), but silent

  /// Records bytes that passed at `stamp` [s].
  void record(Direction direction, double stamp, std::span<const std::uint8_t> bytes);
  /// Records how the mission ended, once it has.
  void record_end(const RecordedEnd& end);
  /// Hands everything to the system. Throws Error (Kind::Failure) once if anything failed since the beginning.
  void flush();
  /// Marks the end, flushes, and waits until it is on the disc. Nothing may be recorded afterwards. Throws Error as
  /// flush() does.
  void close();

 private:
  void append(std::uint8_t kind, std::int64_t nanoseconds, std::span<const std::uint8_t> payload);

  std::unique_ptr<GrowingFile> file_;
  std::vector<std::uint8_t> buffer_;
  std::unique_ptr<ChunkHistory> history_ = std::make_unique<ChunkHistory>();
  std::int64_t last_stamp_ = 0;      ///< [ns]
  std::int64_t handed_over_at_ = 0;  ///< [ns]
  std::uint32_t checksum_ = 0;
};

/// Bytes that passed in one go.
struct RecordedBytes {
  Direction direction = Direction::Received;
  double stamp = 0.0;                   ///< [s]
  std::span<const std::uint8_t> bytes;  ///< valid until the next one is read
};

/// Reads a recording, up to its end or to where it was cut or damaged.
class RecordingReader {
 public:
  /// Throws Error if the file can't be read, is no recording or has another version. A file cut anywhere isn't an
  /// error.
  explicit RecordingReader(const std::filesystem::path& path);
  /// The same from memory; `name` stands in the errors.
  RecordingReader(std::vector<std::uint8_t> file, const std::string& name);

  /// The YAML that the recording began with; empty if it was cut before.
  const std::string& scenario() const { return scenario_; }
  /// The next chunk; none at the end.
  std::optional<RecordedBytes> next();
  /// Once next() gave none: how the mission ended, if the recording is of one, and wasn't cut before.
  const std::optional<RecordedEnd>& mission_end() const { return mission_end_; }
  /// Once next() gave none: whether the end that close() writes is missing, by a kill or a cut, or bytes were damaged.
  /// What came after the cut or the damage is lost.
  bool cut() const { return cut_; }

 private:
  struct Record {
    std::uint8_t kind;
    std::span<const std::uint8_t> payload;
  };
  std::optional<Record> next_record();
  std::optional<Record> next_chunk();

  std::vector<std::uint8_t> file_;
  std::size_t position_ = 0;
  bool cut_ = false;
  bool ended_ = false;
  std::string scenario_;
  std::optional<RecordedEnd> mission_end_;
  std::unique_ptr<ChunkHistory> history_ = std::make_unique<ChunkHistory>();
  std::int64_t last_stamp_ = 0;  ///< [ns]
  std::uint32_t checksum_ = 0;
};

/// A channel that records all that passes through it.
///
/// Stamps are rounded to what the recording holds, for the live reader too: replay sees the same doubles.
class RecordingChannel : public ByteChannel {
 public:
  /// Both must outlive it.
  RecordingChannel(ByteChannel& channel, RecordingWriter& writer) : channel_(channel), writer_(writer) {}
  ByteRead read(std::span<std::uint8_t> buffer) override;
  bool write(std::span<const std::uint8_t> bytes) override;

 private:
  ByteChannel& channel_;
  RecordingWriter& writer_;
  double last_stamp_ = 0.0;  ///< of what was read last: written bytes have no stamp of their own [s]
};

/// A channel on which a recording's received bytes arrive again, chunk by chunk with their stamps. Between them are the
/// reads that brought nothing and were answered: a robot that is asked again for a lost reply is so in a replay, too.
///
/// What is written to it goes nowhere. At the end it is no longer open.
class RecordedChannel : public ByteChannel {
 public:
  /// `reader` must outlive it.
  explicit RecordedChannel(RecordingReader& reader) : reader_(reader) {}
  ByteRead read(std::span<std::uint8_t> buffer) override;
  bool write(std::span<const std::uint8_t> bytes) override;

 private:
  RecordingReader& reader_;
  std::span<const std::uint8_t> rest_;  ///< of a chunk that didn't fit into the buffer
  double stamp_ = 0.0;                  ///< of the last read [s]
  bool heard_ = false;                  ///< anything yet
};

}  // namespace scrubjay
