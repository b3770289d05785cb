#include <fmt/format.h>

#include <charconv>
#include <scrubjay/error.hpp>
#include <scrubjay/io/scenario_file.hpp>
#include <scrubjay/io/world_reader.hpp>

#include "file_content.hpp"
#include "yaml_field.hpp"

namespace scrubjay {
namespace {

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '\n') {
      out += "\\n";
      continue;
    }
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + "\"";
}

std::uint64_t read_seed(const YamlField& field) {
  const std::string text = field.text();
  std::uint64_t seed = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
  if (error != std::errc() || end != text.data() + text.size()) field.fail("a whole number of 0 or more");
  return seed;
}

}  // namespace

std::string scenario_text(const Scenario& scenario) {
  std::string text = fmt::format("world: {}\nmodel: {}\nstrategy: {}\nnoise: {}\nseed: {}\n", quoted(scenario.world),
                                 quoted(scenario.model), scenario.strategy, scenario.noise, scenario.seed);
  if (scenario.start) {
    text += fmt::format("start: [{}, {}, {}]\n", scenario.start->x, scenario.start->y, scenario.start->yaw);
  }
  return text + fmt::format("resolution: {}\nmax_time: {}\n", scenario.resolution, scenario.max_time);
}

Scenario parse_scenario(const std::string& text, const std::string& file) {
  const YamlField root = YamlField::parse(text, file);
  root.expect_keys({"world", "model", "strategy", "noise", "seed", "start", "resolution", "max_time"});
  Scenario scenario;
  if (root.has("world")) scenario.world = root.at("world").text();
  if (root.has("model")) scenario.model = root.at("model").text();
  if (root.has("strategy")) scenario.strategy = root.at("strategy").text();
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
  return scenario;
}

Scenario read_scenario(const std::filesystem::path& path) {
  const std::vector<std::uint8_t> file = read_file(path);
  return parse_scenario(std::string(file.begin(), file.end()), path.string());
}

}  // namespace scrubjay
