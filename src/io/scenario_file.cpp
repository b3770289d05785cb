#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <scrubjay/error.hpp>
#include <scrubjay/io/scenario_file.hpp>
#include <scrubjay/io/world_reader.hpp>

#include "dialect_names.hpp"
#include "factors.hpp"
#include "file_content.hpp"
#include "yaml_field.hpp"

namespace scrubjay {
namespace {

std::uint64_t read_seed(const YamlField& field) {
  const std::string text = field.text();
  std::uint64_t seed = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
  if (error != std::errc() || end != text.data() + text.size()) field.fail("a whole number of 0 or more");
  return seed;
}

oi::Model read_dialect(const YamlField& field) {
  const std::string text = field.text();
  for (const auto& [name, dialect] : kDialectNames) {
    if (name == text) return dialect;
  }
  field.fail("create-2, create-1 or roomba-400");
}

std::string_view dialect_name(oi::Model dialect) {
  return std::ranges::find(kDialectNames, dialect, [](const auto& known) { return known.second; })->first;
}

void read_exploration(const YamlField& root, Scenario& scenario) {
  if (root.has("within")) {
    const YamlField field = root.at("within");
    const std::string_view wanted = "[x0, y0, x1, y1] in metres, the lower left corner first";
    const std::vector<double> ends = field.numbers(4, {-kWorldExtent, kWorldExtent}, wanted);
    if (!(ends[0] < ends[2] && ends[1] < ends[3])) field.fail(wanted);
    scenario.within = Bounds2{{ends[0], ends[1]}, {ends[2], ends[3]}};
  }
  if (root.has("return_home")) scenario.return_home = root.at("return_home").boolean();
  if (root.has("motion_distortion")) scenario.motion_distortion = root.at("motion_distortion").boolean();
  if (root.has("forward_cone")) {
    scenario.forward_cone = root.at("forward_cone").number({0.0, 3.1416, true, "an angle in radians, up to pi"});
  }
  if (root.has("robot_radius")) {
    scenario.robot_radius = root.at("robot_radius").number({0.0, 1.0, false, "a radius from 0 to 1 m"});
  }
}

}  // namespace

std::string scenario_text(const Scenario& scenario) {
  std::string text = fmt::format("world: {}\nmodel: {}\n", quoted(scenario.world), quoted(scenario.model));
  if (!scenario.strategy.empty()) text += fmt::format("strategy: {}\n", scenario.strategy);
  if (!scenario.localizer.empty()) text += fmt::format("localizer: {}\n", scenario.localizer);
  text += fmt::format("noise: {}\nseed: {}\n", scenario.noise, scenario.seed);
  if (scenario.start) {
    text += fmt::format("start: [{}, {}, {}]\n", scenario.start->x, scenario.start->y, scenario.start->yaw);
  }
  if (scenario.calibration) {
    const auto& [left, right, axle] = *scenario.calibration;
    text += fmt::format("calibration: {{left: {}, right: {}, axle: {}}}\n", left, right, axle);
  }
  text += fmt::format("resolution: {}\nmax_time: {}\n", scenario.resolution, scenario.max_time);
  if (scenario.within) {
    const auto& [low, high] = *scenario.within;
    text += fmt::format("within: [{}, {}, {}, {}]\n", low.x(), low.y(), high.x(), high.y());
  }
  if (scenario.return_home) text += "return_home: true\n";
  if (scenario.motion_distortion) text += "motion_distortion: true\n";
  if (scenario.forward_cone) text += fmt::format("forward_cone: {}\n", *scenario.forward_cone);
  if (scenario.robot_radius) text += fmt::format("robot_radius: {}\n", *scenario.robot_radius);
  if (scenario.protocol) text += fmt::format("protocol: {}\n", dialect_name(*scenario.protocol));
  if (scenario.mode_one_too_high) text += "mode_one_too_high: true\n";
  return text;
}

Scenario parse_scenario(const std::string& text, const std::string& file) {
  const YamlField root = YamlField::parse(text, file);
  root.expect_keys({"world", "model", "strategy", "localizer", "noise", "seed", "start", "resolution", "max_time",
                    "within", "return_home", "motion_distortion", "forward_cone", "robot_radius", "calibration",
                    "protocol", "mode_one_too_high"});
  Scenario scenario;
  if (root.has("world")) scenario.world = root.at("world").text();
  if (root.has("model")) scenario.model = root.at("model").text();
  if (root.has("strategy")) scenario.strategy = root.at("strategy").text();
  if (root.has("localizer")) scenario.localizer = root.at("localizer").text();
  if (root.has("noise")) scenario.noise = root.at("noise").text();
  if (root.has("seed")) scenario.seed = read_seed(root.at("seed"));
  if (root.has("start")) {
    const std::vector<double> pose =
        root.at("start").numbers(3, {-kWorldExtent, kWorldExtent}, "[x, y, theta] in metres and radians");
    scenario.start = Pose2{pose[0], pose[1], wrap_angle(pose[2])};
  }
  if (root.has("resolution")) {
    scenario.resolution = root.at("resolution").number({0.005, 1.0, false, "a cell size from 0.005 to 1 m"});
  }
  if (root.has("max_time")) {
    scenario.max_time = root.at("max_time").number({0.0, 1e7, true, "a positive number of seconds"});
  }
  if (root.has("calibration")) {
    const YamlField field = root.at("calibration");
    field.expect_keys({"left", "right", "axle"});
    scenario.calibration = read_factors(field);
  }
  if (root.has("protocol")) scenario.protocol = read_dialect(root.at("protocol"));
  if (root.has("mode_one_too_high")) scenario.mode_one_too_high = root.at("mode_one_too_high").boolean();
  read_exploration(root, scenario);
  return scenario;
}

Scenario read_scenario(const std::filesystem::path& path) {
  const std::vector<std::uint8_t> file = read_file(path);
  return parse_scenario(std::string(file.begin(), file.end()), path.string());
}

}  // namespace scrubjay
