#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <scrubjay/error.hpp>
#include <scrubjay/world/score.hpp>
#include <set>

#include "world/disc.hpp"

namespace scrubjay {
namespace {

Wall closed(Polygon corners) {
  corners.push_back(corners.front());
  return {corners};
}

/// A rectangular room from (0, 0) on.
World room(double width, double depth) {
  World world;
  world.walls.push_back(closed({{0, 0}, {width, 0}, {width, depth}, {0, depth}}));
  return world;
}

const GroundTruth::Cell& cell_at(const GroundTruth& truth, const Point2& p) {
  return truth.cells[truth.geometry.index(truth.geometry.cell_at(p))];
}

double reachable_area(const GroundTruth& truth) {
  return static_cast<double>(truth.reachable_count) * truth.geometry.resolution * truth.geometry.resolution;
}

TEST(GroundTruthTest, ReachesARoomButForItsCornersAndWalls) {
  // 3 x 2 m around the start: walls run through the middle of cells of 5 cm.
  World world = room(3.05, 2.05);
  const GroundTruth truth = ground_truth(world, {1.025, 1.025, 0.0}, kRadius, 0.05);
  // A disc in a right corner leaves r^2 (1 - pi / 4) unswept.
  const double corners = 4.0 * kRadius * kRadius * (1.0 - kPi / 4.0);
  EXPECT_NEAR(reachable_area(truth), 3.0 * 2.0 - corners, 4 * 2 * 0.05 * 0.05) << "within two cells a corner";
  EXPECT_EQ(truth.boundary_count, 1);
  EXPECT_TRUE(cell_at(truth, {0.0, 0.0}).reachable);
  EXPECT_FALSE(cell_at(truth, {-1.0, -1.0}).reachable) << "a corner";
  EXPECT_FALSE(cell_at(truth, {2.2, 0.0}).reachable) << "beyond the wall";
}

TEST(GroundTruthTest, MarksWallsWhereTheyRunAndFacingWhereTheDiscTouches) {
  const GroundTruth truth = ground_truth(room(3.05, 2.05), {1.025, 1.025, 0.0}, kRadius, 0.05);
  int walls = 0;
  int facing = 0;
  for (const GroundTruth::Cell& cell : truth.cells) {
    walls += cell.wall ? 1 : 0;
    facing += cell.facing ? 1 : 0;
    EXPECT_FALSE(cell.wall && cell.reachable);
    EXPECT_EQ(cell.facing, cell.boundary != 0);
    EXPECT_TRUE(cell.wall || !cell.facing);
  }
  EXPECT_EQ(walls, 2 * (61 + 41)) << "61 and 41 steps of a cell";
  // The disc touches no wall nearer to a corner than its radius (bar the lattice's diagonal, some 8 cm along the wall).
  EXPECT_TRUE(cell_at(truth, {-1.025, 0.0}).facing);
  EXPECT_TRUE(cell_at(truth, {-1.025, -1.025 + 0.175}).facing);
  EXPECT_FALSE(cell_at(truth, {-1.025, -1.025}).facing);
  EXPECT_GT(facing, walls - 4 * 8);
}

TEST(GroundTruthTest, PutsTheMapsOriginOnACornerOfCellsInTheStartsFrame) {
  const GroundTruth truth = ground_truth(room(4, 3), {1.0, 2.0, radians(90)}, kRadius, 0.05);
  const Point2 cells = truth.geometry.origin / 0.05;
  EXPECT_NEAR(cells.x(), std::round(cells.x()), 1e-9);
  EXPECT_NEAR(cells.y(), std::round(cells.y()), 1e-9);
  // Looking along the world's y: the wall x = 4 is 3 m to the right, y = 0 is 2 m behind.
  EXPECT_TRUE(cell_at(truth, {0.0, -2.9}).reachable);
  EXPECT_FALSE(cell_at(truth, {0.0, -3.1}).reachable);
  EXPECT_TRUE(cell_at(truth, {-1.9, 0.0}).reachable);
  EXPECT_FALSE(cell_at(truth, {-2.1, 0.0}).reachable);
}

/// Two rooms of 2 x 2 m with a gap of `width` in the wall between them.
World two_rooms(double width) {
  World world = room(4, 2);
  world.walls.push_back({{{2, 0}, {2, 1 - width / 2}}});
  world.walls.push_back({{{2, 1 + width / 2}, {2, 2}}});
  return world;
}

TEST(GroundTruthTest, ADiscPassesAGapOf38CentimetresButNotOneOf34) {
  for (const double yaw : {0.0, 0.3, 1.1}) {
    const GroundTruth narrow = ground_truth(two_rooms(0.34), {1, 1, yaw}, kRadius, 0.05);
    const GroundTruth wide = ground_truth(two_rooms(0.38), {1, 1, yaw}, kRadius, 0.05);
    EXPECT_LT(reachable_area(narrow), 4.2) << yaw;
    EXPECT_GT(reachable_area(wide), 7.4) << yaw;
    const Point2 beyond = inverse({1, 1, yaw}) * Point2(3, 1);
    EXPECT_FALSE(cell_at(narrow, beyond).reachable);
    EXPECT_TRUE(cell_at(wide, beyond).reachable);
  }
}

TEST(GroundTruthTest, AGapThatIsTooNarrowJoinsWhatIsOnItsSides) {
  EXPECT_EQ(ground_truth(two_rooms(0.34), {1, 1, 0}, kRadius, 0.05).boundary_count, 1);
  World world = room(4, 4);
  world.furniture.push_back({"left", {box({1.5, 2}, {0.5, 0.5}, 0)}});
  world.furniture.push_back({"right", {box({2.5, 2}, {0.5, 0.5}, 0)}});  // 0.5 m between them
  EXPECT_EQ(ground_truth(world, {2, 0.5, 0}, kRadius, 0.05).boundary_count, 3);
  world.furniture[1].parts = {box({2.3, 2}, {0.5, 0.5}, 0)};  // 0.3 m
  EXPECT_EQ(ground_truth(world, {2, 0.5, 0}, kRadius, 0.05).boundary_count, 2);
}

TEST(GroundTruthTest, TheLegsOfATableAreBoundariesOfTheirOwn) {
  World world = room(4, 4);
  Furniture table{"table", {}};
  for (const double x : {1.4, 2.6}) {
    for (const double y : {1.6, 2.4}) table.parts.push_back(disc({x, y}, 0.025));
  }
  world.furniture.push_back(table);
  const GroundTruth truth = ground_truth(world, {2, 0.5, 0}, kRadius, 0.05);
  EXPECT_EQ(truth.boundary_count, 5);
  std::set<int> legs;
  for (const Polygon& leg : table.parts) {
    const GroundTruth::Cell& cell = cell_at(truth, leg[0] - Point2(2, 0.5));
    EXPECT_TRUE(cell.facing);
    legs.insert(cell.boundary);
  }
  EXPECT_EQ(legs, (std::set<int>{2, 3, 4, 5})) << "the room's own wall is the largest";
  EXPECT_EQ(cell_at(truth, {-2 + 0.001, 1.0}).boundary, 1);
}

TEST(GroundTruthTest, RoomsThatCannotBeEnteredFaceNothing) {
  World world = two_rooms(0.2);
  world.furniture.push_back({"shelf", {box({3, 1}, {0.2, 0.2}, 0)}});
  const GroundTruth truth = ground_truth(world, {1, 1, 0}, kRadius, 0.05);
  EXPECT_TRUE(cell_at(truth, {1.9, 0.0}).wall);
  EXPECT_FALSE(cell_at(truth, {1.9, 0.0}).facing);
  EXPECT_EQ(truth.boundary_count, 1);
}

TEST(GroundTruthTest, ClosedDoorsBlockAndOpenOnesDoNot) {
  World world = two_rooms(0.9);
  world.doors.push_back({{{2, 0.55}, {2, 1.45}}, true});
  EXPECT_GT(reachable_area(ground_truth(world, {1, 1, 0}, kRadius, 0.05)), 7.4);
  world.doors[0].open = false;
  EXPECT_LT(reachable_area(ground_truth(world, {1, 1, 0}, kRadius, 0.05)), 4.0);
}

TEST(GroundTruthTest, TheDiscMayNotOverhangACliff) {
  World world = room(4, 2);
  world.cliffs.push_back({{2, -1}, {5, -1}, {5, 3}, {2, 3}});
  const GroundTruth truth = ground_truth(world, {1, 1, 0}, kRadius, 0.05);
  EXPECT_TRUE(cell_at(truth, {0.95, 0.0}).reachable);
  EXPECT_FALSE(cell_at(truth, {1.05, 0.0}).reachable);
  EXPECT_FALSE(cell_at(truth, {2.0, 0.0}).reachable) << "well inside";
  EXPECT_TRUE(cell_at(truth, {1.0, 0.0}).wall) << "its edge belongs into a map, as a wall does";
  EXPECT_FALSE(cell_at(truth, {1.0, 0.0}).facing) << "... but can't be touched";
  EXPECT_FALSE(cell_at(truth, {1.5, 0.0}).wall) << "only its edge";
}

TEST(GroundTruthTest, AWorldWithoutWallsEndsAroundTheStart) {
  const GroundTruth truth = ground_truth({}, {5, 5, 1}, kRadius, 0.05);
  EXPECT_TRUE(cell_at(truth, {0, 0}).reachable);
  EXPECT_LT(reachable_area(truth), 0.6);
  EXPECT_EQ(truth.boundary_count, 0);
}

TEST(GroundTruthTest, TheSameWorldTurnedHasTheSameTruth) {
  const World world = two_rooms(0.9);
  World turned = world;
  const Pose2 turn{3, -7, radians(90)};
  for (Wall& wall : turned.walls) {
    for (Point2& p : wall.points) p = turn * p;
  }
  // Walls lie between lattice lines, so that rounding in the turn decides nothing.
  const Pose2 start{1.013, 1.007, 0.0};
  const GroundTruth a = ground_truth(world, start, kRadius, 0.05);
  const GroundTruth b = ground_truth(turned, turn * start, kRadius, 0.05);
  ASSERT_EQ(a.geometry, b.geometry);
  EXPECT_EQ(a.reachable_count, b.reachable_count);
  for (std::size_t i = 0; i < a.cells.size(); ++i) {
    ASSERT_EQ(a.cells[i].reachable, b.cells[i].reachable) << i;
    ASSERT_EQ(a.cells[i].boundary, b.cells[i].boundary) << i;
  }
}

std::string error_of(const World& world, const Pose2& start, double radius, double resolution) {
  try {
    ground_truth(world, start, radius, resolution);
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(GroundTruthTest, SaysWhyAStartWontDo) {
  World world = room(4, 4);
  world.furniture.push_back({"sofa", {box({2, 2}, {2, 1}, 0)}});
  EXPECT_EQ(error_of(world, {0.1, 1, 0}, kRadius, 0.05),
            "start (0.100, 1.000) is closer than 0.1725 m to a wall or cliff; want a place where the robot fits");
  EXPECT_EQ(error_of(world, {2, 2, 0}, kRadius, 0.05),
            "start (2.000, 2.000) is inside of the sofa; want a place on the floor");
  EXPECT_EQ(error_of(world, {0.16, 1, 0}, kRadius, 0.05), "no error") << "a free node is less than half a cell away";
}

TEST(GroundTruthTest, RefusesAStartOverACliffHoweverFarItsEdges) {
  World world = room(9, 9);
  world.cliffs.push_back(box({4, 4}, {4, 4}, 0));
  EXPECT_THAT(error_of(world, {4, 4, 0}, kRadius, 0.05), testing::HasSubstr("to a wall or cliff"));
}

TEST(GroundTruthTest, RefusesSizesThatMakeNoSense) {
  EXPECT_THAT(error_of(room(4, 4), {2, 2, 0}, 0.0, 0.05), testing::HasSubstr("radius"));
  EXPECT_THAT(error_of(room(4, 4), {2, 2, 0}, kRadius, 0.0), testing::HasSubstr("resolution"));
  EXPECT_THAT(error_of(room(4, 4), {2, 2, 0}, kRadius, 0.5), testing::HasSubstr("resolution"));
  EXPECT_THAT(error_of(room(2000, 2000), {2, 2, 0}, kRadius, 0.05), testing::HasSubstr("want a larger resolution"));
}

}  // namespace
}  // namespace scrubjay
