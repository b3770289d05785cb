#include <algorithm>
#include <scrubjay/error.hpp>

#include "doctor_ros2.hpp"
#include "ros_node.hpp"

namespace scrubjay::apps {
namespace {

[[noreturn]] void refuse() {
  throw Error(
      "this scrubjay was built without Fast DDS, so it can't be a node of ROS 2; build it with -DSCRUBJAY_ROS2=ON");
}

}  // namespace

struct RosNode::State {};

void add_ros_distro_flag(CLI::App&, RosFlags&) {}

void add_ros_flags(CLI::App& command, RosFlags& flags, const char*) {
  command.add_flag("--ros2", flags.wanted, "not in this build: there was no Fast DDS");
}

void take_ros_words(std::vector<std::string>& words) {
  if (std::find(words.begin(), words.end(), "--ros-args") != words.end()) refuse();
}

RosNode::RosNode(const RosFlags&, bool) {
  refuse();
}
RosNode::~RosNode() = default;

std::string RosNode::name() const {
  refuse();
}

ros::MessageSink& RosNode::sink() {
  refuse();
}

ros::LogQueue& RosNode::log() {
  refuse();
}

Steering& RosNode::steering(const RobotModel&) {
  refuse();
}

void RosNode::hold_lines() {}

void RosNode::sum_up() {}

void RosNode::finish() {}

void examine_domain(const RosFlags&, double, bool) {
  refuse();
}

}  // namespace scrubjay::apps
