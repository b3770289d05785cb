/// \file
/// rmw_dds_common: which nodes a DDS participant has, and which readers and writers are theirs.
#pragma once

#include <cstdint>
#include <scrubjay/messages/fields.hpp>

namespace scrubjay::ros {

/// Since Iron; Humble and older have 24 bytes, the last eight of them 0.
struct Gid {
  static constexpr std::string_view kType = "rmw_dds_common/msg/Gid";
  static constexpr std::string_view kHash = "RIHS01_ab6f21cfbb0a6dbb837161e1110c2051a2850ed9f9c53944d7115d9bcebedf71";
  std::array<char, 16> data{};

  static constexpr auto fields() { return std::tuple(field("data", &Gid::data)); }
  bool operator==(const Gid&) const = default;
};

struct NodeEntitiesInfo {
  static constexpr std::string_view kType = "rmw_dds_common/msg/NodeEntitiesInfo";
  static constexpr std::string_view kHash = "RIHS01_8ffef65ee2d088c63b1e8fcd31e800ba9fc8dbe0ee15ca60d1676de5218087a7";
  BoundedString<256> node_namespace;
  BoundedString<256> node_name;
  std::vector<Gid> reader_gid_seq;
  std::vector<Gid> writer_gid_seq;

  static constexpr auto fields() {
    return std::tuple(field("node_namespace", &NodeEntitiesInfo::node_namespace),
                      field("node_name", &NodeEntitiesInfo::node_name),
                      field("reader_gid_seq", &NodeEntitiesInfo::reader_gid_seq),
                      field("writer_gid_seq", &NodeEntitiesInfo::writer_gid_seq));
  }
  bool operator==(const NodeEntitiesInfo&) const = default;
};

struct ParticipantEntitiesInfo {
  static constexpr std::string_view kType = "rmw_dds_common/msg/ParticipantEntitiesInfo";
  static constexpr std::string_view kHash = "RIHS01_91a0593bacdcc50ea9bdcf849a938b128412cc1ea821245c663bcd26f83c295e";
  Gid gid;
  std::vector<NodeEntitiesInfo> node_entities_info_seq;

  static constexpr auto fields() {
    return std::tuple(field("gid", &ParticipantEntitiesInfo::gid),
                      field("node_entities_info_seq", &ParticipantEntitiesInfo::node_entities_info_seq));
  }
  bool operator==(const ParticipantEntitiesInfo&) const = default;
};

}  // namespace scrubjay::ros
