#include "ros_options.hpp"

#include <fmt/format.h>

#include <scrubjay/error.hpp>
#include <scrubjay/ros2/environment.hpp>

namespace scrubjay::apps {
namespace {

/// As the command line had them; a process has one.
ros::RosArguments& ros_arguments() {
  static ros::RosArguments arguments;
  return arguments;
}

}  // namespace

void add_ros_distro_flag(CLI::App& command, RosFlags& flags) {
  command.add_option("--ros-distro", flags.distro, "humble, iron, jazzy, kilted or rolling\n($ROS_DISTRO, or jazzy)");
}

void add_ros_flags(CLI::App& command, RosFlags& flags, const char* what) {
  command.add_flag("--ros2", flags.wanted, what);
  add_ros_distro_flag(command, flags);
}

void take_ros_words(std::vector<std::string>& words) {
  ros_arguments() = ros::take_ros_arguments(words);
}

ros::ParticipantOptions ros_options(const RosFlags& flags, std::vector<std::string>& warnings) {
  std::optional<ros::Distribution> distro;
  if (flags.distro) {
    distro = ros::distribution_named(*flags.distro);
    if (!distro) {
      throw Error(fmt::format("--ros-distro is {}; want humble, iron, jazzy, kilted or rolling", *flags.distro));
    }
  }
  return ros::participant_options(ros::read_environment(ros::process_variable, distro), ros_arguments(), warnings);
}

}  // namespace scrubjay::apps
