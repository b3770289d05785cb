#include <gtest/gtest.h>

#include <scrubjay/ros2/placed_localizer.hpp>

#include "ros2/told.hpp"

namespace scrubjay::ros {
namespace {

/// Is where it is put, as surely as it is said.
class FixedLocalizer final : public Localizer {
 public:
  explicit FixedLocalizer(PoseEstimate& estimate) : estimate_(estimate) {}
  const PoseEstimate& update(const Frame&) override { return estimate_; }

 private:
  PoseEstimate& estimate_;
};

class PlacedLocalizerTest : public ::testing::Test {
 protected:
  PlacedLocalizerTest() {
    reckoned.covariance << 0.04, 0.01, 0.002, 0.01, 0.09, -0.003, 0.002, -0.003, 0.0025;
    reckoned.twist = {0.2, 0.0, 0.1};
    reckoned.twist_covariance = 0.5 * Eigen::Matrix3d::Identity();
  }
  const PoseEstimate& update() { return placed.update(Frame{}); }
  void place(const Pose2& pose) { commands.take_initial_pose(told_place(pose)); }
  static void expect_at(const Pose2& expected, const Pose2& pose) {
    EXPECT_NEAR(pose.x, expected.x, 1e-9);
    EXPECT_NEAR(pose.y, expected.y, 1e-9);
    EXPECT_NEAR(angle_difference(pose.yaw, expected.yaw), 0.0, 1e-9);
  }

  PoseEstimate reckoned;
  Commands commands{{}};
  PlacedLocalizer placed{std::make_unique<FixedLocalizer>(reckoned), commands};
};

TEST_F(PlacedLocalizerTest, IsTheReckoningUntilItIsTold) {
  reckoned.pose = {1.0, 2.0, 0.5};
  const PoseEstimate& estimate = update();
  expect_at(reckoned.pose, estimate.pose);
  EXPECT_TRUE(estimate.covariance.isApprox(reckoned.covariance, 1e-12));
}

TEST_F(PlacedLocalizerTest, IsWhereItWasToldAndGoesOnFromThere) {
  reckoned.pose = {1.0, 2.0, 0.5};
  update();
  const Pose2 told{-3.0, 4.0, -2.0};
  place(told);
  expect_at(told, update().pose);
  expect_at(told, update().pose);
  const Pose2 step{0.3, -0.1, 0.7};
  reckoned.pose = reckoned.pose * step;
  expect_at(told * step, update().pose);
  place({0.0, 0.0, 0.0});
  reckoned.pose = reckoned.pose * step;
  expect_at({}, update().pose);
}

TEST_F(PlacedLocalizerTest, TurnsTheCovarianceWithThePlace) {
  reckoned.pose = {1.0, 2.0, 0.0};
  place({0.0, 0.0, kPi / 2.0});
  const Eigen::Matrix3d turned = update().covariance;
  // What was along x is along y now, and what was along y is along -x; the heading is as sure as before.
  EXPECT_NEAR(turned(0, 0), 0.09, 1e-9);
  EXPECT_NEAR(turned(1, 1), 0.04, 1e-9);
  EXPECT_NEAR(turned(0, 1), -0.01, 1e-9);
  EXPECT_NEAR(turned(0, 2), 0.003, 1e-9);
  EXPECT_NEAR(turned(1, 2), 0.002, 1e-9);
  EXPECT_NEAR(turned(2, 2), 0.0025, 1e-9);
  EXPECT_TRUE(turned.isApprox(turned.transpose(), 1e-12));
}

TEST_F(PlacedLocalizerTest, LeavesTheTwistAsItIs) {
  place({5.0, 5.0, 1.0});
  const PoseEstimate& estimate = update();
  EXPECT_EQ(estimate.twist, reckoned.twist);
  EXPECT_EQ(estimate.twist_covariance, reckoned.twist_covariance);
}

TEST_F(PlacedLocalizerTest, GarbageMovesNothing) {
  reckoned.pose = {1.0, 2.0, 0.5};
  place({std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0});
  place({1e9, 0.0, 0.0});
  commands.take_initial_pose(Commands::Bytes());
  expect_at(reckoned.pose, update().pose);
}

TEST(PlacedLocalizerOnWheelsTest, DrivesOnFromItsPlace) {
  Commands commands({});
  PlacedLocalizer placed(std::make_unique<DeadReckoning>(DifferentialDrive{}), commands);
  Frame frame;
  const auto roll = [&](double way) {
    frame.stamp += 0.015;
    frame.left_travel = frame.right_travel = way;
    return placed.update(frame).pose;
  };
  roll(0.0);
  roll(0.5);
  commands.take_initial_pose(told_place({2.0, 3.0, kPi / 2.0}));
  roll(0.0);
  const Pose2 pose = roll(0.25);
  EXPECT_NEAR(pose.x, 2.0, 1e-9);
  EXPECT_NEAR(pose.y, 3.25, 1e-9);
}

}  // namespace
}  // namespace scrubjay::ros
