/// \file
/// `scrubjay replay LOG`: the same run from a recording of its bytes, or a map from a CARMEN log.
#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <scrubjay/error.hpp>
#include <scrubjay/io/file_kind.hpp>
#include <scrubjay/io/octomap_file.hpp>
#include <scrubjay/io/recording.hpp>
#include <scrubjay/io/scenario_file.hpp>
#include <scrubjay/mission/estimation.hpp>
#include <scrubjay/mission/paced_robot.hpp>
#include <scrubjay/mission/strategies.hpp>
#include <scrubjay/mission/track.hpp>
#include <scrubjay/robot/oi_robot.hpp>

#include "commands.hpp"
#include "data_folder.hpp"
#include "interrupt.hpp"
#include "replay_carmen.hpp"
#include "simulated_run.hpp"
#include "summary.hpp"

namespace scrubjay::apps {
namespace {

RunResult replay_recording(RecordingReader& recording, const Scenario& scenario, double speed,
                           const std::stop_token& stop) {
  const auto begin = std::chrono::steady_clock::now();
  const RobotModel model = find_robot(scenario.model).model;
  RecordedChannel channel(recording);
  OiRobot robot(channel, model);
  std::optional<PacedRobot> paced;
  if (speed > 0.0) paced.emplace(robot, speed);
  const Estimation estimation = make_estimation(scenario, model);
  // The strategy decides anew from the same frames; the robot of a recording goes where it went.
  const std::unique_ptr<Behavior> strategy = make_strategy(scenario.strategy, strategy_setting(scenario, model));
  Mission mission(paced ? static_cast<Robot&>(*paced) : robot, *estimation.localizer, *estimation.mapper, *strategy,
                  {scenario.max_time});
  Track track;
  mission.watch(track);

  RunResult run;
  run.scenario = scenario;
  run.report = mission.run(stop);
  run.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  run.map = estimation.mapper->occupancy();
  run.trajectory = track.points();
  run.bumps = track.bumps();
  run.robot_radius = model.radius;
  return run;
}

/// The world of the recording, if it is still where it was.
struct KnownWorld {
  Stage stage;
  GroundTruth truth;
};

std::optional<KnownWorld> find_world(const Scenario& scenario) {
  if (!std::filesystem::exists(scenario.world)) return std::nullopt;
  Stage stage = set_stage(scenario);
  GroundTruth truth = truth_of(stage, scenario.resolution);
  return KnownWorld{std::move(stage), std::move(truth)};
}

void replay(const ReplayFlags& flags) {
  expect_speed(flags.speed);
  check_octomap(flags.octomap);
  if (file_kind(flags.log) == FileKind::CarmenLog) return replay_carmen(flags);
  if (flags.carmen != CarmenFlags{}) {
    throw Error(
        fmt::format("{}: no CARMEN log; want none of --poses, --resolution, --forward-cone, --robot-radius, "
                    "--max-range and --relations with it",
                    flags.log));
  }
  RecordingReader recording{std::filesystem::path(flags.log)};
  if (recording.scenario().empty()) {
    throw Error(fmt::format("{}: cut before its scenario ends; nothing can be replayed", flags.log));
  }
  const Scenario scenario = parse_scenario(recording.scenario(), flags.log + " (scenario)");
  const std::optional<KnownWorld> known = find_world(scenario);
  const std::filesystem::path folder = replay_folder(flags);
  prepare_run_folder(folder);
  const Interrupt interrupt;
  RunResult run = replay_recording(recording, scenario, flags.speed, interrupt.token());
  if (recording.cut())
    fmt::print(stderr, "scrubjay: {}: cut or damaged after {:.1f} s; replayed up to there\n", flags.log,
               run.report.time);
  if (known) run.truth = compare_with_truth(known->stage, known->truth, run.map.view(), run.trajectory);
  write_run(folder, run);
  if (flags.octomap.file) write_octomap(*flags.octomap.file, run.map, flags.octomap.height);
  print_summary(run, folder, flags.output);
}

}  // namespace

void add_replay(CLI::App& app) {
  CLI::App* command = app.add_subcommand("replay", "Map from a recording");
  const auto flags = std::make_shared<ReplayFlags>();
  command->add_option("LOG", flags->log, "explore --record's .oilog, or a CARMEN log (.gz)")->required();
  command->add_option("--speed", flags->speed, "times real time; 0: as fast as possible (0)")->check(number);
  command->add_option("--out", flags->out, "folder for the results (out/LOG)");
  add_carmen_flags(*command, flags->carmen);
  add_octomap_flags(*command, flags->octomap);
  add_output_flags(*command, flags->output);
  command->callback([flags] { replay(*flags); });
}

}  // namespace scrubjay::apps
