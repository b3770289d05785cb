#include <gtest/gtest.h>

#include <scrubjay/geometry/pose2.hpp>
#include <scrubjay/geometry/random.hpp>

namespace scrubjay {
namespace {

Pose2 random_pose(Random& random) {
  return {random.uniform(-50.0, 50.0), random.uniform(-50.0, 50.0), random.uniform(-kPi, kPi)};
}

void expect_same(const Pose2& a, const Pose2& b) {
  EXPECT_NEAR(a.x, b.x, 1e-12);
  EXPECT_NEAR(a.y, b.y, 1e-12);
  EXPECT_NEAR(angle_difference(a.yaw, b.yaw), 0.0, 1e-14);
}

TEST(Pose2Test, ComposesAQuarterTurnByHand) {
  const Pose2 parent{1.0, 2.0, radians(90.0)};
  expect_same(parent * Pose2{3.0, 1.0, radians(45.0)}, {0.0, 5.0, radians(135.0)});
  EXPECT_NEAR((parent * Point2{3.0, 1.0} - Point2{0.0, 5.0}).norm(), 0.0, 1e-15);
}

TEST(Pose2Test, InverseUndoesFromEitherSide) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Pose2 pose = random_pose(random);
    expect_same(pose * inverse(pose), {});
    expect_same(inverse(pose) * pose, {});
    expect_same(inverse(inverse(pose)), pose);
  }
}

TEST(Pose2Test, CompositionIsAssociativeAndMovesPointsAlike) {
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const Pose2 a = random_pose(random);
    const Pose2 b = random_pose(random);
    const Pose2 c = random_pose(random);
    expect_same((a * b) * c, a * (b * c));
    const Point2 p{c.x, c.y};
    EXPECT_NEAR(((a * b) * p - a * (b * p)).norm(), 0.0, 1e-12);
    EXPECT_NEAR((a * p - (a * c).position()).norm(), 0.0, 1e-12);
  }
}

TEST(Pose2Test, CompositionKeepsDistances) {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const Pose2 pose = random_pose(random);
    const Point2 p = random_pose(random).position();
    const Point2 q = random_pose(random).position();
    EXPECT_NEAR((pose * p - pose * q).norm(), (p - q).norm(), 1e-12);
  }
}

TEST(Pose2Test, CompositionWrapsTheYaw) {
  EXPECT_NEAR((Pose2{0, 0, radians(170.0)} * Pose2{0, 0, radians(30.0)}).yaw, radians(-160.0), 1e-15);
  EXPECT_EQ(inverse({0, 0, -kPi}).yaw, kPi);
}

TEST(Pose2Test, DirectionPointsAtTheAngle) {
  EXPECT_NEAR((direction(radians(30.0)) - Point2(std::sqrt(0.75), 0.5)).norm(), 0.0, 1e-15);
}

}  // namespace
}  // namespace scrubjay
