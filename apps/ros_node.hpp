/// \file
/// A run as a node of ROS 2. Without Fast DDS there is none: see no_ros_node.cpp.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <scrubjay/messages/message_sink.hpp>
#include <string>
#include <vector>

#include "steering.hpp"

namespace scrubjay::apps {

struct RosFlags {
  bool wanted = false;
  std::optional<std::string> distro;
};

void add_ros_distro_flag(CLI::App& command, RosFlags& flags);
/// --ros2, and the above.
void add_ros_flags(CLI::App& command, RosFlags& flags);
/// Takes `--ros-args ... [--]` out of the words of the command line, for the node to come. Throws Error.
void take_ros_words(std::vector<std::string>& words);

class RosNode {
 public:
  /// A node as flags, --ros-args and the environment have it; what is to be told of it goes to stderr unless `quiet`.
  /// Throws Error if it can't be.
  RosNode(const RosFlags& flags, bool quiet);
  RosNode(const RosNode&) = delete;
  RosNode& operator=(const RosNode&) = delete;
  ~RosNode();

  ros::MessageSink& sink();
  /// Others steer from now on.
  Steering& steering(const RobotModel& robot);
  /// Waits until what was published is on its way, and says what others wanted in vain.
  void finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace scrubjay::apps
