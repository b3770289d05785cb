#include "replay_bag.hpp"

#include <fmt/format.h>

#include <chrono>
#include <scrubjay/error.hpp>
#include <scrubjay/io/bag.hpp>
#include <scrubjay/io/bag_robot.hpp>
#include <scrubjay/io/scenario_file.hpp>
#include <scrubjay/messages/cdr.hpp>
#include <scrubjay/messages/std_msgs.hpp>
#include <scrubjay/mission/estimation.hpp>
#include <scrubjay/mission/mission.hpp>
#include <scrubjay/mission/paced_robot.hpp>
#include <scrubjay/mission/track.hpp>

#include "audience.hpp"
#include "data_folder.hpp"
#include "interrupt.hpp"
#include "passenger.hpp"
#include "recorded_run.hpp"
#include "summary.hpp"

namespace scrubjay::apps {
namespace {

/// The body that the scans and odometry of somebody else's bag are taken for.
constexpr const char* kForeignLidarRobot = "turtlebot3-burger";

/// The scenario that we recorded; none of a bag that isn't ours.
std::optional<Scenario> recorded_scenario(const std::string& bag) {
  const std::unique_ptr<BagReader> reader = open_bag(bag);
  const auto is_it = [&](const BagTopic& topic) {
    return topic.type == ros::String::kType && topic.name.ends_with("/scenario");
  };
  const auto& topics = reader->topics();
  if (std::none_of(topics.begin(), topics.end(), is_it)) return std::nullopt;
  while (const auto message = reader->next()) {
    if (!is_it(reader->topics()[message->topic])) continue;
    const auto text = ros::decode<ros::String>(message->bytes);
    if (text) return parse_scenario(text->data, bag + " (scenario)");
  }
  return std::nullopt;
}

Scenario scenario_of(const std::string& bag, const BagSenses& senses) {
  Scenario scenario = recorded_scenario(bag).value_or(Scenario{});
  const bool is_ours = !scenario.strategy.empty();
  if (!is_ours && senses.lidar) scenario.model = kForeignLidarRobot;
  scenario.calibration.reset();  // odometry was told by it
  scenario.max_time = kLongestReplay;
  return scenario;
}

RunResult run_bag(const ReplayFlags& flags, const BagSenses& senses, const Scenario& scenario, Publishing* publishing,
                  const std::stop_token& stop) {
  const auto begin = std::chrono::steady_clock::now();
  const RobotModel model = robot_of(senses, find_robot(scenario.model).model);
  BagRobot robot(flags.log, senses);
  std::optional<PacedRobot> paced;
  if (const double speed = replay_speed(flags); speed > 0.0) paced.emplace(robot, speed);
  const Estimation estimation = make_estimation(scenario, model);
  Passenger passenger;
  Mission mission(paced ? static_cast<Robot&>(*paced) : robot, *estimation.localizer, *estimation.mapper, passenger,
                  {scenario.max_time});
  Track track;
  mission.watch(track);
  if (publishing != nullptr) mission.watch(publishing->begin(scenario, model, run_time(replay_speed(flags))));

  RunResult run;
  run.scenario = scenario;
  run.report = mission.run(stop);
  if (run.report.frames == 0) {
    throw Error(
        fmt::format("{}: holds no odometry that goes with its other messages; nothing can be replayed", flags.log),
        Error::Kind::Failure);
  }
  if (run.report.ended == Ended::RobotGone) run.report.ended = Ended::EndOfRecording;
  if (publishing != nullptr) publishing->finish(estimation.mapper->map(), run.report);
  if (robot.cut()) {
    fmt::print(stderr, "scrubjay: {}: cut or damaged after {:.1f} s; replayed up to there\n", flags.log,
               run.report.time);
  }
  if (robot.left_out() > 0) {
    fmt::print(stderr, "scrubjay: {}: {} messages made no frame, damaged or out of time\n", flags.log,
               robot.left_out());
  }
  run.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  run.map = estimation.mapper->occupancy();
  run.trajectory = track.points();
  run.bumps = track.bumps();
  run.robot_radius = model.radius;
  run.has_bumper = model.open_interface;
  run.truth = find_truth(flags.log, run);
  return run;
}

}  // namespace

void replay_bag(const ReplayFlags& flags) {
  const BagSenses senses = find_senses(flags.log);
  const Scenario scenario = scenario_of(flags.log, senses);
  const RunFolder folder = prepare_results(replay_folder(flags), flags.octomap);
  const Interrupt interrupt;
  Audience audience(flags.ros, flags.output.quiet);
  const RunResult run = run_bag(flags, senses, scenario, audience.publishing(), interrupt.token());
  audience.finish();
  deliver(run, folder.path(), flags.octomap, flags.output);
}

}  // namespace scrubjay::apps
