#include <gtest/gtest.h>

#include "situations.hpp"

namespace scrubjay::test {
namespace {

const ObstacleSense kSense{RobotModel{}};

bool operator==(const Obstacles& a, const Obstacles& b) {
  return a.left == b.left && a.ahead == b.ahead && a.right == b.right;
}

TEST(ObstaclesTest, NothingNearIsNoObstacle) {
  EXPECT_FALSE(kSense(quiet_frame()).any());
}

TEST(ObstaclesTest, LightCountsWithinFiveCentimetresOnly) {
  EXPECT_TRUE(kSense(lit_frame(LightSensor::CenterLeft, 0.045)).ahead);
  EXPECT_FALSE(kSense(lit_frame(LightSensor::CenterLeft, 0.055)).any());
}

TEST(ObstaclesTest, SideSensorsBlockTheirSideButNotTheWay) {
  EXPECT_TRUE(kSense(lit_frame(LightSensor::Left, 0.02)) == (Obstacles{true, false, false}));
  EXPECT_TRUE(kSense(lit_frame(LightSensor::Right, 0.02)) == (Obstacles{false, false, true}));
}

TEST(ObstaclesTest, FrontSensorsBlockTheWayAndTheirSide) {
  EXPECT_TRUE(kSense(lit_frame(LightSensor::FrontLeft, 0.02)) == (Obstacles{true, true, false}));
  EXPECT_TRUE(kSense(lit_frame(LightSensor::CenterLeft, 0.02)) == (Obstacles{false, true, false}));
  EXPECT_TRUE(kSense(lit_frame(LightSensor::CenterRight, 0.02)) == (Obstacles{false, true, false}));
  EXPECT_TRUE(kSense(lit_frame(LightSensor::FrontRight, 0.02)) == (Obstacles{false, true, true}));
}

TEST(ObstaclesTest, BumpsCliffsAndVirtualWallsBlockTheWay) {
  Frame bump = quiet_frame();
  bump.bump_right = true;
  EXPECT_TRUE(kSense(bump) == (Obstacles{false, true, true}));
  EXPECT_TRUE(kSense(cliff_frame(CliffSensor::Left)) == (Obstacles{true, true, false}));
  EXPECT_TRUE(kSense(cliff_frame(CliffSensor::FrontRight)) == (Obstacles{false, true, false}));
  Frame fence = quiet_frame();
  fence.virtual_wall = true;
  EXPECT_TRUE(kSense(fence) == (Obstacles{false, true, false}));
}

TEST(ObstaclesTest, ARobotWithoutLightSensorsGoesByTouchAlone) {
  RobotModel blind;
  blind.has_light_sensors = false;
  const ObstacleSense sense(blind);
  EXPECT_FALSE(sense(quiet_frame()).any());
  Frame bump = quiet_frame();
  bump.bump_left = true;
  EXPECT_TRUE(sense(bump).ahead);
}

}  // namespace
}  // namespace scrubjay::test
