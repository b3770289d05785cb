#include <gmock/gmock.h>

#include <scrubjay/error.hpp>
#include <scrubjay/world/start.hpp>

#include "world/disc.hpp"

namespace scrubjay {
namespace {

/// Two rooms without a door between them, and a hole in the floor of the first one.
World two_rooms() {
  World world;
  world.walls.push_back({{{0, 0}, {8, 0}, {8, 3}, {0, 3}, {0, 0}}});
  world.walls.push_back({{{4, 0}, {4, 3}}});
  world.cliffs.push_back({{1, 2}, {1.8, 2}, {1.8, 2.8}, {1, 2.8}});
  return world;
}

TEST(StartingPosesTest, AreApartAndFreeAndWithinReachOfTheFirst) {
  const World world = two_rooms();
  const SegmentIndex index(solid_segments(world));
  const Pose2 first{2.0, 1.5, 0.7};
  const std::vector<Pose2> places = starting_poses(world, index, first, kRadius, 12);
  ASSERT_EQ(places.size(), 12u);
  EXPECT_EQ(places.front(), first);
  for (std::size_t i = 0; i < places.size(); ++i) {
    EXPECT_NO_THROW(expect_room(world, index, places[i], kRadius));
    EXPECT_LT(places[i].x, 4.0) << "there is a wall between";
    EXPECT_EQ(places[i].yaw, first.yaw);
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_GE((places[i].position() - places[j].position()).norm(), 3.0 * kRadius - 1e-9);
    }
    EXPECT_FALSE(contains(disc({1.4, 2.4}, 0.4 + kRadius), places[i].position())) << "over the hole";
  }
}

TEST(StartingPosesTest, RefusesMoreRobotsThanThereIsRoomFor) {
  const World world = two_rooms();
  const SegmentIndex index(solid_segments(world));
  EXPECT_EQ(starting_poses(world, index, {2, 1, 0}, kRadius, 1).size(), 1u);
  EXPECT_THROW(starting_poses(world, index, {2, 1, 0}, kRadius, 100), Error);
}

TEST(StartingPosesTest, FindsRoomWithoutWalls) {
  const World world;
  const SegmentIndex index(solid_segments(world));
  EXPECT_EQ(starting_poses(world, index, {0, 0, 0}, kRadius, 50).size(), 50u);
}

}  // namespace
}  // namespace scrubjay
