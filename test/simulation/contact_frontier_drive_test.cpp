#include <gtest/gtest.h>

#include <filesystem>
#include <io/our_worlds.hpp>
#include <scrubjay/exploration/contact_frontier.hpp>
#include <scrubjay/io/robot_file.hpp>
#include <scrubjay/io/world_reader.hpp>
#include <scrubjay/localization/localizer.hpp>
#include <scrubjay/mapping/contact_mapper.hpp>
#include <scrubjay/mission/mission.hpp>
#include <scrubjay/mission/track.hpp>
#include <scrubjay/robot/oi_robot.hpp>
#include <scrubjay/simulation/simulated_roomba.hpp>
#include <scrubjay/world/score.hpp>

namespace scrubjay::test {
namespace {

const std::filesystem::path kTree = SCRUBJAY_SOURCE_DIR;

class WheelDrops final : public Observer {
 public:
  void notify(const Snapshot& now) override { count += now.frame.wheel_dropped(); }
  int count = 0;
};

struct Outcome {
  Report report;
  MapScore score;
  std::vector<StampedPose> way;
  int wheel_drops = 0;
};

/// Explores a world of ours, with the robot turned by `turn` at its start [rad].
Outcome explore(const std::string& name, double turn, const char* profile = "none", std::uint64_t seed = 1) {
  World world = read_world(kTree / "worlds" / (name + ".yaml"));
  for (Door& door : world.doors) door.open = true;  // the gate before the stairs, too
  const SegmentIndex index(solid_segments(world));
  const sim::RobotSpec spec = read_robot(kTree / "urdf" / "roomba_600.urdf");
  const sim::NoiseProfile noise = read_noise(kTree / "urdf" / "noise.yaml", profile);
  Pose2 start = world.start.value_or(Pose2{});
  start.yaw = wrap_angle(start.yaw + turn);
  const Random random(seed);
  sim::SimulatedRoomba roomba(world, index, spec, noise, random.fork(0), start);
  OiRobot robot(roomba, spec.model);
  DeadReckoning localizer(spec.model.drive);
  ContactMapper mapper(spec.model, 0.05);
  ContactFrontier behavior(spec.model, random.fork(1));
  Mission mission(robot, localizer, mapper, behavior, {7200.0});
  Track track;
  WheelDrops drops;
  mission.watch(track);
  mission.watch(drops);
  Outcome outcome;
  outcome.report = mission.run({});
  const GroundTruth truth = ground_truth(world, start, spec.model.radius, 0.05);
  const OccupancyGrid map = mapper.occupancy();
  outcome.score = score_map(map.view(), truth);
  outcome.way = track.points();
  outcome.wheel_drops = drops.count;
  return outcome;
}

class ContactFrontierDriveTest : public ::testing::TestWithParam<std::tuple<std::string, double>> {};

TEST_P(ContactFrontierDriveTest, KnowsTheWholeHouseAndEndsByItself) {
  const auto& [name, turn] = GetParam();
  const Outcome outcome = explore(name, turn);
  EXPECT_EQ(outcome.report.ended, Ended::Done) << to_string(outcome.report.ended);
  EXPECT_GE(outcome.score.coverage, 0.97);
  EXPECT_GE(outcome.score.iou, 0.95);
  EXPECT_GE(outcome.score.wall_recall, 0.96);
  EXPECT_GE(outcome.score.wall_precision, 0.95);
  EXPECT_EQ(outcome.wheel_drops, 0) << "it must stop before the stairs";
}

INSTANTIATE_TEST_SUITE_P(All, ContactFrontierDriveTest,
                         ::testing::Combine(::testing::ValuesIn(our_worlds()), ::testing::Values(0.0)),
                         [](const auto& tested) { return std::get<0>(tested.param); });
// The map's cells and the walls needn't be in line.
INSTANTIATE_TEST_SUITE_P(Turned, ContactFrontierDriveTest,
                         ::testing::Combine(::testing::Values("reactive_trap", "apartment"),
                                            ::testing::Values(0.37, 0.74)),
                         [](const auto& tested) {
                           return std::get<0>(tested.param) + (std::get<1>(tested.param) < 0.5 ? "_a_bit" : "_more");
                         });

TEST(ContactFrontierRunTest, DrivesTheSameWayAgain) {
  EXPECT_EQ(explore("room", 0.2).way, explore("room", 0.2).way);
}

TEST(ContactFrontierRunTest, SurvivesADriftingPose) {
  for (const std::uint64_t seed : {1u, 2u}) {
    const Outcome outcome = explore("room", 0.0, "hard-floor", seed);
    EXPECT_EQ(outcome.report.ended, Ended::Done) << to_string(outcome.report.ended);
    EXPECT_GT(outcome.score.coverage, 0.6);
  }
}

}  // namespace
}  // namespace scrubjay::test
