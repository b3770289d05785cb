#include <gtest/gtest.h>

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

/// What explorations came to.
struct Total {
  double coverage = 0.0;  ///< mean
  double distance = 0.0;  ///< [m]
};

template <typename Explore>
Total total(const World& world, const Pose2& start, std::initializer_list<double> headings, double robot_radius,
            double reach, Explore explore) {
  Total sum;
  for (const double yaw : headings) {
    const Pose2 turned{start.x, start.y, yaw};
    const Explored explored = explore(world, turned, reach);
    const GroundTruth truth = ground_truth(world, turned, robot_radius, kResolution);
    sum.coverage += score_map(explored.map.view(), truth).coverage / static_cast<double>(headings.size());
    sum.distance += explored.report.distance;
  }
  return sum;
}

World large_house() {
  return read_world(std::filesystem::path(SCRUBJAY_SOURCE_DIR) / "worlds/large_house.yaml");
}

// A map's corner goes into the last bits of its cells' places, so runs aren't the same; they must be as good.

TEST(MapGrowthTest, ALidarExploresALargeHouseAsWellFromOneCellOn) {
  const World world = large_house();
  const double radius = Burger::spec().model.radius;
  const Total grown = total(world, *world.start, {0.0}, radius, 0.0, explored_by_lidar);
  const Total preallocated = total(world, *world.start, {0.0}, radius, kWholeHouse, explored_by_lidar);
  EXPECT_GE(grown.coverage, preallocated.coverage - 0.002);
  EXPECT_LE(grown.distance, 1.2 * preallocated.distance);
  EXPECT_GE(grown.coverage, 0.99);
}

TEST(MapGrowthTest, ARoombaDoes) {
  const World world = large_house();
  const double radius = RobotModel{}.radius;
  const Total grown = total(world, *world.start, {0.0}, radius, 0.0, explored_by_touch);
  const Total preallocated = total(world, *world.start, {0.0}, radius, kWholeHouse, explored_by_touch);
  EXPECT_GE(grown.coverage, 0.95 * preallocated.coverage) << "of what twenty minutes allow";
  EXPECT_LE(grown.distance, 1.2 * preallocated.distance);
}

TEST(MapGrowthTest, ALidarDoesInAHouseOfTenRooms) {
  const std::filesystem::path plans = std::filesystem::path(SCRUBJAY_SHARED_DATA) / "houseexpo";
  if (!std::filesystem::exists(plans)) GTEST_SKIP() << "no floor plans here";
  const World world = read_world(plans / "4b7b9c1f1ec4fd0a5024ea987674ad08.json");
  const double radius = Burger::spec().model.radius;
  const Pose2 start = starting_pose(world, radius);
  const Total grown = total(world, start, {0.0, 1.1}, radius, 0.0, explored_by_lidar);
  const Total preallocated = total(world, start, {0.0, 1.1}, radius, kWholeHouse, explored_by_lidar);
  EXPECT_GE(grown.coverage, preallocated.coverage - 0.002);
  EXPECT_LE(grown.distance, 1.2 * preallocated.distance);
}

}  // namespace
}  // namespace scrubjay::test
