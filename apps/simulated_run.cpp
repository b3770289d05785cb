#include "simulated_run.hpp"

#include <chrono>
#include <ctime>
#include <scrubjay/error.hpp>
#include <scrubjay/io/recording.hpp>
#include <scrubjay/io/scenario_file.hpp>
#include <scrubjay/io/world_reader.hpp>
#include <scrubjay/mission/estimation.hpp>
#include <scrubjay/mission/paced_robot.hpp>
#include <scrubjay/mission/strategies.hpp>
#include <scrubjay/mission/track.hpp>
#include <scrubjay/robot/calibrated_robot.hpp>
#include <scrubjay/robot/oi_robot.hpp>
#include <scrubjay/simulation/simulated_roomba.hpp>
#include <scrubjay/simulation/simulated_turtlebot.hpp>
#include <scrubjay/world/start.hpp>

#include "data_folder.hpp"
#include "publishing.hpp"
#include "random_streams.hpp"
#include "steering.hpp"

namespace scrubjay::apps {
namespace {

/// A simulated robot, and all that stands between it and the mission.
class SimulatedRobot {
 public:
  SimulatedRobot(const Scenario& scenario, const Stage& stage, const RunOptions& options, const Random& random) {
    const RobotModel& model = stage.robot.model;
    if (!model.open_interface) {
      turtlebot_.emplace(stage.world, stage.index, stage.robot, stage.noise, random, stage.start,
                         sim::TurtlebotOptions{scenario.motion_distortion});
      robot_ = &*turtlebot_;
    } else {
      roomba_.emplace(stage.world, stage.index, stage.robot, stage.noise, random, stage.start);
      if (options.record) {
        writer_.emplace(*options.record, scenario_text(scenario));
        recording_.emplace(*roomba_, *writer_);
      }
      robot_ = &oi_robot_.emplace(recording_ ? static_cast<ByteChannel&>(*recording_) : *roomba_, model);
    }
    if (scenario.calibration) robot_ = &calibrated_.emplace(*robot_, *scenario.calibration, model.drive);
    if (options.speed > 0.0) robot_ = &paced_.emplace(*robot_, options.speed);
  }

  Robot& robot() { return *robot_; }
  const sim::Truth& truth() const { return roomba_ ? roomba_->truth() : turtlebot_->truth(); }
  void close_recording(const Report& report) {
    if (!writer_) return;
    writer_->record_end({report.frames, std::string(to_string(report.ended))});
    writer_->close();
  }

 private:
  std::optional<sim::SimulatedTurtlebot> turtlebot_;
  std::optional<sim::SimulatedRoomba> roomba_;
  std::optional<RecordingWriter> writer_;
  std::optional<RecordingChannel> recording_;
  std::optional<OiRobot> oi_robot_;
  std::optional<CalibratedRobot> calibrated_;
  std::optional<PacedRobot> paced_;
  Robot* robot_ = nullptr;
};

/// True poses, at the times at which Track keeps estimated ones.
class TruthTrack final : public Observer {
 public:
  TruthTrack(const SimulatedRobot& robot, const Pose2& start) : robot_(robot), map_from_world_(inverse(start)) {}

  void notify(const Snapshot& now) override {
    if (!points_.empty() && now.frame.stamp - points_.back().stamp < Track::kInterval - 1e-9) return;
    points_.push_back({now.frame.stamp, map_from_world_ * robot_.truth().pose});
  }
  const std::vector<StampedPose>& points() const { return points_; }

 private:
  const SimulatedRobot& robot_;
  Pose2 map_from_world_;
  std::vector<StampedPose> points_;
};

double thread_cpu_time() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

Stage set_stage(const Scenario& scenario) {
  World world = read_world(scenario.world);
  SegmentIndex index(solid_segments(world));
  Stage stage{std::move(world), std::move(index), find_robot(scenario.model), find_noise(scenario.noise), {}};
  const double radius = stage.robot.model.radius;
  stage.start = scenario.start      ? *scenario.start
                : stage.world.start ? *stage.world.start
                                    : starting_pose(stage.world, radius);
  expect_room(stage.world, stage.index, stage.start, radius);
  return stage;
}

GroundTruth truth_of(const Stage& stage, double resolution) {
  return ground_truth(stage.world, stage.start, stage.robot.model.radius, resolution);
}

StrategySetting strategy_setting(const Scenario& scenario, const RobotModel& robot) {
  return {robot, Random(scenario.seed).fork(kStrategyStream), scenario.within, scenario.return_home};
}

RunTruth compare_with_truth(const Stage& stage, const GroundTruth& truth, GridView<const Occupancy> map,
                            std::span<const StampedPose> trajectory) {
  RunTruth result;
  result.start = stage.start;
  result.walls = walls_in_map(stage.world, stage.start);
  if (stage.world.dock) result.dock = inverse(stage.start) * stage.world.dock->pose;
  result.score = score_map(map, truth, followed_boundaries(truth, trajectory, stage.robot.model.radius));
  return result;
}

RunResult run_simulated(const Scenario& scenario, const Stage& stage, const GroundTruth& truth,
                        const RunOptions& options, const std::stop_token& stop) {
  const auto wall_begin = std::chrono::steady_clock::now();
  const double cpu_begin = thread_cpu_time();
  const Random random(scenario.seed);
  const RobotModel& model = stage.robot.model;
  SimulatedRobot simulated(scenario, stage, options, random.fork(kRobotStream));
  Estimation estimation = make_estimation(scenario, model);
  if (options.steering != nullptr) options.steering->correct(estimation, model);
  const std::unique_ptr<Behavior> strategy = options.steering != nullptr
                                                 ? options.steering->behavior(model)
                                                 : make_strategy(scenario.strategy, strategy_setting(scenario, model));
  const std::unique_ptr<Robot> between =
      options.steering != nullptr ? options.steering->between(simulated.robot()) : nullptr;
  Mission mission(between ? *between : simulated.robot(), *estimation.localizer, *estimation.mapper, *strategy,
                  {scenario.max_time});
  Track track;
  TruthTrack truth_track(simulated, stage.start);
  mission.watch(track);
  mission.watch(truth_track);
  if (options.onlooker != nullptr) mission.watch(*options.onlooker);
  if (options.publishing != nullptr) {
    mission.watch(options.publishing->begin(scenario, model, run_time(options.speed)));
  }

  RunResult run;
  run.scenario = scenario;
  run.report = mission.run(stop);
  if (options.publishing != nullptr) options.publishing->finish(estimation.mapper->map(), run.report);
  simulated.close_recording(run.report);
  run.cpu_time = thread_cpu_time() - cpu_begin;
  run.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_begin).count();
  run.map = estimation.mapper->occupancy();
  run.trajectory = track.points();
  run.bumps = track.bumps();
  run.robot_radius = model.radius;
  run.has_bumper = model.open_interface;
  run.truth = compare_with_truth(stage, truth, run.map.view(), run.trajectory);
  run.truth->trajectory = truth_track.points();
  run.truth->contacts = simulated.truth().bumps;
  run.truth->error = trajectory_error(run.trajectory, run.truth->trajectory);
  return run;
}

}  // namespace scrubjay::apps
