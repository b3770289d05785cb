#include "live_run.hpp"

#include <fmt/format.h>

#include <chrono>
#include <scrubjay/io/recording.hpp>
#include <scrubjay/io/scenario_file.hpp>
#include <scrubjay/mission/estimation.hpp>
#include <scrubjay/mission/strategies.hpp>
#include <scrubjay/mission/track.hpp>
#include <scrubjay/robot/calibrated_robot.hpp>

#include "data_folder.hpp"
#include "publishing.hpp"
#include "run_options.hpp"
#include "simulated_run.hpp"
#include "steering.hpp"

namespace scrubjay::apps {
namespace {

std::string name_of(oi::Model protocol) {
  switch (protocol) {
    case oi::Model::Create2:
      return "roomba-600";
    case oi::Model::Create1:
      return "create-1";
    case oi::Model::Roomba400:
      return "roomba-400";
  }
  return "";
}

std::optional<RobotModel> expected(const std::optional<std::string>& model) {
  if (!model) return std::nullopt;
  return find_robot(*model).model;
}

SerialRobotParams params_for(OiRobot::Session session) {
  SerialRobotParams params;
  params.session = session;
  params.body = [](oi::Model protocol) { return find_robot(name_of(protocol)).model; };
  return params;
}

}  // namespace

LiveRobot::LiveRobot(const SerialAddress& address, const std::optional<std::string>& model, OiRobot::Session session,
                     const std::stop_token& stop, bool quiet)
    : robot_(address, expected(model), stop, params_for(session)),
      model_name_(model.value_or(name_of(robot_.model().protocol))) {
  if (quiet) return;
  for (const std::string& remark : robot_.remarks()) fmt::print(stderr, "scrubjay: {}\n", remark);
}

void LiveRobot::enter(Scenario& scenario, const std::optional<std::string>& calibration_file) const {
  scenario.model = model_name_;
  scenario.protocol = robot_.model().protocol;
  scenario.mode_one_too_high = robot_.quirks().mode_one_too_high;
  if (calibration_file) scenario.calibration = calibration_for(scenario.model, *calibration_file);
}

RunResult run_live(const Scenario& scenario, SerialRobot& robot, const LiveOptions& options,
                   const std::stop_token& stop) {
  const auto begin = std::chrono::steady_clock::now();
  const RobotModel& model = robot.model();
  RecordingWriter* recording = nullptr;
  if (options.record) {
    auto writer = std::make_unique<RecordingWriter>(*options.record, scenario_text(scenario));
    recording = writer.get();
    robot.record(std::move(writer));
  }
  std::optional<CalibratedRobot> calibrated;
  if (scenario.calibration) calibrated.emplace(robot, *scenario.calibration, model.drive);
  Estimation estimation = make_estimation(scenario, model);
  if (options.steering != nullptr) options.steering->correct(estimation, model);
  const std::unique_ptr<Behavior> strategy = options.steering != nullptr
                                                 ? options.steering->behavior(model)
                                                 : make_strategy(scenario.strategy, strategy_setting(scenario, model));
  Robot& driven = calibrated ? static_cast<Robot&>(*calibrated) : robot;
  const std::unique_ptr<Robot> between = options.steering != nullptr ? options.steering->between(driven) : nullptr;
  Mission mission(between ? *between : driven, *estimation.localizer, *estimation.mapper, *strategy,
                  {scenario.max_time});
  Track track;
  mission.watch(track);
  if (options.onlooker != nullptr) mission.watch(*options.onlooker);
  if (options.publishing != nullptr) mission.watch(options.publishing->begin(scenario, model, RunTime::Real));

  RunResult run;
  run.scenario = scenario;
  run.report = mission.run(stop);
  if (options.publishing != nullptr) options.publishing->finish(estimation.mapper->map(), run.report);
  // The session is over: nobody else writes to the recording now.
  if (recording != nullptr) recording->record_end({run.report.frames, std::string(to_string(run.report.ended))});
  run.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  run.map = estimation.mapper->occupancy();
  run.trajectory = track.points();
  run.bumps = track.bumps();
  run.robot_radius = model.radius;
  run.link = robot.report();
  return run;
}

}  // namespace scrubjay::apps
