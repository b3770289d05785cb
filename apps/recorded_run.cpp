#include "recorded_run.hpp"

#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <scrubjay/error.hpp>
#include <scrubjay/io/recorded_robot.hpp>
#include <scrubjay/io/scenario_file.hpp>
#include <scrubjay/mission/estimation.hpp>
#include <scrubjay/mission/paced_robot.hpp>
#include <scrubjay/mission/strategies.hpp>
#include <scrubjay/mission/track.hpp>
#include <scrubjay/robot/calibrated_robot.hpp>
#include <scrubjay/robot/oi_robot.hpp>

#include "data_folder.hpp"
#include "passenger.hpp"
#include "simulated_run.hpp"

namespace scrubjay::apps {
namespace {

/// Our own robot again; where it was silent, the recording goes on.
class ReplayedRobot final : public Robot {
 public:
  ReplayedRobot(RecordingReader& reader, const RobotModel& model) : channel_(reader), robot_(channel_, model) {}

  std::optional<Frame> next() override {
    while (true) {
      std::optional<Frame> frame = robot_.next();
      if (frame || robot_.link() == LinkState::Closed) return frame;
    }
  }
  void drive(const Motion& motion) override { robot_.drive(motion); }
  void stop() override { robot_.stop(); }

 private:
  RecordedChannel channel_;
  OiRobot robot_;
};

}  // namespace

Recording open_recording(const std::filesystem::path& file) {
  RecordingReader reader(file);
  if (reader.scenario().empty()) {
    throw Error(fmt::format("{}: cut before its scenario ends; nothing can be replayed", file.string()));
  }
  Scenario scenario = parse_scenario(reader.scenario(), file.string() + " (scenario)");
  const bool is_ours = !scenario.strategy.empty();
  return {std::move(reader), std::move(scenario), is_ours};
}

RunResult run_recorded(Recording& recording, const Scenario& scenario, double speed, const std::stop_token& stop) {
  const auto begin = std::chrono::steady_clock::now();
  const RobotModel model = find_robot(scenario.model).model;
  std::unique_ptr<Robot> robot;
  if (recording.is_ours) {
    robot = std::make_unique<ReplayedRobot>(recording.reader, model);
  } else {
    robot = std::make_unique<RecordedRobot>(recording.reader, model);
  }
  Robot* source = robot.get();
  std::optional<CalibratedRobot> calibrated;
  if (scenario.calibration) source = &calibrated.emplace(*source, *scenario.calibration, model.drive);
  std::optional<PacedRobot> paced;
  if (speed > 0.0) source = &paced.emplace(*source, speed);
  const Estimation estimation = make_estimation(scenario, model);
  const std::unique_ptr<Behavior> strategy = scenario.strategy.empty()
                                                 ? std::make_unique<Passenger>()
                                                 : make_strategy(scenario.strategy, strategy_setting(scenario, model));
  Mission mission(*source, *estimation.localizer, *estimation.mapper, *strategy, {scenario.max_time});
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

}  // namespace scrubjay::apps
