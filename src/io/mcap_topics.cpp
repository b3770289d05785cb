#include "mcap_topics.hpp"

#include <algorithm>
#include <scrubjay/io/bag_metadata.hpp>
#include <utility>

namespace scrubjay::mcap {
namespace {

std::string value_of(const TextMap& map, std::string_view key) {
  const auto found = std::find_if(map.begin(), map.end(), [key](const auto& entry) { return entry.first == key; });
  return found == map.end() ? std::string() : found->second;
}

}  // namespace

bool Topics::take(const Record& record) {
  if (record.opcode == Opcode::Schema) {
    std::optional<Schema> schema = parse_schema(record.content);
    if (!schema) return false;
    schemas_.try_emplace(schema->id, std::move(*schema));
  } else if (record.opcode == Opcode::Channel) {
    const std::optional<Channel> channel = parse_channel(record.content);
    return channel && (knows(channel->id) || add(*channel));
  }
  return true;
}

bool Topics::add(const Channel& channel) {
  // Number 0 stands for no schema.
  const auto schema = schemas_.find(channel.schema);
  if (channel.schema != 0 && schema == schemas_.end()) return false;
  if (channel.encoding != kCdr) {
    other_encodings_.insert(channel.encoding);
    channels_[channel.id] = std::nullopt;
    return true;
  }
  BagTopic topic;
  topic.name = channel.topic;
  if (channel.schema != 0) {
    topic.type = schema->second.name;
    if (schema->second.encoding == "ros2msg") topic.definition = schema->second.data;
  }
  topic.hash = value_of(channel.metadata, kHashKey);
  topic.qos = parse_qos(value_of(channel.metadata, kQosKey));
  channels_[channel.id] = number_of(std::move(topic));
  return true;
}

/// Of several writers of one topic, each has a channel.
std::size_t Topics::number_of(BagTopic topic) {
  const auto same = std::find_if(topics_.begin(), topics_.end(), [&topic](const BagTopic& other) {
    return other.name == topic.name && other.type == topic.type;
  });
  const auto number = static_cast<std::size_t>(same - topics_.begin());
  if (same == topics_.end()) topics_.push_back(std::move(topic));
  return number;
}

}  // namespace scrubjay::mcap
