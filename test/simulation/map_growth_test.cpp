#include <gtest/gtest.h>

#include <algorithm>
#include <scrubjay/io/world_reader.hpp>
#include <scrubjay/localization/localizer.hpp>
#include <scrubjay/mapping/contact_mapper.hpp>
#include <scrubjay/mapping/lidar_mapper.hpp>
#include <scrubjay/mission/mission.hpp>
#include <scrubjay/mission/strategies.hpp>
#include <scrubjay/robot/oi_robot.hpp>
#include <scrubjay/simulation/simulated_roomba.hpp>
#include <scrubjay/world/score.hpp>

#include "burger.hpp"

namespace scrubjay::test {
namespace {

constexpr double kResolution = 0.05;
constexpr double kWholeHouse = 25.0;  // [m]: no house here is larger

struct Explored {
  Report report;
  OccupancyGrid map;
};

Explored run(Robot& robot, Mapper& mapper, const RobotModel& model, double max_time) {
  DeadReckoning localizer(model.drive);
  const std::unique_ptr<Behavior> strategy =
      make_strategy(default_strategy(model), {.robot = model, .random = Random(3)});
  Mission mission(robot, localizer, mapper, *strategy, {max_time});
  const Report report = mission.run({});
  return {report, mapper.occupancy()};
}

/// By a Burger, with a map that covers `reach` around its origin from the start.
Explored explored_by_lidar(const World& world, const Pose2& start, double reach) {
  Burger burger(world, start);
  LidarMapper mapper(Burger::spec().model, kResolution, {}, reach);
  return run(burger.robot, mapper, Burger::spec().model, 3600.0);
}

Explored explored_by_touch(const World& world, const Pose2& start, double reach) {
  const SegmentIndex index(solid_segments(world));
  const sim::RobotSpec spec;
  sim::SimulatedRoomba roomba(world, index, spec, {}, Random(1), start);
  OiRobot robot(roomba, spec.model);
  ContactMapper mapper(spec.model, kResolution, {}, reach);
  return run(robot, mapper, spec.model, 1200.0);
}

void expect_same(const Explored& grown, const Explored& preallocated) {
  EXPECT_EQ(grown.report.time, preallocated.report.time);
  EXPECT_EQ(grown.report.distance, preallocated.report.distance);
  EXPECT_EQ(grown.report.pose, preallocated.report.pose);
  EXPECT_EQ(grown.report.leftovers.size(), preallocated.report.leftovers.size());
  EXPECT_EQ(grown.map.cells, preallocated.map.cells);
  EXPECT_GT(std::ranges::count(grown.map.cells, kFree), 10'000);
}

TEST(MapGrowthTest, ALidarExploresALargeHouseTheSameWayHoweverLargeItsMapBegins) {
  const World world = read_world(std::filesystem::path(SCRUBJAY_SOURCE_DIR) / "worlds/large_house.yaml");
  const Pose2 start = *world.start;
  expect_same(explored_by_lidar(world, start, 0.0), explored_by_lidar(world, start, kWholeHouse));
}

TEST(MapGrowthTest, ARoombaDoes) {
  const World world = read_world(std::filesystem::path(SCRUBJAY_SOURCE_DIR) / "worlds/large_house.yaml");
  const Pose2 start = *world.start;
  expect_same(explored_by_touch(world, start, 0.0), explored_by_touch(world, start, kWholeHouse));
}

TEST(MapGrowthTest, AHouseOfTenRoomsIsExploredTheSameWay) {
  const std::filesystem::path plans = std::filesystem::path(SCRUBJAY_SHARED_DATA) / "houseexpo";
  if (!std::filesystem::exists(plans)) GTEST_SKIP() << "no floor plans here";
  const World world = read_world(plans / "4b7b9c1f1ec4fd0a5024ea987674ad08.json");
  const Pose2 start = roomiest_pose(world, Burger::spec().model.radius);
  expect_same(explored_by_lidar(world, start, 0.0), explored_by_lidar(world, start, kWholeHouse));
}

}  // namespace
}  // namespace scrubjay::test
