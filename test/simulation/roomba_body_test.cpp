#include <gmock/gmock.h>

#include "stage.hpp"

namespace scrubjay::test {
namespace {

using ::testing::DoubleNear;

TEST(RoombaBodyTest, DrivesStraightExactlyOnAPerfectFloor) {
  Stage stage({}, {1.0, 2.0, 0.0});
  const sim::BodySenses& senses = stage.drive(0.2, 0.2, 10.0);
  EXPECT_EQ(stage.pose().y, 2.0);
  EXPECT_EQ(stage.pose().yaw, 0.0);
  EXPECT_NEAR(stage.pose().x - 1.0, senses.left_rolled, 1e-12);
  EXPECT_EQ(senses.left_rolled, senses.right_rolled);
  // 10 s at full speed, but for the time to reach it: half of 0.2 / 0.4 s, half a tick more or less.
  EXPECT_NEAR(senses.left_rolled, 0.2 * (ticks_in(10.0) * kTick - 0.25), 0.2 * kTick);
  EXPECT_NEAR(stage.body.truth().distance, senses.left_rolled, 1e-12);
}

TEST(RoombaBodyTest, DrivesBackwards) {
  Stage stage({}, {0.0, 0.0, 0.5 * kPi});
  const sim::BodySenses& senses = stage.drive(-0.1, -0.1, 5.0);
  EXPECT_LT(senses.left_rolled, -0.4);
  EXPECT_NEAR(stage.pose().y, senses.left_rolled, 1e-12);
  EXPECT_NEAR(stage.body.truth().distance, -senses.left_rolled, 1e-12) << "distance counts either way";
}

TEST(RoombaBodyTest, GainsAndLosesSpeedNoFasterThanItsMotorsCan) {
  Stage stage({});
  const sim::RobotSpec spec;
  double rolled = 0.0;
  double speed = 0.0;
  // Ticks until the wheels turn as fast as that, each change within `limit` [m/s^2].
  const auto ticks_to = [&](double wanted, double limit) {
    for (int ticks = 0; ticks < 1000; ++ticks) {
      if (std::fabs(speed - wanted) < 1e-9) return ticks;
      const double before = speed;
      speed = (stage.body.tick({wanted, wanted}).left_rolled - rolled) / kTick;
      rolled += speed * kTick;
      EXPECT_LE(std::fabs(speed - before), limit * kTick + 1e-9);
    }
    return 1000;
  };
  EXPECT_NEAR(ticks_to(0.4, spec.acceleration) * kTick, 0.4 / spec.acceleration, kTick);
  EXPECT_NEAR(ticks_to(0.0, spec.braking) * kTick, 0.4 / spec.braking, kTick);
  EXPECT_NEAR(ticks_to(-0.4, spec.acceleration) * kTick, 0.4 / spec.acceleration, kTick);
  EXPECT_NEAR(ticks_to(-0.1, spec.braking) * kTick, 0.3 / spec.braking, kTick);
}

TEST(RoombaBodyTest, IsNeverFasterThanItsWheels) {
  Stage stage({});
  const double before = stage.drive(5.0, -5.0, 3.0).left_rolled;
  const sim::BodySenses& senses = stage.drive(5.0, -5.0, kTick);
  EXPECT_NEAR(senses.left_rolled - before, 0.5 * kTick, 1e-12);
}

TEST(RoombaBodyTest, TurnsInPlaceOverWhatItsWheelsRoll) {
  Stage stage({}, {1.0, -1.0, 0.3});
  const sim::BodySenses& senses = stage.drive(-0.1, 0.1, 60.0);
  EXPECT_EQ(stage.pose().x, 1.0);
  EXPECT_EQ(stage.pose().y, -1.0);
  EXPECT_EQ(stage.body.truth().distance, 0.0);
  const double turn = (senses.right_rolled - senses.left_rolled) / kAxle;
  EXPECT_GT(turn, 8.0 * kPi);
  EXPECT_NEAR(angle_difference(stage.pose().yaw, 0.3 + turn), 0.0, 1e-9);
}

TEST(RoombaBodyTest, DrivesACircleAroundOnePoint) {
  Stage stage({});
  stage.drive(0.1, 0.2, 2.0);
  const double radius = 0.5 * kAxle * (0.2 + 0.1) / (0.2 - 0.1);
  const Point2 center = stage.pose() * Point2(0.0, radius);
  for (int i = 0; i < 2000; ++i) {
    stage.body.tick({0.1, 0.2});
    EXPECT_THAT((stage.pose().position() - center).norm(), DoubleNear(radius, 1e-9));
  }
}

TEST(RoombaBodyTest, StandsStillAndFeelsNothingInAnEmptyWorld) {
  Stage stage({}, {3.0, 4.0, 1.0});
  const sim::BodySenses& senses = stage.drive(0.0, 0.0, 5.0);
  EXPECT_EQ(stage.pose(), (Pose2{3.0, 4.0, 1.0}));
  EXPECT_EQ(senses.left_rolled, 0.0);
  EXPECT_FALSE(senses.bump_left || senses.bump_right || senses.wall || senses.virtual_wall || senses.docked);
  EXPECT_FALSE(senses.wheel_drop_left || senses.wheel_drop_right || senses.making_way);
  EXPECT_EQ(senses.cliff_flags, 0);
  EXPECT_EQ(senses.light_flags, 0);
  EXPECT_EQ(stage.body.truth().ticks, static_cast<std::uint64_t>(ticks_in(5.0)));
}

TEST(RoombaBodyTest, TellsThatItMakesWay) {
  Stage stage(with_walls({facing({0.0, 0.0}, 0.0, 0.6, 1.0)}));
  EXPECT_TRUE(stage.drive(0.2, 0.2, 1.0).making_way);
  EXPECT_FALSE(stage.drive(0.2, 0.2, 4.0).making_way) << "the wall is in the way";
  EXPECT_FALSE(stage.drive(-0.1, 0.1, 3.0).making_way) << "the caster wheel doesn't turn in a spin";
}

}  // namespace
}  // namespace scrubjay::test
