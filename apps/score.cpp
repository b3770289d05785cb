/// \file
/// `scrubjay score MAP WORLD`: compares a map with the truth.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <scrubjay/error.hpp>
#include <scrubjay/io/map_file.hpp>
#include <scrubjay/io/scenario_file.hpp>
#include <scrubjay/world/score.hpp>

#include "commands.hpp"
#include "run_options.hpp"
#include "simulated_run.hpp"

namespace scrubjay::apps {
namespace {

struct ScoreFlags {
  std::string map;
  std::string world;
  std::optional<std::string> start;
  std::string model = "roomba-600";
  bool json = false;
};

/// Where the map's frame lies: as the flag says, or as the run beside the map began, or as the world itself says.
Scenario scenario_of(const ScoreFlags& flags) {
  Scenario scenario;
  const std::filesystem::path beside = std::filesystem::path(flags.map).parent_path() / "scenario.yaml";
  if (std::filesystem::exists(beside))
    scenario = read_scenario(beside);
  else
    scenario.model = flags.model;
  scenario.world = flags.world;
  if (flags.start) scenario.start = parse_pose(*flags.start, "--start");
  return scenario;
}

void score(const ScoreFlags& flags) {
  std::vector<std::string> warnings;
  const OccupancyGrid map = read_map(flags.map, &warnings);
  for (const std::string& warning : warnings) fmt::print(stderr, "scrubjay: {}\n", warning);
  const Stage stage = set_stage(scenario_of(flags));
  const MapScore result = score_map(map.view(), truth_of(stage, map.geometry.resolution));
  if (flags.json) {
    const nlohmann::ordered_json json{
        {"start", {{"x", stage.start.x}, {"y", stage.start.y}, {"theta", stage.start.yaw}}},
        {"coverage", result.coverage},
        {"iou", result.iou},
        {"wall_precision", result.wall_precision},
        {"wall_recall", result.wall_recall}};
    return fmt::print("{}\n", json.dump(2));
  }
  fmt::print("map's origin at ({:.2f}, {:.2f}, {:.2f}) in the world\n", stage.start.x, stage.start.y, stage.start.yaw);
  fmt::print("coverage        {:6.1f} %\nIoU             {:8.3f}\nwall precision  {:8.3f}\nwall recall     {:8.3f}\n",
             100.0 * result.coverage, result.iou, result.wall_precision, result.wall_recall);
}

}  // namespace

void add_score(CLI::App& app) {
  CLI::App* command = app.add_subcommand("score", "Compare a map with its world");
  const auto flags = std::make_shared<ScoreFlags>();
  command->add_option("MAP", flags->map, "map YAML")->required();
  command->add_option("WORLD", flags->world, "the world that it is of")->required();
  command->add_option("--start", flags->start,
                      "x,y,theta of the map's origin in the world\n(the run's or else the world's)");
  command->add_option("--model", flags->model, "the robot, where no scenario.yaml is beside\nthe map (roomba-600)");
  command->add_flag("--json", flags->json, "print the results as JSON");
  command->callback([flags] { score(*flags); });
}

}  // namespace scrubjay::apps
