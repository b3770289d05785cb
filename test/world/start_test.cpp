#include <gmock/gmock.h>

#include <scrubjay/error.hpp>
#include <scrubjay/world/start.hpp>

#include "world/disc.hpp"

namespace scrubjay {
namespace {

using ::testing::HasSubstr;

World room_with_hole() {
  World world;
  world.walls.push_back({{{0, 0}, {4, 0}, {4, 3}, {0, 3}, {0, 0}}});
  world.furniture.push_back({"sofa", {box({3, 2}, {1.0, 0.8}, 0.0)}});
  world.cliffs.push_back({{1, 2}, {1.8, 2}, {1.8, 2.8}, {1, 2.8}});
  return world;
}

std::string refusal(const Pose2& start) {
  const World world = room_with_hole();
  const SegmentIndex index(solid_segments(world));
  try {
    expect_room(world, index, start, kRadius);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(StartTest, AcceptsAPlaceWhereTheDiscFits) {
  EXPECT_EQ(refusal({1, 1, 0}), "");
  EXPECT_EQ(refusal({kRadius, 1, 0}), "") << "touching is no overlap";
}

TEST(StartTest, RefusesAPlaceTooNearToAWall) {
  EXPECT_THAT(refusal({0.1, 1, 0}), HasSubstr("is 0.100 m from a wall"));
  EXPECT_THAT(refusal({0.1, 1, 0}), HasSubstr("0.1735"));
}

TEST(StartTest, RefusesTheInsideOfFurnitureThoughNoWallIsNear) {
  EXPECT_THAT(refusal({3, 2, 0}), HasSubstr("within the sofa"));
}

TEST(StartTest, RefusesAPlaceOverACliff) {
  EXPECT_THAT(refusal({1.4, 2.4, 0}), HasSubstr("over a cliff"));
}

}  // namespace
}  // namespace scrubjay
