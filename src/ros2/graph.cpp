#include "graph.hpp"

#include <algorithm>

namespace scrubjay::ros {
namespace {

/// A participant's nodes are kept even where it isn't known yet, but not without end.
constexpr std::size_t kMostParticipants = 1024;

std::string full_name(const NodeInfo& node) {
  return (node.space.ends_with('/') ? node.space : node.space + "/") + node.name;
}

bool has(const NodeInfo& node, const Guid& endpoint) {
  const auto in = [&](const std::vector<Guid>& guids) {
    return std::find(guids.begin(), guids.end(), endpoint) != guids.end();
  };
  return in(node.readers) || in(node.writers);
}

}  // namespace

void Graph::set_participant(const Guid& guid, Peer peer) {
  const std::scoped_lock lock(mutex_);
  Known& known = participants_[guid];
  if (known.order == 0) known.order = ++came_;
  known.peer = std::move(peer);
}

void Graph::remove_participant(const Guid& guid) {
  const std::scoped_lock lock(mutex_);
  participants_.erase(guid);
  std::erase_if(endpoints_, [&](const auto& entry) { return participant_of(entry.first) == guid; });
}

void Graph::set_endpoint(const Guid& guid, Endpoint endpoint) {
  const std::scoped_lock lock(mutex_);
  endpoints_[guid] = std::move(endpoint);
}

void Graph::remove_endpoint(const Guid& guid) {
  const std::scoped_lock lock(mutex_);
  endpoints_.erase(guid);
}

void Graph::set_nodes(DiscoveryInfo info) {
  const std::scoped_lock lock(mutex_);
  if (participants_.size() >= kMostParticipants && !participants_.contains(info.participant)) return;
  participants_[info.participant].nodes = std::move(info.nodes);
}

std::vector<Peer> Graph::peers(const std::vector<Guid>& ours) const {
  const std::scoped_lock lock(mutex_);
  std::map<std::uint64_t, Peer> ordered;
  for (const auto& [guid, known] : participants_) {
    const bool discovered = known.order != 0;
    if (!discovered || std::find(ours.begin(), ours.end(), guid) != ours.end()) continue;
    ordered.emplace(known.order, put_together(guid, known));
  }
  std::vector<Peer> peers;
  for (auto& [order, peer] : ordered) peers.push_back(std::move(peer));
  return peers;
}

Peer Graph::put_together(const Guid& guid, const Known& known) const {
  Peer peer = known.peer;
  for (const NodeInfo& node : known.nodes) peer.nodes.push_back(full_name(node));
  Guid first = guid;
  std::fill(first.begin() + 12, first.end(), std::uint8_t{0});
  for (auto at = endpoints_.lower_bound(first); at != endpoints_.end() && participant_of(at->first) == guid; ++at) {
    Endpoint endpoint = at->second;
    for (const NodeInfo& node : known.nodes) {
      if (has(node, at->first)) endpoint.node = full_name(node);
    }
    peer.endpoints.push_back(std::move(endpoint));
  }
  return peer;
}

}  // namespace scrubjay::ros
