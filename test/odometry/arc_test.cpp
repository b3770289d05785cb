#include <gtest/gtest.h>

#include <cmath>
#include <scrubjay/geometry/random.hpp>
#include <scrubjay/odometry/arc.hpp>

#include "odometry/drive.hpp"

namespace scrubjay {
namespace {

WheelTravel wheels(double length, double turn) {
  const double half = 0.5 * kDrive.wheel_separation * turn;
  return {length - half, length + half};
}

TEST(ArcMotionTest, DrivesStraight) {
  EXPECT_EQ(arc_motion({0.3, 0.3}, kDrive), (Pose2{0.3, 0.0, 0.0}));
  EXPECT_EQ(arc_motion({-0.3, -0.3}, kDrive), (Pose2{-0.3, 0.0, 0.0}));
  EXPECT_EQ(arc_motion({0.0, 0.0}, kDrive), Pose2{});
}

TEST(ArcMotionTest, SpinsInPlace) {
  const Pose2 pose = arc_motion(wheels(0.0, radians(90.0)), kDrive);
  EXPECT_NEAR(pose.position().norm(), 0.0, 1e-16);
  EXPECT_NEAR(pose.yaw, radians(90.0), 1e-15);
}

TEST(ArcMotionTest, FollowsTheCircleForAnyRadiusAndTurn) {
  Random random(1);
  for (int i = 0; i < 10000; ++i) {
    const long double radius = random.uniform(-3.0, 3.0);
    const long double turn = random.uniform(-6.0, 6.0);
    const Pose2 pose = arc_motion(wheels(static_cast<double>(radius * turn), static_cast<double>(turn)), kDrive);
    EXPECT_NEAR(pose.x, static_cast<double>(radius * std::sin(turn)), 1e-13);
    EXPECT_NEAR(pose.y, static_cast<double>(radius * (1 - std::cos(turn))), 1e-13);
    EXPECT_NEAR(std::remainder(pose.yaw - static_cast<double>(turn), 2.0 * kPi), 0.0, 1e-13);
  }
}

TEST(ArcMotionTest, AgreesWithManySmallStraightSteps) {
  const WheelTravel travel{0.2, 0.5};
  constexpr int kSteps = 100000;
  Pose2 euler;
  for (int i = 0; i < kSteps; ++i) {
    const double ds = 0.35 / kSteps;
    const double turn = 0.3 / kDrive.wheel_separation / kSteps;
    euler.x += ds * std::cos(euler.yaw + 0.5 * turn);
    euler.y += ds * std::sin(euler.yaw + 0.5 * turn);
    euler.yaw += turn;
  }
  const Pose2 pose = arc_motion(travel, kDrive);
  EXPECT_NEAR(pose.x, euler.x, 1e-10);
  EXPECT_NEAR(pose.y, euler.y, 1e-10);
  EXPECT_NEAR(pose.yaw, euler.yaw, 1e-10);
}

TEST(ArcMotionTest, IsContinuousThroughStraightMotion) {
  const Pose2 straight = arc_motion(wheels(1.0, 0.0), kDrive);
  for (double turn = 1e-3; turn > 1e-300; turn *= 0.1) {
    for (const double sign : {-1.0, 1.0}) {
      const Pose2 pose = arc_motion(wheels(1.0, sign * turn), kDrive);
      EXPECT_NEAR(pose.x, straight.x, turn * turn + 1e-15);
      EXPECT_NEAR(pose.y, sign * 0.5 * turn, turn * turn + 1e-15);
      EXPECT_NEAR(pose.yaw, sign * turn, 1e-15);
    }
  }
}

TEST(ArcMotionTest, ArcsOnEitherSideOfAShareAddUp) {
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const WheelTravel travel{random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5)};
    const double share = random.uniform();
    const Pose2 first = arc_motion({share * travel.left, share * travel.right}, kDrive);
    const Pose2 second = arc_motion({(1.0 - share) * travel.left, (1.0 - share) * travel.right}, kDrive);
    const Pose2 both = first * second;
    const Pose2 whole = arc_motion(travel, kDrive);
    EXPECT_NEAR((both.position() - whole.position()).norm(), 0.0, 1e-14);
    EXPECT_NEAR(angle_difference(both.yaw, whole.yaw), 0.0, 1e-14);
  }
}

TEST(ChordTest, HasNoStepWhereTheSeriesEnds) {
  // The series serves up to a turn of 0.2 rad.
  for (const double turn : {0.2, -0.2, 0.19999, 0.20001, 0.1, 0.3}) {
    const long double half = 0.5L * turn;
    EXPECT_NEAR(chord({1.0, turn}), static_cast<double>(std::sin(half) / half), 3e-16);
  }
}

TEST(DifferentialDriveTest, ARollOfOneTurnIsTheWheelsCircumference) {
  EXPECT_NEAR(kDrive.metres_per_count() * 508.8, 2.0 * kPi * 0.036, 1e-15);
}

}  // namespace
}  // namespace scrubjay
