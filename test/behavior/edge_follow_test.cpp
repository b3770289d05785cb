#include <gtest/gtest.h>

#include <scrubjay/behavior/edge_follow.hpp>

#include "situations.hpp"

namespace scrubjay::test {
namespace {

EdgeFollow strategy(const EdgeFollowParams& params = {}) {
  return EdgeFollow({}, Random(1), params);
}

TEST(EdgeFollowTest, DrivesStraightUntilItMeetsAnEdge) {
  EdgeFollow behavior = strategy();
  const Decision decision = decide(behavior, quiet_frame());
  EXPECT_EQ(decision.motion, (Motion{0.1, 0.0}));
  EXPECT_STREQ(decision.doing, "seeking an edge");
}

TEST(EdgeFollowTest, TurnsAwayFromTheNearerSide) {
  EdgeFollow left = strategy();
  EXPECT_LT(decide(left, lit_frame(LightSensor::FrontLeft, 0.03)).motion.angular, 0.0);
  EdgeFollow right = strategy();
  EXPECT_GT(decide(right, lit_frame(LightSensor::FrontRight, 0.03)).motion.angular, 0.0);
}

TEST(EdgeFollowTest, HeadOnThePreferredSideDecides) {
  Frame head_on = quiet_frame();
  head_on.bump_left = head_on.bump_right = true;
  EdgeFollowParams params;
  EdgeFollow left = strategy(params);
  EXPECT_LT(decide(left, head_on).motion.angular, 0.0);
  params.preferred_side = Side::Right;
  EdgeFollow right = strategy(params);
  EXPECT_GT(decide(right, head_on).motion.angular, 0.0);
}

/// One that has met an edge on its left and stands along it.
class FollowingTest : public ::testing::Test {
 protected:
  FollowingTest() {
    decide(behavior_, lit_frame(LightSensor::FrontLeft, 0.03));
    decide(behavior_, lit_frame(LightSensor::Left, 0.065));
  }
  double turn_at(double side_range) {
    return decide(behavior_, lit_frame(LightSensor::Left, side_range)).motion.angular;
  }

  EdgeFollow behavior_ = strategy();
};

TEST_F(FollowingTest, KeepsTheGap) {
  EXPECT_NEAR(turn_at(0.065), 0.0, 0.05);
  EXPECT_GT(turn_at(0.08), 0.1) << "too far: towards the edge";
  EXPECT_LT(turn_at(0.05), -0.1) << "too near: away from it";
  EXPECT_STREQ(decide(behavior_, lit_frame(LightSensor::Left, 0.065)).doing, "following the edge");
}

TEST_F(FollowingTest, SomethingAheadIsAnInsideCorner) {
  const Decision decision = decide(behavior_, lit_frame(LightSensor::CenterRight, 0.05));
  EXPECT_EQ(decision.motion, (Motion{0.0, -0.5}));
}

TEST_F(FollowingTest, ALostEdgeIsAnOuterCorner) {
  decide(behavior_, lit_frame(LightSensor::Left, 0.065));
  EXPECT_STREQ(decide(behavior_, quiet_frame()).doing, "rounding a corner");
  EXPECT_STREQ(decide(behavior_, lit_frame(LightSensor::Left, 0.1)).doing, "following the edge");
}

TEST_F(FollowingTest, BacksOffFromACliffThenTurnsFromIt) {
  Frame cliff = cliff_frame(CliffSensor::FrontLeft);
  EXPECT_LT(decide(behavior_, cliff).motion.linear, 0.0);
  EXPECT_LT(decide(behavior_, cliff, {-0.06, 0.0, 0.0}).motion.linear, 0.0) << "still over it";
  EXPECT_EQ(decide(behavior_, quiet_frame(), {-0.08, 0.0, 0.0}).motion, (Motion{0.0, -0.5}));
}

TEST_F(FollowingTest, BlockedFromBehindItStopsBackingOff) {
  Frame fence = quiet_frame();
  fence.virtual_wall = true;
  EXPECT_LT(decide(behavior_, fence).motion.linear, 0.0);
  fence.stamp = 10.0;  // and not a millimetre on
  EXPECT_EQ(decide(behavior_, fence).motion.linear, 0.0);
}

TEST(EdgeFollowTest, EndsAfterSoManyDrivesInVain) {
  EdgeFollowParams params;
  params.patience = 3;
  EdgeFollow behavior = strategy(params);
  // Without way, each drive meets the edge at once.
  Frame fence = quiet_frame();
  fence.virtual_wall = true;
  int backed_off = 0;
  Pose2 pose;
  Decision decision;
  for (int i = 0; i < 5000 && !decision.done; ++i) {
    fence.stamp = 0.015 * i;
    const bool was_backing = decision.motion.linear < 0.0;
    decision = decide(behavior, fence, pose);
    backed_off += decision.motion.linear < 0.0 && !was_backing;
    pose.yaw = wrap_angle(pose.yaw + 0.015 * decision.motion.angular);
  }
  EXPECT_TRUE(decision.done);
  EXPECT_EQ(backed_off, 2) << "the third ends it";
}

TEST(EdgeFollowTest, OfOneEdgeItEndsWhereItWouldLeaveIt) {
  EdgeFollowParams params;
  params.one_edge = true;
  EdgeFollow behavior = strategy(params);
  decide(behavior, lit_frame(LightSensor::FrontLeft, 0.03));
  decide(behavior, lit_frame(LightSensor::Left, 0.065));
  EXPECT_FALSE(decide(behavior, lit_frame(LightSensor::Left, 0.065)).done);
  // Once around a square room, to the right.
  Pose2 pose;
  bool done = false;
  for (int i = 0; i < 2000 && !done; ++i) {
    if (i % 200 == 199) pose.yaw = wrap_angle(pose.yaw - kPi / 2.0);
    pose = pose * Pose2{0.005, 0.0, 0.0};
    done = decide(behavior, lit_frame(LightSensor::Left, 0.065), pose).done;
  }
  EXPECT_TRUE(done);
  EXPECT_EQ(behavior.loops_closed(), 1);
  EXPECT_LT(pose.position().norm(), 0.2);
}

}  // namespace
}  // namespace scrubjay::test
