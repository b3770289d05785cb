#include <gtest/gtest.h>

#include <scrubjay/world/world.hpp>

namespace scrubjay {
namespace {

TEST(WorldTest, CountsPiecesThroughWallsFurnitureAndClosedDoors) {
  World world;
  world.walls = {{{{0, 0}, {1, 0}, {1, 1}}}, {{{5, 5}, {6, 6}}}};
  world.furniture = {{"table", {box({3, 3}, {0.1, 0.1}, 0), box({4, 4}, {0.1, 0.1}, 0)}}};
  world.doors = {{{{7, 0}, {8, 0}}, true}, {{{9, 0}, {10, 0}}, false}};
  const std::vector<SolidSegment> solid = solid_segments(world);
  std::vector<std::uint32_t> pieces;
  for (const SolidSegment& s : solid) pieces.push_back(s.piece);
  EXPECT_EQ(pieces, (std::vector<std::uint32_t>{0, 0, 1, 2, 2, 2, 2, 2, 2, 2, 2, 3}));
  EXPECT_EQ(solid.back().segment.a, Point2(9, 0)) << "open doors don't block";
}

TEST(WorldTest, ClosesPolygonsButNotWalls) {
  World world;
  world.walls = {{{{0, 0}, {1, 0}, {1, 1}}}};
  EXPECT_EQ(solid_segments(world).size(), 2u);
  world.walls.clear();
  world.furniture = {{"", {{{0, 0}, {1, 0}, {1, 1}}}}};
  const std::vector<SolidSegment> solid = solid_segments(world);
  ASSERT_EQ(solid.size(), 3u);
  EXPECT_EQ(solid[2].segment.a, Point2(1, 1));
  EXPECT_EQ(solid[2].segment.b, Point2(0, 0));
}

TEST(WorldTest, TurnsBoxesAroundTheirCentre) {
  const Polygon turned = box({2, 1}, {4, 2}, radians(90));
  EXPECT_NEAR((turned[0] - Point2(3, -1)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((turned[2] - Point2(1, 3)).norm(), 0.0, 1e-12);
}

TEST(WorldTest, DiscsHaveTheirCornersOnTheCircle) {
  const Polygon corners = disc({1, 2}, 0.3, 12);
  ASSERT_EQ(corners.size(), 12u);
  for (const Point2& corner : corners) EXPECT_NEAR((corner - Point2(1, 2)).norm(), 0.3, 1e-12);
}

TEST(WorldTest, KnowsTheInsideOfAPolygonWithADent) {
  const Polygon dented{{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}};
  EXPECT_TRUE(contains(dented, {0.5, 2}));
  EXPECT_TRUE(contains(dented, {2, 0.5}));
  EXPECT_FALSE(contains(dented, {2, 2}));
  EXPECT_FALSE(contains(dented, {-1, 1})) << "left of it, level with a corner";
  EXPECT_FALSE(contains(dented, {5, 4}));
  EXPECT_FALSE(contains({}, {0, 0}));
}

}  // namespace
}  // namespace scrubjay
