#include <gmock/gmock.h>

#include "stage.hpp"

namespace scrubjay::test {
namespace {

/// A hole, five millimetres around a point.
Polygon hole(const Point2& center) {
  return box(center, {0.01, 0.01}, 0.0);
}

TEST(CliffTest, EachSensorSeesTheHoleUnderIt) {
  const Pose2 pose{1.0, -2.0, 2.0};
  const sim::RobotSpec spec;
  for (std::size_t i = 0; i < spec.model.cliff_sensors.size(); ++i) {
    World world;
    world.cliffs = {hole(pose * spec.model.cliff_sensors[i])};
    Stage stage(world, pose);
    EXPECT_EQ(stage.feel().cliff_flags, 1 << i);
    EXPECT_FALSE(stage.feel().wheel_drop_left || stage.feel().wheel_drop_right);
  }
}

TEST(CliffTest, SensorsGoFromLeftToRight) {
  World world;
  world.cliffs = {box({0.1, 1.0}, {0.4, 2.0}, 0.0)};  // all that is on the left
  Stage stage(world);
  EXPECT_EQ(stage.feel().cliff_flags, 0b0011);
}

TEST(CliffTest, StopsSeeingItWhereThereIsFloorAgain) {
  World world;
  world.cliffs = {box({0.6, 0.0}, {0.2, 1.0}, 0.0)};
  Stage stage(world);
  EXPECT_EQ(stage.feel().cliff_flags, 0);
  EXPECT_EQ(stage.drive(0.2, 0.2, 2.0).cliff_flags & 0b0110, 0b0110) << "the front is over it";
  EXPECT_EQ(stage.drive(-0.2, -0.2, 2.0).cliff_flags, 0);
}

TEST(WheelDropTest, TheWheelOverTheHoleDrops) {
  World left;
  left.cliffs = {hole({0.0, 0.1175})};
  Stage over_left(left);
  EXPECT_TRUE(over_left.feel().wheel_drop_left);
  EXPECT_FALSE(over_left.feel().wheel_drop_right);
  World right;
  right.cliffs = {hole({0.0, -0.1175})};
  Stage over_right(right);
  EXPECT_FALSE(over_right.feel().wheel_drop_left);
  EXPECT_TRUE(over_right.feel().wheel_drop_right);
}

TEST(WheelDropTest, ARobotThatHangsDoesNotGetAnywhere) {
  World world;
  world.cliffs = {box({1.0, 0.0}, {1.0, 2.0}, 0.0)};
  Stage stage(world);
  stage.drive(0.2, 0.2, 4.0);
  const Pose2 hanging = stage.pose();
  EXPECT_NEAR(hanging.x, 0.5, 0.2 * kTick + 1e-9) << "it fell in at the edge";
  stage.drive(-0.2, -0.2, 4.0);
  stage.drive(-0.2, 0.2, 4.0);
  EXPECT_EQ(stage.pose(), hanging);
}

World with_carpet() {
  World world;
  world.carpets = {{box({1.5, 0.0}, {1.0, 1.0}, 0.0), 0.2}};
  return world;
}

TEST(CarpetTest, SlipsWhereItLies) {
  sim::NoiseProfile noise;
  noise.carpet_slip = 1.0;
  Stage stage(with_carpet(), {}, noise);
  double rolled = 0.0;
  while (stage.pose().x < 3.0) {
    const Pose2 before = stage.pose();
    const double now = stage.body.tick({0.2, 0.2}).left_rolled;
    const bool on_carpet = before.x > 1.0 && before.x < 2.0;
    EXPECT_NEAR(stage.pose().x - before.x, (on_carpet ? 0.8 : 1.0) * (now - rolled), 1e-9) << before.x;
    rolled = now;
  }
  EXPECT_NEAR(rolled, 3.0 + 0.25, 0.01) << "a metre of carpet takes a quarter more of rolling";
}

TEST(CarpetTest, TakesTheShareThatTheNoiseGives) {
  sim::NoiseProfile half;
  half.carpet_slip = 0.5;
  Stage stage(with_carpet(), {1.2, 0.0, 0.0}, half);
  const double rolled = stage.drive(0.1, 0.1, 3.0).left_rolled;
  EXPECT_NEAR(stage.pose().x - 1.2, 0.9 * rolled, 1e-9);
}

TEST(CarpetTest, DoesNotSlipWithoutNoise) {
  Stage stage(with_carpet());
  const double rolled = stage.drive(0.2, 0.2, 10.0).left_rolled;
  EXPECT_NEAR(stage.pose().x, rolled, 1e-12);
}

TEST(DirtTest, TellsTheStrongestSpotUnderTheRobot) {
  World world;
  world.dirt = {{{1.0, 0.0}, 0.1, 80}, {{1.05, 0.0}, 0.1, 200}};
  EXPECT_EQ(Stage(world, {0.5, 0.0, 0.0}).feel().dirt, 0);
  EXPECT_EQ(Stage(world, {0.92, 0.0, 0.0}).feel().dirt, 80);
  EXPECT_EQ(Stage(world, {1.05, 0.0, 0.0}).feel().dirt, 200);
  EXPECT_EQ(Stage(world, {1.16, 0.0, 0.0}).feel().dirt, 0);
}

TEST(DirtTest, IsFoundOnTheWay) {
  World world;
  world.dirt = {{{3.0, 0.0}, 0.1, 80}};
  Stage stage(world);
  int dirty_ticks = 0;
  for (int i = 0; i < ticks_in(30.0); ++i) dirty_ticks += stage.body.tick({0.2, 0.2}).dirt == 80;
  EXPECT_NEAR(dirty_ticks * kTick, 1.0, 2 * kTick) << "0.2 m of dirt at 0.2 m/s";
}

}  // namespace
}  // namespace scrubjay::test
