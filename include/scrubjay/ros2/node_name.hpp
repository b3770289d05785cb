/// \file
/// Names of nodes and topics: what is valid, where a relative one is, what the user has in its place.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scrubjay::ros {

/// `-r [node:]from:=to`
struct Remapping {
  std::string from;  ///< `__node`, `__ns`, or a topic
  std::string to;
  std::string node{};  ///< that it is for; empty: every one

  bool operator==(const Remapping&) const = default;
};

/// What stands between `--ros-args` and `--` or the end.
struct RosArguments {
  std::vector<Remapping> remappings{};  ///< in their order: the first that fits is the one
  std::string enclave = "/";            ///< `-e`, `--enclave`
  std::vector<std::string> warnings{};  ///< a line each, about words that mean something to rcl and nothing to us
};

/// Takes all of `--ros-args ... [--]` out of `words`, as rcl's arguments.c does. Throws Error about what isn't valid.
RosArguments take_ros_arguments(std::vector<std::string>& words);

/// A node's name and namespace, and where its topics are.
class NodeNames {
 public:
  /// The node `name` in namespace `space`, or what `__node` and `__ns` make of them. Throws Error if it isn't valid:
  /// letters, digits and `_`, no digit first, 255 of them at most.
  explicit NodeNames(const std::string& name = "scrubjay", const std::string& space = "/",
                     std::vector<Remapping> remappings = {});

  const std::string& name() const { return name_; }
  const std::string& space() const { return space_; }  ///< `/` or `/robot1`
  std::string full_name() const;                       ///< `/robot1/scrubjay`

  /// The full name of a topic as `scan` (relative to the namespace), `~/plan` (private to the node) or `/scan`, and
  /// what it is remapped to: `/robot1/laser`. Throws Error if it isn't valid (rcl's validate_topic_name.c).
  std::string topic(std::string_view topic) const;

 private:
  std::string expanded(std::string_view topic) const;

  std::string name_;
  std::string space_;
  std::vector<Remapping> remappings_;
};

/// The topic of DDS that a topic's full name stands for: `/map` is `rt/map`.
std::string dds_topic(std::string_view full_name);
/// ... and the other way; none for a DDS topic that is no topic of ROS (such as a service's).
std::optional<std::string> topic_of_dds(std::string_view dds_name);

}  // namespace scrubjay::ros
