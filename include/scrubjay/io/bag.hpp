/// \file
/// Recordings of ROS 2 messages, whatever their format: topics, and their messages in time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <scrubjay/messages/qos.hpp>
#include <span>
#include <string>
#include <vector>

namespace scrubjay {

struct BagTopic {
  std::string name;        ///< fully qualified, as /map
  std::string type;        ///< as nav_msgs/msg/OccupancyGrid
  std::string definition;  ///< the type's text and that of all it is made of (`ros2msg`); empty if not known
  std::string hash;        ///< RIHS01_ and 64 hexadecimal digits; empty if not known
  ros::Qos qos;            ///< offered by its writer

  bool operator==(const BagTopic&) const = default;
};

/// Appends to a bag.
///
/// write() never throws, for a full disc must not stop a robot that moves: the first failure is kept, later messages
/// are dropped, and close() throws it once.
class BagWriter {
 public:
  virtual ~BagWriter() = default;
  /// Adds a topic, before or between messages, and gives its number: 0, 1, ...
  virtual std::size_t add(const BagTopic& topic) = 0;
  /// Records a message as its bytes went over the wire (CDR, encapsulation included); `topic` is a number that add()
  /// gave. `nanoseconds`: since the epoch of the robot's clock, not negative; what is, becomes 0.
  virtual void write(std::size_t topic, std::int64_t nanoseconds, std::span<const std::byte> bytes) = 0;
  /// Completes the bag and waits until it is on the disc. Nothing may be written afterwards. Throws Error
  /// (Kind::Failure) once if anything failed since the beginning.
  virtual void close() = 0;
};

/// A message of a bag.
struct BagMessage {
  std::size_t topic = 0;             ///< its place in topics()
  std::int64_t nanoseconds = 0;      ///< when it was recorded
  std::span<const std::byte> bytes;  ///< CDR, encapsulation included; valid until the next one is read
};

/// Reads a bag, up to its end or to where it was cut or damaged.
class BagReader {
 public:
  virtual ~BagReader() = default;
  /// All topics that have messages, and maybe more. They may become more while messages are read, at the end.
  virtual const std::vector<BagTopic>& topics() const = 0;
  /// The next message, none at the end; they come in the order of their stamps. Throws Error if the system fails.
  virtual std::optional<BagMessage> next() = 0;
  /// Once next() gave none: whether the bag ends before what close() writes, or bytes were damaged. What came after the
  /// cut or the damage is lost.
  virtual bool cut() const = 0;
};

/// Opens a bag by what it holds, whatever its name: an MCAP file, a folder of rosbag2, or a .db3 out of one. Throws
/// Error if it can't be read or is none of them.
std::unique_ptr<BagReader> open_bag(const std::filesystem::path& path);

/// Begins a bag anew: an MCAP file if the name ends in .mcap, else a folder of rosbag2 with a database. `zstd`: packed,
/// which a database can't be. Throws Error as their writers do.
std::unique_ptr<BagWriter> make_bag_writer(const std::filesystem::path& path, bool zstd = false);

}  // namespace scrubjay
