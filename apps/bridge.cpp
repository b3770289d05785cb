/// \file
/// `scrubjay bridge`: a robot, real or simulated, for nodes of ROS 2 to drive.
#include <fmt/format.h>

#include <memory>
#include <scrubjay/error.hpp>

#include "commands.hpp"
#include "data_folder.hpp"
#include "interrupt.hpp"
#include "live_run.hpp"
#include "publishing.hpp"
#include "recorded_run.hpp"
#include "robot_address.hpp"
#include "ros_node.hpp"
#include "run_options.hpp"
#include "simulated_run.hpp"
#include "summary.hpp"

namespace scrubjay::apps {
namespace {

struct BridgeFlags {
  std::string robot = "sim";
  ScenarioFlags scenario;
  RosFlags ros{true, std::nullopt};
  std::optional<std::string> out;
  std::optional<std::filesystem::path> record;
  OutputFlags output;
};

void expect_bag(const BridgeFlags& flags) {
  if (flags.record && !is_bag(*flags.record)) {
    throw Error(fmt::format("--record is {}; want an .mcap, or a folder", flags.record->string()));
  }
}

std::filesystem::path run_folder(const BridgeFlags& flags, const std::filesystem::path& named_after) {
  return flags.out ? std::filesystem::path(*flags.out) : std::filesystem::path("out") / named_after.stem();
}

/// Somebody else decides what to do, and when it is over.
void hand_over(const BridgeFlags& flags, Scenario& scenario) {
  scenario.strategy.clear();
  if (!flags.scenario.max_time) scenario.max_time = kLongestReplay;
}

void bridge_simulated(const BridgeFlags& flags) {
  Scenario scenario = make_scenario(flags.scenario);
  hand_over(flags, scenario);
  const Stage stage = set_stage(scenario);
  make_estimation(scenario, stage.robot.model);
  const GroundTruth truth = truth_of(stage, scenario.resolution);
  const RunFolder folder = prepare_results(run_folder(flags, scenario.world), {});
  const Interrupt interrupt;
  RosNode node(flags.ros, flags.output.quiet);
  Publishing publishing(flags.record);
  publishing.tell(node);
  RunOptions options;
  options.speed = 1.0;
  options.publishing = &publishing;
  options.steering = &node.steering(stage.robot.model);
  const RunResult run = run_simulated(scenario, stage, truth, options, interrupt.token());
  node.finish();
  deliver(run, folder.path(), {}, flags.output);
  publishing.close();
}

void bridge_live(const BridgeFlags& flags, const SerialAddress& address) {
  Scenario scenario = make_live_scenario(flags.scenario);
  make_estimation(scenario, find_oi_robot(scenario.model).model);
  hand_over(flags, scenario);
  const RunFolder folder = prepare_results(run_folder(flags, address.path), {});
  Interrupt interrupt(Interrupt::Stake::RobotOnAWire);
  const bool told = flags.scenario.model || flags.scenario.scenario_file;
  LiveRobot live(address, told ? std::optional(scenario.model) : std::nullopt, OiRobot::Session::Drive,
                 interrupt.token(), flags.output.quiet);
  live.enter(scenario, flags.scenario.calibration_file);
  RosNode node(flags.ros, flags.output.quiet);
  Publishing publishing(flags.record);
  publishing.tell(node);
  LiveOptions options;
  options.publishing = &publishing;
  options.steering = &node.steering(live.robot().model());
  const RunResult run = run_live(scenario, live.robot(), options, interrupt.token());
  interrupt.robot_stands();
  node.finish();
  deliver(run, folder.path(), {}, flags.output);
  publishing.close();
  if (run.report.ended == Ended::RobotGone) throw Error("the robot fell silent", Error::Kind::Failure);
}

void bridge(const BridgeFlags& flags) {
  expect_bag(flags);
  const RobotAddress address = parse_robot_address(flags.robot);
  if (const auto* serial = std::get_if<SerialAddress>(&address)) return bridge_live(flags, *serial);
  if (std::holds_alternative<InRecording>(address)) {
    throw Error("a recording can't be driven; want --robot sim or serial:PORT");
  }
  bridge_simulated(flags);
}

}  // namespace

void add_bridge(CLI::App& app) {
  CLI::App* command = app.add_subcommand("bridge", "Have nodes of ROS 2 drive a robot");
  const auto flags = std::make_shared<BridgeFlags>();
  ScenarioFlags& scenario = flags->scenario;
  command->add_option("WORLD", scenario.world, "world YAML, HouseExpo plan or nav2 map");
  command->add_option("--robot", flags->robot, "sim or serial:PATH[@BAUD] (sim)");
  command->add_option("--model", scenario.model, "as of explore (roomba-600; what answers on a port)");
  command->add_option("--noise", scenario.noise, "none, hard-floor, carpet, uncalibrated (none)");
  command->add_option("--seed", scenario.seed, "of the noise (1)")->check(whole_number);
  command->add_option("--start", scenario.start, "x,y,theta in the world [m, rad]");
  command->add_option("--resolution", scenario.resolution, "side of a map cell [m] (0.05)")->check(number);
  command->add_option("--max-time", scenario.max_time, "seconds (until Ctrl-C)")->check(number);
  add_calibration_flag(*command, scenario.calibration_file);
  add_ros_distro_flag(*command, flags->ros);
  command->add_option("--out", flags->out, "folder for the results (out/WORLD)");
  command->add_option("--record", flags->record, "record all messages to this .mcap, or folder");
  add_output_flags(*command, flags->output);
  command->callback([flags] { bridge(*flags); });
}

}  // namespace scrubjay::apps
