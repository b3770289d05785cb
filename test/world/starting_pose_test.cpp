#include <gtest/gtest.h>

#include <scrubjay/error.hpp>
#include <scrubjay/world/score.hpp>

#include "world/disc.hpp"

namespace scrubjay {
namespace {

World rooms(const std::vector<Polygon>& outlines) {
  World world;
  for (Polygon outline : outlines) {
    outline.push_back(outline.front());
    world.walls.push_back({outline});
  }
  return world;
}

TEST(StartingPoseTest, IsTheMiddleOfASmallRoom) {
  const Pose2 pose = starting_pose(rooms({box({7, -3}, {1.8, 1.8}, 0)}), kRadius);
  EXPECT_NEAR(pose.x, 7, 0.05);
  EXPECT_NEAR(pose.y, -3, 0.05);
  EXPECT_EQ(pose.yaw, 0.0);
}

TEST(StartingPoseTest, IsInACornerOfALargeOne) {
  // A robot that sees a few metres would see nothing from the middle.
  const Pose2 pose = starting_pose(rooms({box({10, 10}, {20, 20}, 0)}), kRadius);
  EXPECT_NEAR(pose.x, 1.0, 0.1);
  EXPECT_NEAR(pose.y, 1.0, 0.1);
}

TEST(StartingPoseTest, PrefersTheLargestPartToTheWidestPlace) {
  // A long corridor has more floor than a square room with a wider middle.
  const Pose2 pose = starting_pose(rooms({box({0, 0}, {2, 2}, 0), box({10, 0}, {12, 1}, 0)}), kRadius);
  EXPECT_GT(pose.x, 4.0);
}

TEST(StartingPoseTest, KeepsAwayFromFurniture) {
  World world = rooms({box({0, 0}, {6, 1.9}, 0)});
  world.furniture.push_back({"table", {box({-1, 0}, {1, 1}, 0)}});
  const Pose2 pose = starting_pose(world, kRadius);
  EXPECT_GT(pose.x, 0.4);
  EXPECT_NEAR(pose.y, 0.0, 0.1);
}

TEST(StartingPoseTest, NeverLiesInsideOfFurnitureACliffOrOutside) {
  // The furniture's inside and the yard around are both larger than the room.
  World world = rooms({box({0, 0}, {4, 1}, 0)});
  world.furniture.push_back({"stage", {box({10, 0}, {9, 9}, 0)}});
  world.cliffs.push_back(box({-10, 0}, {9, 9}, 0));
  const Pose2 pose = starting_pose(world, kRadius);
  EXPECT_LT(std::abs(pose.x), 2.0);
  EXPECT_LT(std::abs(pose.y), 0.5);
}

TEST(StartingPoseTest, DoesNotLookThroughGapsThatAreTooNarrow) {
  // A room open to the outside by 30 cm is closed to the robot; by 50 cm it isn't.
  World world;
  world.walls.push_back({{{0.3, 0}, {3, 0}, {3, 3}, {0, 3}, {0, 0}}});
  EXPECT_NEAR(starting_pose(world, kRadius).x, 1.0, 0.1);
  world.walls[0].points[0].x() = 0.5;
  EXPECT_THROW(starting_pose(world, kRadius), Error);
}

TEST(StartingPoseTest, SaysSoWhereTheRobotFitsNowhere) {
  EXPECT_THROW(starting_pose({}, kRadius), Error);
  EXPECT_THROW(starting_pose(rooms({box({0, 0}, {4, 0.3}, 0)}), kRadius), Error);
}

}  // namespace
}  // namespace scrubjay
