/// \file
/// What rosbag2 keeps of a bag beside its messages: metadata.yaml, and the quality of service of each topic.
///
/// Humble passes over what it doesn't know of version 8, and later distributions read it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <scrubjay/io/bag.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace scrubjay {

/// Of the metadata that is written here.
inline constexpr int kBagMetadataVersion = 8;

/// What is in a bag so far.
struct BagMetadata {
  std::string storage{};                  ///< rosbag2's plugin for it: "sqlite3" or "mcap"
  std::string file{};                     ///< name of the file that holds the messages, in the bag's folder
  std::vector<BagTopic> topics{};         ///< their definitions are no part of it
  std::vector<std::uint64_t> messages{};  ///< of each topic
  std::uint64_t total = 0;                ///< of all messages
  std::int64_t first = std::numeric_limits<std::int64_t>::max();  ///< earliest stamp; as rosbag2 has it if none [ns]
  std::int64_t last = 0;                                          ///< latest stamp [ns]

  /// Takes a topic in, without messages, and gives its number.
  std::size_t add(const BagTopic& topic);
  /// Counts a message of the topic of that number.
  void count(std::size_t topic, std::int64_t nanoseconds);
};

/// As YAML, without the root: what stands in sqlite3's table `metadata`, and in MCAP's metadata record `rosbag2` under
/// `serialized_metadata`.
std::string bag_metadata_text(const BagMetadata& metadata);
/// The same under its root `rosbag2_bagfile_information`: a whole metadata.yaml.
std::string bag_metadata_file(const BagMetadata& metadata);

/// A list of one profile, as `offered_qos_profiles` of a sqlite3 topic and of an MCAP channel holds it, with policies
/// as rmw numbers them. What Qos doesn't tell is rmw's default.
std::string qos_text(const ros::Qos& qos);
/// Of such a list, with numbers (to Iron) or words (from Jazzy on). Several writers of a topic offer together what the
/// least of them does, and what isn't understood is rmw's default: nobody's bag fails to open for it.
ros::Qos parse_qos(std::string_view text);

/// What a reader has to know before it looks into a bag's folder.
struct BagFolder {
  std::string storage;             ///< "sqlite3", "mcap" or another plugin of rosbag2
  std::string compression;         ///< format that files or messages are packed with, as "zstd"; empty if they aren't
  std::vector<std::string> files;  ///< names of the files, in the order of time; those of older bags without folders
};

/// Of the content of a metadata.yaml, of any version. Throws Error with `name`, line and field.
BagFolder parse_bag_folder(const std::string& text, const std::string& name);

}  // namespace scrubjay
