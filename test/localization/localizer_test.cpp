#include <gtest/gtest.h>

#include <scrubjay/localization/localizer.hpp>

namespace scrubjay {
namespace {

Frame rolled(double left, double right, double stamp) {
  Frame frame;
  frame.left_travel = left;
  frame.right_travel = right;
  frame.stamp = stamp;
  return frame;
}

TEST(DeadReckoningTest, BeginsAtTheOriginOfItsMap) {
  DeadReckoning localizer({});
  const PoseEstimate& estimate = localizer.update(rolled(0.0, 0.0, 12.0));
  EXPECT_EQ(estimate.pose, Pose2{});
  EXPECT_EQ(estimate.covariance.norm(), 0.0);
}

TEST(DeadReckoningTest, FollowsTheWheelsOfItsFramesAsOdometryDoes) {
  const DifferentialDrive drive{.wheel_separation = 0.3};
  const WheelNoise noise{1e-6, 3e-6};
  DeadReckoning localizer(drive, noise);
  Odometry odometry(drive, noise);
  PoseEstimate estimate;
  for (int i = 0; i < 100; ++i) {
    const double right = i < 50 ? 0.004 : -0.002;
    estimate = localizer.update(rolled(0.003, right, i * 0.015));
    odometry.update({0.003, right}, i * 0.015);
  }
  EXPECT_EQ(estimate.pose, odometry.estimate().pose);
  EXPECT_EQ(estimate.covariance, odometry.estimate().covariance);
  EXPECT_EQ(estimate.twist, odometry.estimate().twist);
  EXPECT_GT(estimate.pose.x, 0.1);
  EXPECT_GT(estimate.twist.linear, 0.0);
}

TEST(DeadReckoningTest, TurnsLeftWhenTheRightWheelRollsFarther) {
  DeadReckoning localizer({});
  localizer.update(rolled(0.0, 0.0, 0.0));
  const Pose2 pose = localizer.update(rolled(0.1, 0.12, 0.015)).pose;
  EXPECT_GT(pose.yaw, 0.0);
  EXPECT_GT(pose.y, 0.0);
  EXPECT_NEAR(pose.yaw, 0.02 / 0.235, 1e-12);
}

Frame told(const Pose2& odometry, double stamp) {
  Frame frame;
  frame.odometry = odometry;
  frame.stamp = stamp;
  return frame;
}

TEST(DeadReckoningTest, FollowsTheOwnOdometryOfARobotExactlyFromItsFirstPoseOn) {
  const Pose2 start{7.0, -3.0, 2.0};
  DeadReckoning localizer({});
  EXPECT_EQ(localizer.update(told(start, 1.0)).pose, Pose2{}) << "wherever its frame of odometry begins";
  Pose2 odometry = start;
  for (int i = 1; i < 200; ++i) {
    odometry = odometry * Pose2{0.03, 0.01, i % 20 < 10 ? 0.2 : -0.15};  // it may also slip to the side
    const Pose2 pose = localizer.update(told(odometry, 1.0 + i)).pose;
    const Pose2 expected = inverse(start) * odometry;
    ASSERT_NEAR(pose.x, expected.x, 1e-12);
    ASSERT_NEAR(pose.y, expected.y, 1e-12);
    ASSERT_NEAR(angle_difference(pose.yaw, expected.yaw), 0.0, 1e-12);
  }
}

TEST(DeadReckoningTest, IsAsSureOfOwnOdometryAsOfWheelsThatRolledTheSameArc) {
  const DifferentialDrive drive{.wheel_separation = 0.4};
  DeadReckoning by_wheels(drive);
  DeadReckoning by_odometry(drive);
  by_odometry.update(told({}, 0.0));
  by_wheels.update(rolled(0.0, 0.0, 0.0));
  Pose2 odometry;
  PoseEstimate a, b;
  for (int i = 1; i <= 100; ++i) {
    odometry = odometry * arc_motion({0.010, 0.012}, drive);
    a = by_odometry.update(told(odometry, 0.1 * i));
    b = by_wheels.update(rolled(0.010, 0.012, 0.1 * i));
  }
  EXPECT_NEAR((a.covariance - b.covariance).norm() / b.covariance.norm(), 0.0, 1e-5);
  EXPECT_GT(b.covariance.norm(), 0.0);
  EXPECT_NEAR(a.twist.linear, b.twist.linear, 1e-5);
  EXPECT_NEAR(a.twist.angular, b.twist.angular, 1e-9);
}

TEST(DeadReckoningTest, LosesNothingOfItsCertaintyWhileItsOdometryStandsStill) {
  DeadReckoning localizer({});
  for (int i = 0; i < 50; ++i) localizer.update(told({1.0, 2.0, 3.0}, i));
  EXPECT_EQ(localizer.update(told({1.0, 2.0, 3.0}, 60.0)).covariance.norm(), 0.0);
}

}  // namespace
}  // namespace scrubjay
