/// \file
/// `scrubjay explore WORLD`: a simulated robot explores and leaves a map.
#include <fmt/format.h>

#include <memory>
#include <scrubjay/error.hpp>
#include <scrubjay/io/octomap_file.hpp>
#include <scrubjay/mission/estimation.hpp>
#include <scrubjay/mission/strategies.hpp>

#include "commands.hpp"
#include "interrupt.hpp"
#include "progress.hpp"
#include "run_options.hpp"
#include "simulated_run.hpp"
#include "summary.hpp"

namespace scrubjay::apps {
namespace {

struct ExploreFlags {
  ScenarioFlags scenario;
  OutputFlags output;
  double speed = 0.0;
  std::optional<std::string> out;
  std::optional<std::string> record;
  OctomapFlags octomap;
};

void explore(const ExploreFlags& flags) {
  const Scenario scenario = make_scenario(flags.scenario);
  expect_speed(flags.speed);
  check_octomap(flags.octomap);
  const Stage stage = set_stage(scenario);
  // What can't be made is refused before anything is written.
  make_strategy(scenario.strategy, strategy_setting(scenario, stage.robot.model));
  make_estimation(scenario, stage.robot.model);
  if (flags.record && !stage.robot.model.open_interface) {
    throw Error(fmt::format("--record keeps the bytes of the Open Interface, which {} doesn't speak", scenario.model));
  }
  const GroundTruth truth = truth_of(stage, scenario.resolution);
  const std::filesystem::path folder =
      flags.out ? std::filesystem::path(*flags.out)
                : std::filesystem::path("out") / std::filesystem::path(scenario.world).stem();
  prepare_run_folder(folder);

  const Interrupt interrupt;
  RunOptions options;
  options.speed = flags.speed;
  if (flags.record) options.record = *flags.record;
  std::optional<Progress> progress;
  if (progress_wanted(flags.output.quiet)) options.onlooker = &progress.emplace(truth);
  const RunResult run = run_simulated(scenario, stage, truth, options, interrupt.token());
  progress.reset();
  write_run(folder, run);
  if (flags.octomap.file) write_octomap(*flags.octomap.file, run.map, flags.octomap.height);
  print_summary(run, folder, flags.output);
  if (run.report.ended == Ended::RobotGone) throw Error("the robot fell silent", Error::Kind::Failure);
}

}  // namespace

void add_explore(CLI::App& app) {
  CLI::App* command = app.add_subcommand("explore", "Explore a world with a simulated robot and write a map");
  const auto flags = std::make_shared<ExploreFlags>();
  add_scenario_flags(*command, flags->scenario);
  command->add_option("--speed", flags->speed, "times real time; 0: as fast as possible (0)")->check(number);
  command->add_option("--out", flags->out, "folder for the results (out/WORLD)");
  command->add_option("--record", flags->record, "record all bytes to this .oilog");
  add_octomap_flags(*command, flags->octomap);
  add_output_flags(*command, flags->output);
  command->callback([flags] { explore(*flags); });
}

}  // namespace scrubjay::apps
