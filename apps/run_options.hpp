/// \file
/// Flags that several subcommands take.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <scrubjay/geometry/bounds.hpp>
#include <scrubjay/geometry/pose2.hpp>
#include <scrubjay/mission/scenario.hpp>
#include <string>

namespace scrubjay::apps {

/// What a scenario can be told on the command line; what isn't given stays as the scenario has it.
struct ScenarioFlags {
  std::optional<std::string> world;
  std::optional<std::string> scenario_file;
  std::optional<std::string> model;
  std::optional<std::string> strategy;
  std::optional<std::string> noise;
  std::optional<std::uint64_t> seed;
  std::optional<std::string> start;
  std::optional<std::string> localizer;
  std::optional<double> resolution;
  std::optional<double> max_time;
  std::optional<std::string> within;
  bool return_home = false;
  bool motion_distortion = false;
  std::optional<double> forward_cone;  ///< [degrees]
  std::optional<double> robot_radius;  ///< [m]
  std::optional<std::string> calibration_file;
};

void add_scenario_flags(CLI::App& command, ScenarioFlags& flags);
/// The scenario file, if one was named, with the flags over it. Throws Error.
Scenario make_scenario(const ScenarioFlags& flags);
/// The same for a real robot, which brings its world with it: Throws Error for what only a simulated one can be told.
/// Where no model is told, the calibration is left out: the robot that answers decides whether it is its own.
Scenario make_live_scenario(const ScenarioFlags& flags);
/// The flags over a scenario that isn't complete yet, and the strategy and the localizer that suit its model.
void apply_flags(const ScenarioFlags& flags, Scenario& scenario);

void add_calibration_flag(CLI::App& command, std::optional<std::string>& file);
/// The factors of a calibration file. Throws Error; also if it is another model's.
Calibration calibration_for(const std::string& model, const std::string& file);

/// Throws Error if a scenario holds what no run can be made with.
void check_scenario(const Scenario& scenario);
/// Throws Error for a --speed below 0.
void expect_speed(double speed);
/// Checks for flags: what is wrong with `text` as a whole number of 64 bits, or as a number; empty if nothing is.
std::string whole_number(const std::string& text);
std::string number(const std::string& text);

/// "x,y,theta" in metres and radians. Throws Error.
Pose2 parse_pose(const std::string& text, const std::string& flag);

/// A map as an octree.
struct OctomapFlags {
  std::optional<std::string> file;
  double height = 1.0;  ///< [m]
};
void add_octomap_flags(CLI::App& command, OctomapFlags& flags);
/// Throws Error for a height that no wall can have.
void check_octomap(const OctomapFlags& flags);

/// "x0,y0,x1,y1" in metres, the lower left corner first. Throws Error.
Bounds2 parse_bounds(const std::string& text, const std::string& flag);

/// How much to say, and how.
struct OutputFlags {
  bool json = false;
  bool quiet = false;
};

void add_output_flags(CLI::App& command, OutputFlags& flags);

}  // namespace scrubjay::apps
