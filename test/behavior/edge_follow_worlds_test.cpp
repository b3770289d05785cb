#include <gtest/gtest.h>

#include <filesystem>
#include <io/our_worlds.hpp>
#include <scrubjay/behavior/edge_follow.hpp>
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

class EdgeFollowWorldsTest : public ::testing::TestWithParam<std::tuple<std::string, std::uint64_t>> {};

TEST_P(EdgeFollowWorldsTest, MapsTheWallsThatItFollows) {
  const auto& [name, seed] = GetParam();
  const World world = read_world(kTree / "worlds" / (name + ".yaml"));
  ASSERT_TRUE(world.start);
  const SegmentIndex index(solid_segments(world));
  const sim::RobotSpec spec = read_robot(kTree / "urdf" / "roomba_600.urdf");
  const Random random(seed);
  sim::SimulatedRoomba roomba(world, index, spec, {}, random.fork(1), *world.start);
  OiRobot robot(roomba, spec.model);
  DeadReckoning localizer(spec.model.drive);
  ContactMapper mapper(spec.model, 0.05);
  EdgeFollow behavior(spec.model, random.fork(2));
  Mission mission(robot, localizer, mapper, behavior, {7200.0});
  Track track;
  mission.watch(track);
  const Report report = mission.run({});

  const GroundTruth truth = ground_truth(world, *world.start, spec.model.radius, 0.05);
  const auto followed = followed_boundaries(truth, track.points(), spec.model.radius);
  ASSERT_FALSE(followed.empty());
  const OccupancyGrid map = mapper.occupancy();
  const MapScore score = score_map(map.view(), truth, followed);
  EXPECT_GE(score.followed_wall_recall, 0.95);
  EXPECT_GE(score.followed_wall_precision, 0.95);
  EXPECT_TRUE(report.ended == Ended::Done || report.ended == Ended::TimeLimit) << to_string(report.ended);
  EXPECT_GE(behavior.loops_closed(), 1);
}

INSTANTIATE_TEST_SUITE_P(All, EdgeFollowWorldsTest,
                         ::testing::Combine(::testing::ValuesIn(our_worlds()), ::testing::Values(1u, 2u)),
                         [](const auto& tested) {
                           return std::get<0>(tested.param) + "_" + std::to_string(std::get<1>(tested.param));
                         });

}  // namespace
}  // namespace scrubjay::test
