/// \file
/// A robot's body as ROS tools want to know it.
#pragma once

#include <filesystem>
#include <optional>
#include <scrubjay/messages/publications.hpp>
#include <string>
#include <vector>

namespace scrubjay {

struct RobotDescription {
  std::string urdf;                     ///< the file's text
  std::vector<ros::FixedLink> fixed;    ///< all links at the end of a fixed joint, by name
  std::optional<ros::WheelLink> left;   ///< of two links that turn without end, the one farther to the left ...
  std::optional<ros::WheelLink> right;  ///< ... and the other
};

/// Throws Error with the path for what isn't a URDF robot.
RobotDescription read_robot_description(const std::filesystem::path& path);

}  // namespace scrubjay
