/// \file
/// What the command line and the environment want of a node of ROS 2. Of a build with Fast DDS alone.
#pragma once

#include <scrubjay/ros2/participant.hpp>
#include <string>
#include <vector>

#include "ros_node.hpp"

namespace scrubjay::apps {

/// Of a node as flags, --ros-args and the environment have it. What they ask for in vain goes to `warnings`. Throws
/// Error.
ros::ParticipantOptions ros_options(const RosFlags& flags, std::vector<std::string>& warnings);

}  // namespace scrubjay::apps
