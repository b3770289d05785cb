/// \file
/// `scrubjay explore`: a robot, simulated or on a wire, explores and leaves a map.
#include <fmt/format.h>

#include <memory>
#include <scrubjay/error.hpp>
#include <scrubjay/mission/estimation.hpp>
#include <scrubjay/mission/strategies.hpp>

#include "audience.hpp"
#include "commands.hpp"
#include "data_folder.hpp"
#include "interrupt.hpp"
#include "live_run.hpp"
#include "progress.hpp"
#include "recorded_run.hpp"
#include "robot_address.hpp"
#include "run_options.hpp"
#include "simulated_run.hpp"
#include "summary.hpp"

namespace scrubjay::apps {
namespace {

struct ExploreFlags {
  std::string robot = "sim";
  ScenarioFlags scenario;
  OutputFlags output;
  std::optional<double> speed;
  std::optional<std::string> out;
  std::optional<std::filesystem::path> record;
  bool zstd = false;
  OctomapFlags octomap;
  RosFlags ros;
};

std::filesystem::path run_folder(const ExploreFlags& flags, const std::filesystem::path& named_after) {
  return flags.out ? std::filesystem::path(*flags.out) : std::filesystem::path("out") / named_after.stem();
}

/// Where to record bytes, if that is asked for.
std::optional<std::filesystem::path> wire_recording(const ExploreFlags& flags) {
  return flags.record && !is_bag(*flags.record) ? flags.record : std::nullopt;
}

/// Where to record messages, if that is asked for.
std::optional<std::filesystem::path> bag_recording(const ExploreFlags& flags) {
  return flags.record && is_bag(*flags.record) ? flags.record : std::nullopt;
}

/// Throws Error where there is nothing that could be packed.
void check_zstd(const ExploreFlags& flags) {
  if (!flags.zstd || (flags.record && flags.record->extension() == ".mcap")) return;
  throw Error("--zstd packs an .mcap; want --record FILE.mcap with it");
}

/// Others see it as it goes.
double speed_of(const ExploreFlags& flags) {
  return flags.speed.value_or(flags.ros.wanted ? 1.0 : 0.0);
}

Audience make_audience(const ExploreFlags& flags) {
  return {flags.ros, flags.output.quiet, bag_recording(flags), flags.zstd};
}

void expect_robot(const RunResult& run) {
  if (run.report.ended == Ended::RobotGone) throw Error("the robot fell silent", Error::Kind::Failure);
}

void explore_simulated(const ExploreFlags& flags) {
  Scenario scenario = make_scenario(flags.scenario);
  // Of a robot that was on a wire; the simulated one is as its model is.
  scenario.protocol.reset();
  scenario.mode_one_too_high = false;
  expect_speed(flags.speed.value_or(0.0));
  const Stage stage = set_stage(scenario);
  // What can't be made is refused before anything is written.
  make_strategy(scenario.strategy, strategy_setting(scenario, stage.robot.model));
  make_estimation(scenario, stage.robot.model);
  if (wire_recording(flags) && !stage.robot.model.open_interface) {
    throw Error(fmt::format("an .oilog keeps the bytes of the Open Interface, which {} doesn't speak; want an .mcap",
                            scenario.model));
  }
  const GroundTruth truth = truth_of(stage, scenario.resolution);
  const RunFolder folder = prepare_results(run_folder(flags, scenario.world), flags.octomap);

  const Interrupt interrupt;
  RunOptions options;
  options.speed = speed_of(flags);
  options.record = wire_recording(flags);
  Audience audience = make_audience(flags);
  options.publishing = audience.publishing();
  std::optional<Progress> progress;
  if (progress_wanted(flags.output.quiet)) options.onlooker = &progress.emplace(&truth);
  const RunResult run = run_simulated(scenario, stage, truth, options, interrupt.token());
  audience.finish();
  progress.reset();
  deliver(run, folder.path(), flags.octomap, flags.output);
  audience.close();
  expect_robot(run);
}

void explore_live(const ExploreFlags& flags, const SerialAddress& address) {
  Scenario scenario = make_live_scenario(flags.scenario);
  if (flags.speed) throw Error("--speed is for a simulated robot; want none with a real one");
  const RobotModel likely = find_oi_robot(scenario.model).model;
  make_strategy(scenario.strategy, strategy_setting(scenario, likely));
  make_estimation(scenario, likely);
  const RunFolder folder = prepare_results(run_folder(flags, address.path), flags.octomap);

  Interrupt interrupt(Interrupt::Stake::RobotOnAWire);
  const bool told = flags.scenario.model || flags.scenario.scenario_file;
  LiveRobot live(address, told ? std::optional(scenario.model) : std::nullopt, OiRobot::Session::Drive,
                 interrupt.token(), flags.output.quiet);
  live.enter(scenario, flags.scenario.calibration_file);
  LiveOptions options;
  options.record = wire_recording(flags);
  Audience audience = make_audience(flags);
  options.publishing = audience.publishing();
  std::optional<Progress> progress;
  if (progress_wanted(flags.output.quiet)) options.onlooker = &progress.emplace(nullptr);
  const RunResult run = run_live(scenario, live.robot(), options, interrupt.token());
  interrupt.robot_stands();
  audience.finish();
  progress.reset();
  deliver(run, folder.path(), flags.octomap, flags.output);
  live.robot().close_recording();
  audience.close();
  expect_robot(run);
}

void explore_recorded(const ExploreFlags& flags, const InRecording& recording) {
  if (flags.record) throw Error("--record is for a robot that is there; want none with a recorded one");
  expect_speed(flags.speed.value_or(0.0));
  Recording opened = open_recording(recording.file);
  Scenario scenario = opened.scenario;
  apply_flags(flags.scenario, scenario);
  const RunFolder folder = prepare_results(run_folder(flags, recording.file), flags.octomap);
  const Interrupt interrupt;
  Audience audience = make_audience(flags);
  const RunResult run = run_recorded(opened, scenario, {speed_of(flags), audience.publishing()}, interrupt.token());
  audience.finish();
  deliver(run, folder.path(), flags.octomap, flags.output);
}

void explore(const ExploreFlags& flags) {
  check_octomap(flags.octomap);
  check_zstd(flags);
  const RobotAddress address = parse_robot_address(flags.robot);
  if (const auto* serial = std::get_if<SerialAddress>(&address)) return explore_live(flags, *serial);
  if (const auto* recording = std::get_if<InRecording>(&address)) return explore_recorded(flags, *recording);
  explore_simulated(flags);
}

}  // namespace

void add_explore(CLI::App& app) {
  CLI::App* command = app.add_subcommand("explore", "Explore with a robot and write a map");
  const auto flags = std::make_shared<ExploreFlags>();
  add_scenario_flags(*command, flags->scenario);
  command->add_option("--robot", flags->robot, "sim, serial:PATH[@BAUD] or log:FILE (sim)");
  command->add_option("--speed", flags->speed, "times real time; 0: as fast as possible (0)")->check(number);
  command->add_option("--out", flags->out, "folder for the results (out/WORLD)");
  command->add_option("--record", flags->record,
                      "messages to this .mcap or folder of rosbag2,\nor bytes to this .oilog");
  command->add_flag("--zstd", flags->zstd, "pack the .mcap that is recorded");
  add_octomap_flags(*command, flags->octomap);
  add_ros_flags(*command, flags->ros);
  add_output_flags(*command, flags->output);
  command->callback([flags] { explore(*flags); });
}

}  // namespace scrubjay::apps
