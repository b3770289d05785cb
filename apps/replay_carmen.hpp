/// \file
/// `scrubjay replay` of a CARMEN log.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "ros_node.hpp"
#include "run_options.hpp"

namespace scrubjay::apps {

/// What only the replay of a CARMEN log is told.
struct CarmenFlags {
  std::optional<std::string> poses;
  std::optional<double> resolution;    ///< [m]
  std::optional<double> forward_cone;  ///< [degrees]
  std::optional<double> robot_radius;  ///< [m]
  std::optional<double> max_range;     ///< [m]
  std::optional<std::string> relations;

  bool operator==(const CarmenFlags&) const = default;
};

void add_carmen_flags(CLI::App& command, CarmenFlags& flags);

/// What any replay is told.
struct ReplayFlags {
  std::string log;
  std::optional<double> speed{};
  std::optional<std::string> out;
  std::optional<std::string> calibration_file;
  CarmenFlags carmen;
  OctomapFlags octomap;
  OutputFlags output;
  RosFlags ros;
};

/// Times real time; 0 is as fast as possible. Nodes of ROS 2 see it as it was.
double replay_speed(const ReplayFlags& flags);
/// A log's name without its folder and its endings, .gz among them.
std::string log_stem(const std::filesystem::path& log);
/// Where the results go: --out, or out/LOG.
std::filesystem::path replay_folder(const ReplayFlags& flags);

/// Maps from the log, and writes and prints the results.
void replay_carmen(const ReplayFlags& flags);

}  // namespace scrubjay::apps
