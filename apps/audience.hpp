/// \file
/// Who is told of a run as it goes: a bag, nodes of ROS 2, or nobody.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "publishing.hpp"
#include "ros_node.hpp"

namespace scrubjay::apps {

class Audience {
 public:
  /// `bag`, `zstd`: as Publishing takes them. `quiet`: what is told of the node doesn't go to stderr. Throws Error.
  Audience(const RosFlags& ros, bool quiet, const std::optional<std::filesystem::path>& bag = {}, bool zstd = false)
      : node_(ros.wanted ? std::make_unique<RosNode>(ros, quiet) : nullptr), publishing_(bag, zstd) {
    if (node_) publishing_.tell(*node_);
  }

  /// None if there is nobody.
  Publishing* publishing() { return publishing_.wanted() ? &publishing_ : nullptr; }
  RosNode* node() { return node_.get(); }
  /// The run is over: what was published is on its way.
  void finish() {
    if (node_) node_->finish();
  }
  /// Completes the bag. Throws Error if that failed.
  void close() { publishing_.close(); }

 private:
  std::unique_ptr<RosNode> node_;  // outlives what tells it
  Publishing publishing_;          // the last thing that can fail, for it takes an older bag's place
};

}  // namespace scrubjay::apps
