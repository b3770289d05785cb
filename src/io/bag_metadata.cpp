#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <charconv>
#include <scrubjay/error.hpp>
#include <scrubjay/io/bag_metadata.hpp>

#include "yaml_field.hpp"

namespace scrubjay {
namespace {

// As rmw numbers policies (rmw/types.h).
constexpr int kKeepLast = 1;
constexpr int kReliable = 1;
constexpr int kBestEffort = 2;
constexpr int kTransientLocal = 1;
constexpr int kVolatile = 2;
constexpr int kAutomatic = 1;
// rmw's RMW_DURATION_INFINITE, the largest int64 of nanoseconds.
constexpr std::int64_t kForeverSeconds = 9223372036;
constexpr std::int64_t kForeverRest = 854775807;

std::string topic_text(const BagTopic& topic, std::uint64_t messages) {
  return fmt::format(
      "  - topic_metadata:\n"
      "      name: {}\n"
      "      type: {}\n"
      "      serialization_format: cdr\n"
      "      offered_qos_profiles: {}\n"
      "      type_description_hash: {}\n"
      "    message_count: {}\n",
      quoted(topic.name), quoted(topic.type), quoted(qos_text(topic.qos)), quoted(topic.hash), messages);
}

std::string forever_text(std::string_view name) {
  return fmt::format("  {}:\n    sec: {}\n    nsec: {}\n", name, kForeverSeconds, kForeverRest);
}

std::string scalar_of(const YAML::Node& map, const char* key) {
  const YAML::Node node = map[key];
  return node && node.IsScalar() ? node.Scalar() : "";
}

ros::Qos parse_profile(const YAML::Node& profile) {
  ros::Qos qos;
  if (!profile.IsMap()) return qos;
  const std::string reliability = scalar_of(profile, "reliability");
  if (reliability == std::to_string(kBestEffort) || reliability == "best_effort") {
    qos.reliability = ros::Reliability::BestEffort;
  }
  const std::string durability = scalar_of(profile, "durability");
  if (durability == std::to_string(kTransientLocal) || durability == "transient_local") {
    qos.durability = ros::Durability::TransientLocal;
  }
  // Discovery tells no depth, so that rosbag2 mostly writes 0.
  const std::string depth = scalar_of(profile, "depth");
  int value = 0;
  const auto [stop, error] = std::from_chars(depth.data(), depth.data() + depth.size(), value);
  if (error == std::errc() && stop == depth.data() + depth.size() && value > 0) qos.depth = value;
  return qos;
}

/// What both offer.
ros::Qos least(const ros::Qos& a, const ros::Qos& b) {
  return {std::min(a.reliability, b.reliability), std::min(a.durability, b.durability), std::min(a.depth, b.depth)};
}

/// `file` of `bag/file`: old bags name the folder, too, which may be called otherwise by now.
std::string file_name(const std::string& path) {
  return path.substr(path.find_last_of('/') + 1);
}

}  // namespace

std::size_t BagMetadata::add(const BagTopic& topic) {
  topics.push_back(topic);
  messages.push_back(0);
  return topics.size() - 1;
}

void BagMetadata::count(std::size_t topic, std::int64_t nanoseconds) {
  ++messages[topic];
  ++total;
  first = std::min(first, nanoseconds);
  last = std::max(last, nanoseconds);
}

std::string bag_metadata_text(const BagMetadata& metadata) {
  const std::int64_t duration = metadata.total > 0 ? metadata.last - metadata.first : 0;
  std::string text = fmt::format(
      "version: {}\n"
      "storage_identifier: {}\n"
      "duration:\n"
      "  nanoseconds: {}\n"
      "starting_time:\n"
      "  nanoseconds_since_epoch: {}\n"
      "message_count: {}\n",
      kBagMetadataVersion, metadata.storage, duration, metadata.first, metadata.total);
  text += metadata.topics.empty() ? "topics_with_message_count: []\n" : "topics_with_message_count:\n";
  for (std::size_t i = 0; i < metadata.topics.size(); ++i) {
    text += topic_text(metadata.topics[i], metadata.messages[i]);
  }
  return text + fmt::format(
                    "compression_format: \"\"\n"
                    "compression_mode: \"\"\n"
                    "relative_file_paths:\n"
                    "  - {0}\n"
                    "files:\n"
                    "  - path: {0}\n"
                    "    starting_time:\n"
                    "      nanoseconds_since_epoch: {1}\n"
                    "    duration:\n"
                    "      nanoseconds: {2}\n"
                    "    message_count: {3}\n"
                    "custom_data: ~\n"
                    "ros_distro: scrubjay\n",
                    quoted(metadata.file), metadata.first, duration, metadata.total);
}

std::string bag_metadata_file(const BagMetadata& metadata) {
  std::string text = "rosbag2_bagfile_information:\n  ";
  const std::string body = bag_metadata_text(metadata);
  for (std::size_t i = 0; i < body.size(); ++i) {
    text += body[i];
    if (body[i] == '\n' && i + 1 < body.size()) text += "  ";
  }
  return text;
}

std::string qos_text(const ros::Qos& qos) {
  const bool reliable = qos.reliability == ros::Reliability::Reliable;
  const bool latched = qos.durability == ros::Durability::TransientLocal;
  return fmt::format(
      "- history: {}\n"
      "  depth: {}\n"
      "  reliability: {}\n"
      "  durability: {}\n"
      "{}{}"
      "  liveliness: {}\n"
      "{}"
      "  avoid_ros_namespace_conventions: false",
      kKeepLast, qos.depth, reliable ? kReliable : kBestEffort, latched ? kTransientLocal : kVolatile,
      forever_text("deadline"), forever_text("lifespan"), kAutomatic, forever_text("liveliness_lease_duration"));
}

ros::Qos parse_qos(std::string_view text) {
  try {
    const YAML::Node profiles = YAML::Load(std::string(text));
    if (!profiles.IsSequence() || profiles.size() == 0) return {};
    ros::Qos qos = parse_profile(profiles[0]);
    for (std::size_t i = 1; i < profiles.size(); ++i) qos = least(qos, parse_profile(profiles[i]));
    return qos;
  } catch (const YAML::Exception&) {
    return {};
  }
}

BagFolder parse_bag_folder(const std::string& text, const std::string& name) {
  const YamlField info = YamlField::parse(text, name).at("rosbag2_bagfile_information");
  BagFolder folder;
  folder.storage = info.at("storage_identifier").text();
  if (info.has("compression_format")) folder.compression = info.at("compression_format").text();
  for (const YamlField& file : info.at("relative_file_paths").items()) {
    folder.files.push_back(file_name(file.text()));
    const std::string& last = folder.files.back();
    if (last.empty() || last == "." || last == "..") file.fail("the name of a file");
  }
  return folder;
}

}  // namespace scrubjay
