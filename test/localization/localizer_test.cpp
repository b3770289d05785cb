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

}  // namespace
}  // namespace scrubjay
