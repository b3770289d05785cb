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
#include "publishing.hpp"
#include "simulated_run.hpp"

namespace scrubjay::apps {
namespace {

/// Our own robot again, up to where its mission ended; where it was silent, the recording goes on.
class ReplayedRobot final : public Robot {
 public:
  /// `stopped` is told where somebody asked the mission to stop.
  ReplayedRobot(Recording& recording, const RobotModel& model, const oi::FirmwareQuirks& quirks,
                std::stop_source& stopped)
      : end_(recording.end), stopped_(stopped), channel_(recording.reader), robot_(channel_, model, quirks) {}

  std::optional<Frame> next() override {
    if (end_ && frames_ == end_->frames) return std::nullopt;
    while (true) {
      const std::optional<Frame> frame = robot_.next();
      if (frame) ++frames_;
      if (frame && end_ && frames_ == end_->frames && end_->why == to_string(Ended::Stopped)) stopped_.request_stop();
      if (frame || robot_.link() == LinkState::Closed) return frame;
    }
  }
  void drive(const Motion& motion) override { robot_.drive(motion); }
  void stop() override { robot_.stop(); }

 private:
  std::optional<RecordedEnd> end_;
  std::stop_source& stopped_;
  std::uint64_t frames_ = 0;
  RecordedChannel channel_;
  OiRobot robot_;
};

/// The model, as it spoke.
RobotModel model_of(const Scenario& scenario) {
  RobotModel model = find_robot(scenario.model).model;
  if (scenario.protocol) {
    model.protocol = *scenario.protocol;
    model.has_light_sensors = model.has_light_sensors && model.protocol == oi::Model::Create2;  // as SerialRobot has it
  }
  return model;
}

std::unique_ptr<Robot> robot_of(Recording& recording, const Scenario& scenario, const RobotModel& model,
                                std::stop_source& stopped) {
  oi::FirmwareQuirks quirks;
  quirks.mode_one_too_high = scenario.mode_one_too_high;
  if (recording.is_ours) return std::make_unique<ReplayedRobot>(recording, model, quirks, stopped);
  return std::make_unique<RecordedRobot>(recording.reader, model, quirks);
}

std::optional<RecordedEnd> end_of(const std::filesystem::path& file) {
  RecordingReader reader(file);
  while (reader.next()) {
  }
  return reader.mission_end();
}

void expect_frames(const Recording& recording, const Scenario& scenario, const Report& report) {
  if (report.frames > 0) return;
  const std::string why = recording.reader.cut() ? "cut before its first whole frame"
                                                 : fmt::format("holds no whole frame of a {}", scenario.model);
  throw Error(fmt::format("{}: {}; nothing can be replayed", recording.name, why), Error::Kind::Failure);
}

/// A mission that ended for want of frames, unless the robot was gone when it was driven.
bool goes_on_unrecorded(const Recording& recording, const Report& report) {
  return report.ended == Ended::RobotGone && !(recording.end && recording.end->why == to_string(Ended::RobotGone));
}

}  // namespace

Recording open_recording(const std::filesystem::path& file) {
  RecordingReader reader(file);
  if (reader.scenario().empty()) {
    throw Error(fmt::format("{}: cut before its scenario ends; nothing can be replayed", file.string()));
  }
  Scenario scenario = parse_scenario(reader.scenario(), file.string() + " (scenario)");
  const bool is_ours = !scenario.strategy.empty();
  return {file.string(), std::move(reader), std::move(scenario), end_of(file), is_ours};
}

std::optional<RunTruth> find_truth(const std::string& name, const RunResult& run) {
  if (run.scenario.world.empty()) return std::nullopt;
  try {
    const Stage stage = set_stage(run.scenario);
    const GroundTruth truth = truth_of(stage, run.scenario.resolution);
    return compare_with_truth(stage, truth, run.map.view(), run.trajectory);
  } catch (const Error& error) {
    fmt::print(stderr, "scrubjay: {}: replayed without scores: {}\n", name, error.what());
    return std::nullopt;
  }
}

RunResult run_recorded(Recording& recording, const Scenario& scenario, const ReplayOptions& options,
                       const std::stop_token& stop) {
  const auto begin = std::chrono::steady_clock::now();
  std::stop_source stopped;
  const std::stop_callback pass_on(stop, [&stopped] { stopped.request_stop(); });
  const RobotModel model = model_of(scenario);
  const std::unique_ptr<Robot> robot = robot_of(recording, scenario, model, stopped);
  Robot* source = robot.get();
  std::optional<CalibratedRobot> calibrated;
  if (scenario.calibration) source = &calibrated.emplace(*source, *scenario.calibration, model.drive);
  std::optional<PacedRobot> paced;
  if (options.speed > 0.0) source = &paced.emplace(*source, options.speed);
  const Estimation estimation = make_estimation(scenario, model);
  const std::unique_ptr<Behavior> strategy = scenario.strategy.empty()
                                                 ? std::make_unique<Passenger>()
                                                 : make_strategy(scenario.strategy, strategy_setting(scenario, model));
  Mission mission(*source, *estimation.localizer, *estimation.mapper, *strategy, {scenario.max_time});
  Track track;
  mission.watch(track);
  if (options.publishing != nullptr) {
    mission.watch(options.publishing->begin(scenario, model, run_time(options.speed)));
  }

  RunResult run;
  run.scenario = scenario;
  run.report = mission.run(stopped.get_token());
  expect_frames(recording, scenario, run.report);
  if (goes_on_unrecorded(recording, run.report)) run.report.ended = Ended::EndOfRecording;
  if (options.publishing != nullptr) options.publishing->finish(estimation.mapper->map(), run.report);
  if (recording.reader.cut()) {
    fmt::print(stderr, "scrubjay: {}: cut or damaged after {:.1f} s; replayed up to there\n", recording.name,
               run.report.time);
  }
  run.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  run.map = estimation.mapper->occupancy();
  run.trajectory = track.points();
  run.bumps = track.bumps();
  run.robot_radius = model.radius;
  run.truth = find_truth(recording.name, run);
  return run;
}

}  // namespace scrubjay::apps
