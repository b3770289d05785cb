/// \file
/// What the others in a domain tell of themselves, put together.
#pragma once

#include <map>
#include <mutex>
#include <scrubjay/ros2/peers.hpp>
#include <vector>

#include "discovery_info.hpp"
#include "guid.hpp"

namespace scrubjay::ros {

/// May be told and asked from any thread.
class Graph {
 public:
  void set_participant(const Guid& guid, Peer peer);
  void remove_participant(const Guid& guid);
  void set_endpoint(const Guid& guid, Endpoint endpoint);
  void remove_endpoint(const Guid& guid);
  void set_nodes(DiscoveryInfo info);
  /// All participants but `ours`, in the order in which they came.
  std::vector<Peer> peers(const std::vector<Guid>& ours) const;

 private:
  struct Known {
    std::uint64_t order = 0;
    Peer peer{};
    std::vector<NodeInfo> nodes{};
  };

  Peer put_together(const Guid& guid, const Known& known) const;

  mutable std::mutex mutex_;
  std::uint64_t came_ = 0;
  std::map<Guid, Known> participants_;
  std::map<Guid, Endpoint> endpoints_;  ///< those of a participant are neighbours
};

}  // namespace scrubjay::ros
