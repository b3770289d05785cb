/// \file
/// Bags as rosbag2 keeps them: a folder with metadata.yaml and files of messages, in SQLite (the default up to Humble)
/// or in MCAP (from Iron on).
#pragma once

#include <filesystem>
#include <memory>
#include <scrubjay/io/bag.hpp>

namespace scrubjay {

/// Writes a folder NAME with metadata.yaml and NAME_0.db3, a database of schema 4 (Iron to now; Humble reads it too).
///
/// Messages are handed to the system about every second of stamps. A run that was killed leaves a bag that opens as it
/// is: metadata.yaml is there from the beginning, knows every topic and the first stamp as soon as there are messages,
/// and is at most a minute of stamps late with its counts. Its newest messages are in the database's log beside it
/// (.db3-wal), which SQLite reads by itself; the few readers that don't look there miss the last megabyte. Every
/// megabyte, write() waits for the disc: who can't wait writes from a thread of its own.
///
/// An older bag of that name is kept beside it with a `~` at its end until the new one is complete, and put back if
/// that can't be written.
class Rosbag2Writer final : public BagWriter {
 public:
  /// Begins the bag anew. Throws Error if there is a file of that name or a folder with other things than a bag in it,
  /// and Error (Kind::Failure) if it can't be made.
  explicit Rosbag2Writer(const std::filesystem::path& folder);
  Rosbag2Writer(const Rosbag2Writer&) = delete;
  Rosbag2Writer& operator=(const Rosbag2Writer&) = delete;
  ~Rosbag2Writer() override;  ///< as close(), but silent

  /// The same topic again gives the number that it has.
  std::size_t add(const BagTopic& topic) override;
  void write(std::size_t topic, std::int64_t nanoseconds, std::span<const std::byte> bytes) override;
  void close() override;

 private:
  class State;
  std::unique_ptr<State> state_;
};

/// Reads a folder, whose files hold SQLite (schemas 1 to 4, of all distributions) or MCAP; or one .db3 alone.
///
/// A folder without metadata.yaml, as a killed rosbag2 leaves it, is read by its files' names, and counts as cut.
/// Topics whose messages aren't CDR, ROS 2's encoding, are left out.
class Rosbag2Reader final : public BagReader {
 public:
  /// Throws Error if it can't be read, is no bag, or is packed as a whole or message by message (MCAP's own packing is
  /// read). A bag that was cut isn't an error.
  explicit Rosbag2Reader(const std::filesystem::path& path);
  Rosbag2Reader(const Rosbag2Reader&) = delete;
  Rosbag2Reader& operator=(const Rosbag2Reader&) = delete;
  ~Rosbag2Reader() override;

  const std::vector<BagTopic>& topics() const override;
  std::optional<BagMessage> next() override;
  bool cut() const override;

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace scrubjay
