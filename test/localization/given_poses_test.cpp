#include <gtest/gtest.h>

#include <scrubjay/localization/given_poses.hpp>

namespace scrubjay {
namespace {

Frame at(double stamp) {
  Frame frame;
  frame.stamp = stamp;
  frame.left_travel = frame.right_travel = 1.0;  // which it doesn't believe
  return frame;
}

TEST(GivenPosesTest, TakesEachFramesPoseByItsStamp) {
  GivenPoses localizer({{1.0, {1, 2, 0.5}}, {2.0, {3, 2, 1.0}}, {4.0, {3, 4, -3.0}}});
  EXPECT_EQ(localizer.update(at(1.0)).pose, (Pose2{1, 2, 0.5}));
  EXPECT_EQ(localizer.update(at(2.0)).pose, (Pose2{3, 2, 1.0}));
  const PoseEstimate& last = localizer.update(at(4.0));
  EXPECT_EQ(last.pose, (Pose2{3, 4, -3.0}));
  EXPECT_EQ(last.covariance.norm(), 0.0);
}

TEST(GivenPosesTest, MovesEvenlyBetweenTwoStampsAndTurnsTheShortWay) {
  GivenPoses localizer({{0.0, {0, 0, 3.0}}, {2.0, {4, 2, -3.0}}});
  const Pose2 pose = localizer.update(at(0.5)).pose;
  EXPECT_DOUBLE_EQ(pose.x, 1.0);
  EXPECT_DOUBLE_EQ(pose.y, 0.5);
  EXPECT_NEAR(pose.yaw, 3.0 + (2.0 * kPi - 6.0) / 4.0, 1e-12);
}

TEST(GivenPosesTest, StandsStillBeforeTheFirstAndAfterTheLast) {
  GivenPoses localizer({{1.0, {1, 0, 0}}, {2.0, {2, 0, 0}}});
  EXPECT_EQ(localizer.update(at(0.0)).pose, (Pose2{1, 0, 0}));
  EXPECT_EQ(localizer.update(at(9.0)).pose, (Pose2{2, 0, 0}));
}

TEST(GivenPosesTest, TakesPosesOfOneStampOneAfterAnother) {
  GivenPoses localizer({{1.0, {1, 0, 0}}, {2.0, {2, 0, 0}}, {2.0, {5, 0, 0}}, {3.0, {6, 0, 0}}});
  EXPECT_EQ(localizer.update(at(1.0)).pose.x, 1.0);
  EXPECT_EQ(localizer.update(at(2.0)).pose.x, 2.0);
  EXPECT_EQ(localizer.update(at(2.0)).pose.x, 5.0);
  EXPECT_EQ(localizer.update(at(3.0)).pose.x, 6.0);
}

TEST(GivenPosesTest, TellsHowFastTheRobotMoves) {
  GivenPoses localizer({{0.0, {0, 0, kPi / 2}}, {2.0, {0, 1, kPi / 2 + 0.4}}, {3.0, {9, 1, 0}}});
  EXPECT_EQ(localizer.update(at(0.0)).twist, Twist2{});
  for (const double stamp : {1.0, 2.0}) {
    const Twist2 twist = localizer.update(at(stamp)).twist;
    EXPECT_NEAR(twist.linear, 0.5, 1e-12) << stamp;
    EXPECT_NEAR(twist.lateral, 0.0, 1e-12);
    EXPECT_NEAR(twist.angular, 0.2, 1e-12);
  }
}

}  // namespace
}  // namespace scrubjay
