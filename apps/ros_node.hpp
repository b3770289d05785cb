/// \file
/// A run as a node of ROS 2. Without Fast DDS there is none: see no_ros_node.cpp.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <scrubjay/messages/log_queue.hpp>
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
/// --ros2, which does `what`, and the above.
void add_ros_flags(CLI::App& command, RosFlags& flags, const char* what = "be a node of ROS 2; in real time then");
/// Takes `--ros-args ... [--]` out of the words of the command line, for the node to come. Throws Error.
void take_ros_words(std::vector<std::string>& words);

/// What is told of it goes to stderr and to /rosout: what goes wrong with DDS, what others ask for in vain, that nobody
/// listens.
class RosNode {
 public:
  /// A node as flags, --ros-args and the environment have it. `quiet`: nothing goes to stderr. Throws Error if it can't
  /// be.
  RosNode(const RosFlags& flags, bool quiet);
  RosNode(const RosNode&) = delete;
  RosNode& operator=(const RosNode&) = delete;
  ~RosNode();

  std::string name() const;  ///< full name
  ros::MessageSink& sink();
  ros::LogQueue& log();  ///< what is told of it, for /rosout
  /// Others steer from now on.
  Steering& steering(const RobotModel& robot);
  /// Keeps lines for stderr back until finish(), as long as the terminal is drawn on.
  void hold_lines();
  /// Tells what others wanted in vain, and what didn't get to them. To be called when the run is over, before its last
  /// messages.
  void sum_up();
  /// Waits until what was published is on its way.
  void finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace scrubjay::apps
