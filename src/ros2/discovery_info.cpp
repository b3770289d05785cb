#include "discovery_info.hpp"

#include <algorithm>
#include <scrubjay/messages/rmw_dds_common.hpp>

namespace scrubjay::ros {
namespace {

/// As it was in Humble and before: never asked for its hash, which came with Iron.
struct LongGid {
  static constexpr std::string_view kType = Gid::kType;
  static constexpr std::string_view kHash{};
  std::array<char, 24> data{};

  static constexpr auto fields() { return std::tuple(field("data", &LongGid::data)); }
};

struct LongNodeEntitiesInfo {
  static constexpr std::string_view kType = NodeEntitiesInfo::kType;
  static constexpr std::string_view kHash{};
  BoundedString<256> node_namespace;
  BoundedString<256> node_name;
  std::vector<LongGid> reader_gid_seq;
  std::vector<LongGid> writer_gid_seq;

  static constexpr auto fields() {
    return std::tuple(field("node_namespace", &LongNodeEntitiesInfo::node_namespace),
                      field("node_name", &LongNodeEntitiesInfo::node_name),
                      field("reader_gid_seq", &LongNodeEntitiesInfo::reader_gid_seq),
                      field("writer_gid_seq", &LongNodeEntitiesInfo::writer_gid_seq));
  }
};

struct LongParticipantEntitiesInfo {
  static constexpr std::string_view kType = ParticipantEntitiesInfo::kType;
  static constexpr std::string_view kHash{};
  LongGid gid;
  std::vector<LongNodeEntitiesInfo> node_entities_info_seq;

  static constexpr auto fields() {
    return std::tuple(field("gid", &LongParticipantEntitiesInfo::gid),
                      field("node_entities_info_seq", &LongParticipantEntitiesInfo::node_entities_info_seq));
  }
};

template <class AnyGid>
AnyGid to_gid(const Guid& guid) {
  AnyGid gid;
  std::copy(guid.begin(), guid.end(), gid.data.begin());
  return gid;
}

template <class AnyGid>
Guid to_guid(const AnyGid& gid) {
  Guid guid{};
  std::copy_n(gid.data.begin(), guid.size(), guid.begin());
  return guid;
}

template <class AnyGid>
std::vector<AnyGid> to_gids(const std::vector<Guid>& guids) {
  std::vector<AnyGid> gids;
  for (const Guid& guid : guids) gids.push_back(to_gid<AnyGid>(guid));
  return gids;
}

template <class AnyGid>
std::vector<Guid> to_guids(const std::vector<AnyGid>& gids) {
  std::vector<Guid> guids;
  for (const AnyGid& gid : gids) guids.push_back(to_guid(gid));
  return guids;
}

template <class Info, class NodeEntities, class AnyGid>
Bytes encode_as(const DiscoveryInfo& info) {
  Info message;
  message.gid = to_gid<AnyGid>(info.participant);
  for (const NodeInfo& node : info.nodes) {
    message.node_entities_info_seq.push_back(
        NodeEntities{{node.space}, {node.name}, to_gids<AnyGid>(node.readers), to_gids<AnyGid>(node.writers)});
  }
  return encode(message);
}

template <class Info>
std::optional<DiscoveryInfo> decode_as(std::span<const std::byte> bytes) {
  const std::optional<Info> message = decode<Info>(bytes);
  // Bytes of the other size may be read as some message of this one, but then they are too many.
  constexpr std::size_t kPadding = 3;
  if (!message || encode(*message).size() + kPadding < bytes.size()) return std::nullopt;
  DiscoveryInfo info{.participant = to_guid(message->gid)};
  for (const auto& node : message->node_entities_info_seq) {
    info.nodes.push_back(
        {node.node_namespace.text, node.node_name.text, to_guids(node.reader_gid_seq), to_guids(node.writer_gid_seq)});
  }
  return info;
}

}  // namespace

std::size_t gid_size(Distribution distribution) {
  return distribution == Distribution::Humble ? sizeof(LongGid) : sizeof(Gid);
}

Bytes encode_discovery_info(const DiscoveryInfo& info, std::size_t gid_size) {
  return gid_size == sizeof(LongGid) ? encode_as<LongParticipantEntitiesInfo, LongNodeEntitiesInfo, LongGid>(info)
                                     : encode_as<ParticipantEntitiesInfo, NodeEntitiesInfo, Gid>(info);
}

std::optional<DiscoveryInfo> decode_discovery_info(std::span<const std::byte> bytes, std::size_t gid_size) {
  return gid_size == sizeof(LongGid) ? decode_as<LongParticipantEntitiesInfo>(bytes)
                                     : decode_as<ParticipantEntitiesInfo>(bytes);
}

}  // namespace scrubjay::ros
