#include "faulty_run.hpp"

#include <cmath>
#include <filesystem>
#include <scrubjay/io/robot_file.hpp>
#include <scrubjay/io/world_reader.hpp>
#include <scrubjay/mission/estimation.hpp>
#include <scrubjay/mission/strategies.hpp>
#include <scrubjay/robot/oi_robot.hpp>
#include <scrubjay/robot/reconnection.hpp>
#include <scrubjay/simulation/simulated_roomba.hpp>

#include "wire_watch.hpp"

namespace scrubjay::reliability {
namespace {

constexpr double kResolution = 0.05;   // of the map [m]
constexpr double kFarthestWall = 1.0;  // an occupied cell is no farther from one than this, as far as we count [m]

enum Stream : std::uint64_t { kRobot, kStrategy, kWire };

/// A robot that is sought again when its link breaks, and that isn't left before it stands.
class SteadfastRobot final : public Robot {
 public:
  SteadfastRobot(OiRobot& robot, sim::SimulatedRoomba& roomba) : robot_(robot), roomba_(roomba) {}

  std::optional<Frame> next() override {
    while (true) {
      if (const auto frame = robot_.next()) {
        link_.alive(frame->stamp);
        last_frame_ = frame->stamp;
        pulsed_ = false;
        return frame;
      }
      if (robot_.link() == LinkState::Closed) return std::nullopt;
      const Reconnection::Step step = link_.silent(robot_.stamp());
      if (step == Reconnection::Step::GiveUp) return std::nullopt;
      if (step != Reconnection::Step::Retry) continue;
      // A damaged command may have sent it to sleep.
      if (!pulsed_ && robot_.stamp() - last_frame_ > kAsleep) {
        pulsed_ = true;
        roomba_.pulse_brc();
      }
      robot_.restart();
    }
  }
  void drive(const Motion& motion) override { robot_.drive(motion); }
  void stop() override {
    for (int attempt = 0; attempt < 4; ++attempt) {
      robot_.stop();
      if (robot_.confirm_stop(0.5)) return;
      robot_.restart();
    }
    robot_.stop();
  }
  const Reconnection& link() const { return link_; }

 private:
  static constexpr double kAsleep = 1.0;  // a robot that is silent for longer may sleep [s]

  OiRobot& robot_;
  sim::SimulatedRoomba& roomba_;
  Reconnection link_;
  double last_frame_ = 0.0;
  bool pulsed_ = false;  // in this silence
};

/// The account of both ends as of the last frame that the mission saw, and how far it was from the truth.
class Witness final : public Observer {
 public:
  Witness(const sim::SimulatedRoomba& roomba, const ClientEnd& client, const OiRobot& robot, const Pose2& start,
          RunOutcome& outcome)
      : roomba_(roomba), client_(client), robot_(robot), map_from_world_(inverse(start)), outcome_(outcome) {}

  void notify(const Snapshot& now) override {
    outcome_.due = client_.due();
    outcome_.sent = client_.sent();
    outcome_.received = client_.received();
    outcome_.false_frames = client_.false_frames();
    outcome_.counted = robot_.lost_frames();
    const Point2 truth = (map_from_world_ * roomba_.truth().pose).position();
    squares_ += (now.estimate.pose.position() - truth).squaredNorm();
    outcome_.position_error = std::sqrt(squares_ / static_cast<double>(++frames_));
  }

 private:
  const sim::SimulatedRoomba& roomba_;
  const ClientEnd& client_;
  const OiRobot& robot_;
  Pose2 map_from_world_;
  RunOutcome& outcome_;
  double squares_ = 0.0;
  std::uint64_t frames_ = 0;
};

double mean_wall_distance(const OccupancyGrid& map, const SegmentIndex& walls, const Pose2& start) {
  double sum = 0.0;
  std::size_t count = 0;
  for (std::int32_t y = 0; y < map.geometry.height; ++y) {
    for (std::int32_t x = 0; x < map.geometry.width; ++x) {
      if (map.view()[{x, y}] < kOccupiedFrom) continue;
      sum += std::min(walls.distance(start * map.geometry.center({x, y}), kFarthestWall), kFarthestWall);
      ++count;
    }
  }
  return count == 0 ? 0.0 : sum / static_cast<double>(count);
}

}  // namespace

Scenery::Scenery(const std::string& file)
    : name(std::filesystem::path(file).stem()),
      world(read_world(file)),
      index(solid_segments(world)),
      start(world.start ? *world.start : starting_pose(world, RobotModel{}.radius)),
      truth(ground_truth(world, start, RobotModel{}.radius, kResolution)) {}

RunOutcome run(const RunSetting& setting) {
  const Scenery& scenery = *setting.scenery;
  const Random random(setting.seed);
  const sim::RobotSpec spec;
  sim::SimulatedRoomba roomba(scenery.world, scenery.index, spec, setting.noise, random.fork(kRobot), scenery.start);
  RobotEnd robot_end(roomba);
  sim::FaultyChannel wire(robot_end, setting.faults, random.fork(kWire));
  robot_end.watch(wire);
  ClientEnd client_end(wire, robot_end);
  OiRobot robot(client_end, spec.model, {.sign_from_command = false});
  SteadfastRobot steadfast(robot, roomba);

  Scenario scenario;
  scenario.strategy = setting.strategy;
  scenario.resolution = kResolution;
  const Estimation estimation = make_estimation(scenario, spec.model);
  const auto strategy = make_strategy(setting.strategy, {.robot = spec.model, .random = random.fork(kStrategy)});
  Mission mission(steadfast, *estimation.localizer, *estimation.mapper, *strategy, {setting.time});
  RunOutcome outcome;
  Witness witness(roomba, client_end, robot, scenery.start, outcome);
  mission.watch(witness);
  const Report report = mission.run({});

  outcome.ended = report.ended;
  const sim::WheelSpeeds wheels = roomba.firmware().wanted();
  outcome.stands = roomba.firmware().mode() == oi::OiMode::Passive && wheels.left == 0.0 && wheels.right == 0.0;
  outcome.distance = roomba.truth().distance;
  outcome.stale_motion = robot_end.stale_motion();
  outcome.cut_motion = robot_end.cut_motion();
  outcome.foreign_commands = robot_end.foreign_commands();
  outcome.refused_commands = roomba.firmware().rejected_commands();
  outcome.rejected_values = robot.rejected_values();
  outcome.deafnesses = robot.deafnesses();
  outcome.silences = steadfast.link().silences();
  outcome.reconnections = steadfast.link().reconnections();
  outcome.longest_silence = steadfast.link().longest_silence();
  outcome.wire = wire.counters();
  const OccupancyGrid map = estimation.mapper->occupancy();
  outcome.map_error = mean_wall_distance(map, scenery.index, scenery.start);
  outcome.coverage = score_map(map.view(), scenery.truth).coverage;
  return outcome;
}

}  // namespace scrubjay::reliability
