#include "run_options.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <scrubjay/error.hpp>
#include <scrubjay/io/calibration_file.hpp>
#include <scrubjay/io/scenario_file.hpp>
#include <scrubjay/mission/estimation.hpp>
#include <scrubjay/mission/strategies.hpp>

#include "data_folder.hpp"

namespace scrubjay::apps {
namespace {

/// Names between commas, in lines that fit beside the flags on 80 columns.
std::string listed(const std::vector<std::string_view>& names) {
  constexpr std::size_t kColumns = 54;
  std::string text;
  std::size_t column = 0;
  for (const std::string_view name : names) {
    if (column > 0) text += ",";
    const bool full = column + name.size() + 2 > kColumns;
    if (column > 0) text += full ? "\n" : " ";
    column = (full ? 0 : column) + name.size() + 2;
    text += name;
  }
  return text;
}

void expect_world(const Scenario& scenario);
void check_figures(const Scenario& scenario);
void expect_no_lidar_flags(const Scenario& scenario);

}  // namespace

void add_scenario_flags(CLI::App& command, ScenarioFlags& flags) {
  command.add_option("WORLD", flags.world, "world YAML, HouseExpo plan or nav2 map");
  command.add_option("--scenario", flags.scenario_file, "scenario.yaml of an earlier run to repeat");
  command.add_option("--strategy", flags.strategy,
                     fmt::format("{}\n(contact-frontier; frontiers with a lidar)", listed(strategy_names())));
  command.add_option("--model", flags.model,
                     "roomba-600, create-2, create-1, roomba-400,\nturtlebot3-burger or a URDF file (roomba-600)");
  command.add_option("--localizer", flags.localizer, "odometry, scan-matching (what the senses allow)");
  command.add_option("--noise", flags.noise, "none, hard-floor, carpet, uncalibrated (none)");
  command.add_option("--seed", flags.seed, "same seed, same run (1)")->check(whole_number);
  command.add_option("--start", flags.start, "x,y,theta in the world [m, rad]");
  command.add_option("--resolution", flags.resolution, "side of a map cell [m] (0.05)")->check(number);
  command.add_option("--max-time", flags.max_time, "simulated seconds (7200)")->check(number);
  command.add_option("--within", flags.within, "x0,y0,x1,y1 in the map: floor to stay on [m]");
  command.add_flag("--return-home", flags.return_home, "drive back to the start once done");
  command.add_flag("--motion-distortion", flags.motion_distortion,
                   "a lidar's beams are measured one by one while it moves");
  command.add_option("--forward-cone", flags.forward_cone, "map only beams this near to straight ahead [deg] (180)")
      ->check(number);
  add_calibration_flag(command, flags.calibration_file);
  command.add_option("--robot-radius", flags.robot_radius, "floor this near to a lidar robot is free [m] (its own)")
      ->check(number);
}

void apply_flags(const ScenarioFlags& flags, Scenario& scenario) {
  if (flags.world) scenario.world = *flags.world;
  if (flags.model) scenario.model = *flags.model;
  if (flags.strategy) scenario.strategy = *flags.strategy;
  if (flags.noise) scenario.noise = *flags.noise;
  if (flags.seed) scenario.seed = *flags.seed;
  if (flags.start) scenario.start = parse_pose(*flags.start, "--start");
  if (flags.resolution) scenario.resolution = *flags.resolution;
  if (flags.max_time) scenario.max_time = *flags.max_time;
  if (flags.localizer) scenario.localizer = *flags.localizer;
  if (flags.within) scenario.within = parse_bounds(*flags.within, "--within");
  if (flags.return_home) scenario.return_home = true;
  if (flags.motion_distortion) scenario.motion_distortion = true;
  if (flags.forward_cone) scenario.forward_cone = radians(*flags.forward_cone);
  if (flags.robot_radius) scenario.robot_radius = *flags.robot_radius;
  if (flags.calibration_file) scenario.calibration = calibration_for(scenario.model, *flags.calibration_file);
  check_figures(scenario);
  const RobotModel robot = find_robot(scenario.model).model;
  if (!robot.lidar) expect_no_lidar_flags(scenario);
  if (scenario.strategy.empty()) scenario.strategy = default_strategy(robot);
  if (scenario.localizer.empty()) scenario.localizer = default_localizer(robot);
}

Scenario make_scenario(const ScenarioFlags& flags) {
  Scenario scenario = flags.scenario_file ? read_scenario(*flags.scenario_file) : Scenario{};
  if (flags.world) scenario.world = *flags.world;
  expect_world(scenario);
  apply_flags(flags, scenario);
  return scenario;
}

Scenario make_live_scenario(const ScenarioFlags& flags) {
  const auto refuse = [](bool given, std::string_view flag) {
    if (given) throw Error(fmt::format("{} is for a simulated robot; want none with a real one", flag));
  };
  refuse(flags.world.has_value(), "WORLD");
  refuse(flags.noise.has_value(), "--noise");
  refuse(flags.start.has_value(), "--start");
  refuse(flags.motion_distortion, "--motion-distortion");
  Scenario scenario = flags.scenario_file ? read_scenario(*flags.scenario_file) : Scenario{};
  scenario.world.clear();
  scenario.start.reset();
  ScenarioFlags known = flags;
  if (flags.calibration_file && !flags.model && !flags.scenario_file) {
    read_calibration(*flags.calibration_file);  // whose it must be is known once the robot has answered
    known.calibration_file.reset();
  }
  apply_flags(known, scenario);
  return scenario;
}

void add_calibration_flag(CLI::App& command, std::optional<std::string>& file) {
  command.add_option("--calibration", file, "the robot's wheels, as scrubjay calibrate wrote them");
}

Calibration calibration_for(const std::string& model, const std::string& file) {
  const CalibrationRecord record = read_calibration(file);
  if (record.model == model) return record.calibration;
  throw Error(fmt::format("{}: the calibration of a {}, but the robot is a {}; want its own, or --model {}", file,
                          record.model, model, record.model));
}

void check_scenario(const Scenario& scenario) {
  expect_world(scenario);
  check_figures(scenario);
}

namespace {

void expect_world(const Scenario& scenario) {
  if (scenario.world.empty()) throw Error("no world is given; want one, such as worlds/apartment.yaml");
}

void check_figures(const Scenario& scenario) {
  if (!(scenario.resolution >= 0.005 && scenario.resolution <= 1.0)) {
    throw Error(fmt::format("--resolution is {}; want a cell size from 0.005 to 1 m", scenario.resolution));
  }
  if (!(scenario.max_time > 0.0 && scenario.max_time <= 1e7)) {
    throw Error(fmt::format("--max-time is {}; want a positive number of seconds, 1e7 at most", scenario.max_time));
  }
  if (scenario.forward_cone && !(*scenario.forward_cone > 0.0 && *scenario.forward_cone <= kPi + 1e-9)) {
    throw Error(fmt::format("--forward-cone is {}; want more than 0 and at most 180 degrees either way",
                            degrees(*scenario.forward_cone)));
  }
  if (scenario.robot_radius && !(*scenario.robot_radius >= 0.0 && *scenario.robot_radius <= 1.0)) {
    throw Error(fmt::format("--robot-radius is {}; want 0 to 1 m", *scenario.robot_radius));
  }
}

/// What would be noted, and would change nothing, isn't accepted.
void expect_no_lidar_flags(const Scenario& scenario) {
  const auto refuse = [&](bool given, std::string_view flag) {
    if (given) throw Error(fmt::format("{} wants a lidar, which {} hasn't; want none", flag, scenario.model));
  };
  refuse(scenario.motion_distortion, "--motion-distortion");
  refuse(scenario.forward_cone.has_value(), "--forward-cone");
  refuse(scenario.robot_radius.has_value(), "--robot-radius");
}

}  // namespace

void expect_speed(double speed) {
  if (!(speed >= 0.0)) throw Error(fmt::format("--speed is {}; want 0 (as fast as possible) or more", speed));
}

std::string whole_number(const std::string& text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole ? "" : fmt::format("'{}' is no whole number; want 0 or more, below 2^64", text);
}

std::string number(const std::string& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool all = error == std::errc() && end == text.data() + text.size();
  return all ? "" : fmt::format("'{}' is no number", text);
}

namespace {

/// Numbers between commas; none if the text is anything else.
template <std::size_t N>
std::optional<std::array<double, N>> parse_numbers(const std::string& text) {
  std::array<double, N> values{};
  const char* at = text.data();
  const char* end = at + text.size();
  for (std::size_t i = 0; i < N; ++i) {
    if (i > 0 && (at == end || *at++ != ',')) return std::nullopt;
    const auto [stop, error] = std::from_chars(at, end, values[i]);
    if (error != std::errc() || !std::isfinite(values[i])) return std::nullopt;
    at = stop;
  }
  if (at != end) return std::nullopt;
  return values;
}

}  // namespace

Pose2 parse_pose(const std::string& text, const std::string& flag) {
  const auto values = parse_numbers<3>(text);
  if (!values) throw Error(fmt::format("{} is '{}'; want x,y,theta in metres and radians, as 1.5,2,0", flag, text));
  return {(*values)[0], (*values)[1], wrap_angle((*values)[2])};
}

Bounds2 parse_bounds(const std::string& text, const std::string& flag) {
  const auto values = parse_numbers<4>(text);
  if (!values || !((*values)[0] < (*values)[2] && (*values)[1] < (*values)[3])) {
    throw Error(
        fmt::format("{} is '{}'; want x0,y0,x1,y1 in metres, the lower left corner first, as -2,-2,3,4", flag, text));
  }
  return {{(*values)[0], (*values)[1]}, {(*values)[2], (*values)[3]}};
}

void add_octomap_flags(CLI::App& command, OctomapFlags& flags) {
  command.add_option("--octomap", flags.file, "the map as an OctoMap tree, too: FILE.bt");
  command.add_option("--height", flags.height, "of the walls in it [m] (1)")->check(number);
}

void check_octomap(const OctomapFlags& flags) {
  if (!(flags.height > 0.0 && flags.height <= 10.0)) {
    throw Error(fmt::format("--height is {}; want more than 0 and at most 10 m", flags.height));
  }
}

void add_output_flags(CLI::App& command, OutputFlags& flags) {
  command.add_flag("--json", flags.json, "print the results as JSON");
  command.add_flag("--quiet", flags.quiet, "print no progress and no summary");
}

}  // namespace scrubjay::apps
