/// \file
/// Who else is in the domain, and whether we would hear one another.
#pragma once

#include <scrubjay/messages/qos.hpp>
#include <span>
#include <string>
#include <vector>

namespace scrubjay::ros {

/// The topic by which nodes say what is theirs, as DDS calls it: it is no topic of ROS, below `rt/`.
inline constexpr const char* kDiscoveryInfoTopic = "ros_discovery_info";

/// A reader or a writer.
struct Endpoint {
  bool writes = false;
  std::string topic{};  ///< the full name of ROS, or what DDS calls it where it is none of ROS
  std::string type{};   ///< `nav_msgs/msg/Path`, or what DDS calls it
  std::string hash{};   ///< RIHS01; empty if it isn't told (Humble, other vendors)
  Qos qos{};            ///< depth isn't told by others: 0
  std::string node{};   ///< full name; empty if no node says that it is its own

  bool operator==(const Endpoint&) const = default;
};

/// One participant.
struct Peer {
  std::string name{};     ///< what it calls itself
  std::string enclave{};  ///< empty: none is told, so it is no ROS 2
  std::string vendor{};   ///< of its DDS
  std::string address{};  ///< of its host; empty if unknown, as through shared memory
  std::vector<std::string> nodes{};
  std::vector<Endpoint> endpoints{};

  bool operator==(const Peer&) const = default;
};

/// Why a writer and a reader of one topic don't hear one another: `durability: transient_local is asked for, volatile
/// is offered`. Empty if they do, or if they have nothing to do with each other. A type's hash is no reason.
std::string mismatch(const Endpoint& one, const Endpoint& other);
/// ... and why none of ours and theirs do; empty if one does, or if none is at the other end of their topic.
std::string mismatch(std::span<const Endpoint> ours, const Endpoint& theirs);

/// `reliable, transient_local`
std::string text_of(const Qos& qos);

}  // namespace scrubjay::ros
