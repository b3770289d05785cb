/// \file
/// The messages of `ros_discovery_info`, by which nodes say which readers and writers are theirs.
#pragma once

#include <optional>
#include <scrubjay/messages/cdr.hpp>
#include <scrubjay/ros2/environment.hpp>
#include <span>
#include <string>
#include <vector>

#include "guid.hpp"

namespace scrubjay::ros {

/// Sixteen bytes since Iron, twenty-four before; a message with others would confuse or stop a peer.
std::size_t gid_size(Distribution distribution);

struct NodeInfo {
  std::string space;
  std::string name;
  std::vector<Guid> readers{};
  std::vector<Guid> writers{};

  bool operator==(const NodeInfo&) const = default;
};

/// One participant and its nodes.
struct DiscoveryInfo {
  Guid participant{};
  std::vector<NodeInfo> nodes{};

  bool operator==(const DiscoveryInfo&) const = default;
};

Bytes encode_discovery_info(const DiscoveryInfo& info, std::size_t gid_size);

/// None if that isn't what the bytes are, with identifiers of this size.
std::optional<DiscoveryInfo> decode_discovery_info(std::span<const std::byte> bytes, std::size_t gid_size);

}  // namespace scrubjay::ros
