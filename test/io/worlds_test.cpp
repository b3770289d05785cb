/// \file
/// The worlds that come with scrubjay, and real plans and maps where they are at hand.
#include <gtest/gtest.h>

#include <io/temporary_folder.hpp>
#include <scrubjay/io/world_reader.hpp>
#include <scrubjay/world/score.hpp>
#include <scrubjay/world/segment_index.hpp>

#include "world/disc.hpp"

namespace scrubjay {
namespace {

namespace fs = std::filesystem;
double reachable_area(const World& world, const Pose2& start, double resolution = 0.05) {
  const GroundTruth truth = ground_truth(world, start, kRadius, resolution);
  return static_cast<double>(truth.reachable_count) * resolution * resolution;
}

/// A world of ours: a place in each of its rooms, and its floor.
struct ExpectedWorld {
  std::string name;
  std::vector<Point2> rooms;
  double area;  ///< that the robot reaches, to 3 % [m^2]
};

class OurWorldTest : public testing::TestWithParam<ExpectedWorld> {
 protected:
  World world = read_world(fs::path(SCRUBJAY_SOURCE_DIR) / "worlds" / (GetParam().name + ".yaml"));
};

TEST_P(OurWorldTest, IsNamedAfterItsFile) {
  EXPECT_EQ(world.name, GetParam().name);
}

TEST_P(OurWorldTest, StartsWithRoomAround) {
  ASSERT_TRUE(world.start.has_value());
  const SegmentIndex index(solid_segments(world));
  EXPECT_GE(index.distance(world.start->position(), 10.0), 0.3 + kRadius);
}

TEST_P(OurWorldTest, HasADockAtAWallWithFloorBeforeIt) {
  ASSERT_TRUE(world.dock.has_value());
  const SegmentIndex index(solid_segments(world));
  EXPECT_LE(index.distance(world.dock->pose.position(), 10.0), 0.15);
  EXPECT_GE(index.distance(world.dock->pose * Point2(0.5, 0.0), 10.0), kRadius);
}

TEST_P(OurWorldTest, AllItsRoomsCanBeReached) {
  const GroundTruth truth = ground_truth(world, *world.start, kRadius, 0.05);
  for (const Point2& room : GetParam().rooms) {
    const CellIndex cell = truth.geometry.cell_at(inverse(*world.start) * room);
    ASSERT_TRUE(truth.geometry.contains(cell));
    EXPECT_TRUE(truth.cells[truth.geometry.index(cell)].reachable) << room.transpose();
  }
  EXPECT_NEAR(reachable_area(world, *world.start), GetParam().area, 0.03 * GetParam().area);
}

INSTANTIATE_TEST_SUITE_P(
    Worlds, OurWorldTest,
    testing::Values(ExpectedWorld{"room", {{1, 2.7}, {3, 0.5}}, 14.0},  //
                    ExpectedWorld{"reactive_trap", {{1, 1.5}, {2.75, 0.7}, {5, 1.2}}, 17.0},
                    ExpectedWorld{
                        "corridor_flat", {{5, 3.5}, {2.4, 2}, {5.4, 1.5}, {9, 1.5}, {3, 5}, {6, 5}, {9, 5.5}}, 56.7},
                    ExpectedWorld{"apartment", {{1, 3.3}, {6, 4.6}, {5.3, 1.5}}, 33.4},
                    ExpectedWorld{"cluttered_flat", {{1.9, 3.7}, {6, 3.8}, {6.3, 1}}, 34.4},
                    ExpectedWorld{"family_house", {{3.5, 2}, {3.8, 6.5}, {5.7, 4}, {7.2, 2}, {9, 4.8}, {8.5, 7}}, 68.4},
                    ExpectedWorld{"large_house",
                                  {{1.5, 4},
                                   {2.5, 1.2},
                                   {6, 4.3},
                                   {10, 3},
                                   {13, 4.4},
                                   {16, 4.3},
                                   {2, 8},
                                   {5.5, 8},
                                   {9.5, 8},
                                   {13, 7.4},
                                   {12.7, 10.7},
                                   {16, 9},
                                   {3, 6}},
                                  169.4}),
    [](const auto& test) { return test.param.name; });

TEST(WorldsTest, EveryWorldIsTested) {
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(SCRUBJAY_SOURCE_DIR) / "worlds")) {
    files += entry.path().extension() == ".yaml" ? 1 : 0;
  }
  EXPECT_EQ(files, 7u) << "a new world wants a line above";
}

TEST(WorldsTest, TheTableOfTheClutteredFlatCanBePassedUnder) {
  const World world = read_world(fs::path(SCRUBJAY_SOURCE_DIR) / "worlds/cluttered_flat.yaml");
  EXPECT_GE(ground_truth(world, *world.start, kRadius, 0.05).boundary_count, 20) << "legs stand on their own";
}

TEST(RealPlansTest, AllFloorPlansOpenAndHaveRoom) {
  const fs::path folder = fs::path(SCRUBJAY_SHARED_DATA) / "houseexpo";
  if (!fs::exists(folder)) GTEST_SKIP() << "no floor plans here";
  std::size_t plans = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".json") continue;
    ++plans;
    const World world = read_world(entry.path());
    EXPECT_EQ(world.name, entry.path().stem());
    const Pose2 start = starting_pose(world, kRadius);
    EXPECT_TRUE(contains(world.walls[0].points, start.position())) << world.name;
    EXPECT_GT(reachable_area(world, start, 0.1), 10.0) << world.name;
  }
  EXPECT_EQ(plans, 64u);
}

TEST(RealMapsTest, MapsBecomeWorldsWithRoom) {
  const fs::path folder = fs::path(SCRUBJAY_SHARED_DATA) / "maps";
  if (!fs::exists(folder)) GTEST_SKIP() << "no maps here";
  const TemporaryFolder own;
  const fs::path willow = own.write("willow.yaml", "image: " + fs::absolute(folder / "willow-full-0.05.pgm").string() +
                                                       "\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\n"
                                                       "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
  const std::vector<std::pair<fs::path, double>> maps{{folder / "tb3_sandbox.yaml", 15.0},
                                                      {folder / "depot.yaml", 350.0},
                                                      {folder / "warehouse.yaml", 1000.0},
                                                      {willow, 800.0}};
  for (const auto& [path, least_area] : maps) {
    const World world = read_world(path);
    EXPECT_GT(reachable_area(world, starting_pose(world, kRadius), 0.1), least_area) << path;
  }
}

}  // namespace
}  // namespace scrubjay
