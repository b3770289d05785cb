/// \file
/// `scrubjay doctor --ros2`: who else is in the domain of ROS 2, and whether a run of ours and they hear one another.
#pragma once

#include "ros_node.hpp"

namespace scrubjay::apps {

/// Listens for so long [s], without being a node itself, and prints what it found, as JSON if that is wanted. Throws
/// Error if something is wrong. Without Fast DDS there is none: see no_ros_node.cpp.
void examine_domain(const RosFlags& flags, double listen, bool json);

}  // namespace scrubjay::apps
