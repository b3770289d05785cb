#include "run_options.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <scrubjay/error.hpp>
#include <scrubjay/io/scenario_file.hpp>
#include <scrubjay/mission/strategies.hpp>

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

}  // namespace

void add_scenario_flags(CLI::App& command, ScenarioFlags& flags) {
  const Scenario standard;
  command.add_option("WORLD", flags.world, "world YAML, HouseExpo plan or nav2 map");
  command.add_option("--scenario", flags.scenario_file, "scenario.yaml of an earlier run to repeat");
  command.add_option("--strategy", flags.strategy, fmt::format("{} ({})", listed(strategy_names()), standard.strategy));
  command.add_option("--model", flags.model, "roomba-600, create-2, create-1 or a URDF file\n(roomba-600)");
  command.add_option("--noise", flags.noise, "none, hard-floor, carpet, uncalibrated (none)");
  command.add_option("--seed", flags.seed, "same seed, same run (1)")->check(whole_number);
  command.add_option("--start", flags.start, "x,y,theta in the world [m, rad]");
  command.add_option("--resolution", flags.resolution, "side of a map cell [m] (0.05)")->check(number);
  command.add_option("--max-time", flags.max_time, "simulated seconds (7200)")->check(number);
}

Scenario make_scenario(const ScenarioFlags& flags) {
  Scenario scenario = flags.scenario_file ? read_scenario(*flags.scenario_file) : Scenario{};
  if (flags.world) scenario.world = *flags.world;
  if (flags.model) scenario.model = *flags.model;
  if (flags.strategy) scenario.strategy = *flags.strategy;
  if (flags.noise) scenario.noise = *flags.noise;
  if (flags.seed) scenario.seed = *flags.seed;
  if (flags.start) scenario.start = parse_pose(*flags.start, "--start");
  if (flags.resolution) scenario.resolution = *flags.resolution;
  if (flags.max_time) scenario.max_time = *flags.max_time;
  check_scenario(scenario);
  return scenario;
}

void check_scenario(const Scenario& scenario) {
  if (scenario.world.empty()) throw Error("no world is given; want one, such as worlds/apartment.yaml");
  if (!(scenario.resolution >= 0.005 && scenario.resolution <= 1.0)) {
    throw Error(fmt::format("--resolution is {}; want a cell size from 0.005 to 1 m", scenario.resolution));
  }
  if (!(scenario.max_time > 0.0 && scenario.max_time <= 1e7)) {
    throw Error(fmt::format("--max-time is {}; want a positive number of seconds, 1e7 at most", scenario.max_time));
  }
}

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

Pose2 parse_pose(const std::string& text, const std::string& flag) {
  double values[3];
  const char* at = text.data();
  const char* end = at + text.size();
  for (int i = 0; i < 3; ++i) {
    if (i > 0 && (at == end || *at++ != ',')) at = nullptr;
    if (at == nullptr) break;
    const auto [stop, error] = std::from_chars(at, end, values[i]);
    at = error == std::errc() && std::isfinite(values[i]) ? stop : nullptr;
    if (at == nullptr) break;
  }
  if (at != end) throw Error(fmt::format("{} is '{}'; want x,y,theta in metres and radians, as 1.5,2,0", flag, text));
  return {values[0], values[1], wrap_angle(values[2])};
}

void add_output_flags(CLI::App& command, OutputFlags& flags) {
  command.add_flag("--json", flags.json, "print the results as JSON");
  command.add_flag("--quiet", flags.quiet, "print no progress and no summary");
}

}  // namespace scrubjay::apps
