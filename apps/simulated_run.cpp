#include "simulated_run.hpp"

#include <chrono>
#include <ctime>
#include <scrubjay/io/recording.hpp>
#include <scrubjay/io/scenario_file.hpp>
#include <scrubjay/io/world_reader.hpp>
#include <scrubjay/mapping/contact_mapper.hpp>
#include <scrubjay/mission/paced_robot.hpp>
#include <scrubjay/mission/strategies.hpp>
#include <scrubjay/mission/track.hpp>
#include <scrubjay/robot/oi_robot.hpp>
#include <scrubjay/simulation/simulated_roomba.hpp>
#include <scrubjay/world/start.hpp>

#include "data_folder.hpp"
#include "random_streams.hpp"

namespace scrubjay::apps {
namespace {

/// True poses, at the times at which Track keeps estimated ones.
class TruthTrack final : public Observer {
 public:
  TruthTrack(const sim::SimulatedRoomba& robot, const Pose2& start) : robot_(robot), map_from_world_(inverse(start)) {}

  void notify(const Snapshot& now) override {
    if (!points_.empty() && now.frame.stamp - points_.back().stamp < Track::kInterval - 1e-9) return;
    points_.push_back({now.frame.stamp, map_from_world_ * robot_.truth().pose});
  }
  const std::vector<StampedPose>& points() const { return points_; }

 private:
  const sim::SimulatedRoomba& robot_;
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
                                    : roomiest_pose(stage.world, radius);
  expect_room(stage.world, stage.index, stage.start, radius);
  return stage;
}

GroundTruth truth_of(const Stage& stage, double resolution) {
  return ground_truth(stage.world, stage.start, stage.robot.model.radius, resolution);
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
  sim::SimulatedRoomba roomba(stage.world, stage.index, stage.robot, stage.noise, random.fork(kRobotStream),
                              stage.start);
  std::optional<RecordingWriter> writer;
  std::optional<RecordingChannel> recording;
  if (options.record) {
    writer.emplace(*options.record, scenario_text(scenario));
    recording.emplace(roomba, *writer);
  }
  OiRobot robot(recording ? static_cast<ByteChannel&>(*recording) : roomba, model);
  std::optional<PacedRobot> paced;
  if (options.speed > 0.0) paced.emplace(robot, options.speed);

  DeadReckoning localizer(model.drive);
  ContactMapper mapper(model, scenario.resolution);
  const std::unique_ptr<Behavior> strategy = make_strategy(scenario.strategy, model, random.fork(kStrategyStream));
  Mission mission(paced ? static_cast<Robot&>(*paced) : robot, localizer, mapper, *strategy, {scenario.max_time});
  Track track;
  TruthTrack truth_track(roomba, stage.start);
  mission.watch(track);
  mission.watch(truth_track);
  if (options.onlooker != nullptr) mission.watch(*options.onlooker);

  RunResult run;
  run.scenario = scenario;
  run.report = mission.run(stop);
  if (writer) writer->close();
  run.cpu_time = thread_cpu_time() - cpu_begin;
  run.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_begin).count();
  run.map = mapper.occupancy();
  run.trajectory = track.points();
  run.bumps = track.bumps();
  run.robot_radius = model.radius;
  run.truth = compare_with_truth(stage, truth, run.map.view(), run.trajectory);
  run.truth->trajectory = truth_track.points();
  run.truth->error = trajectory_error(run.trajectory, run.truth->trajectory);
  return run;
}

}  // namespace scrubjay::apps
