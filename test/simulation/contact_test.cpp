#include <gmock/gmock.h>

#include "stage.hpp"
#include "world/generated.hpp"

namespace scrubjay::test {
namespace {

/// How far the shell may give way at this speed: a millimetre of bumper, and what is driven within a tick [m].
constexpr double give(double speed) {
  return 0.001 + speed * kTick;
}

/// Drives, and gives how deep the shell was ever pressed into something.
double deepest(Stage& stage, double left, double right, double seconds) {
  double least = kRadius;
  for (int i = ticks_in(seconds); i > 0; --i) {
    stage.body.tick({left, right});
    least = std::min(least, stage.clearance());
  }
  return kRadius - least;
}

/// Speed [m/s], and degrees from square on.
class ApproachTest : public ::testing::TestWithParam<std::tuple<double, double>> {};

TEST_P(ApproachTest, AWallStopsTheRobot) {
  const auto [speed, angle] = GetParam();
  for (const double friction : {0.3, 10.0}) {
    sim::NoiseProfile noise;
    noise.wall_friction = friction;
    Stage stage(with_walls({{{{1.0, -9.0}, {1.0, 9.0}}}}), {0.0, 0.0, radians(angle)}, noise);
    const double depth = deepest(stage, speed, speed, 3.0 / speed);
    EXPECT_LT(depth, give(speed));
    EXPECT_GT(depth, 0.0) << "it got to the wall";
  }
}

TEST_P(ApproachTest, ACornerStopsTheRobot) {
  const auto [speed, angle] = GetParam();
  sim::NoiseProfile slippery;
  slippery.wall_friction = 0.3;
  Stage stage(room(2.0, 2.0), {1.0, 1.0, radians(angle)}, slippery);
  EXPECT_LT(deepest(stage, speed, speed, 4.0 / speed), give(speed));
}

TEST_P(ApproachTest, ATableLegStopsTheRobot) {
  const auto [speed, angle] = GetParam();
  World world;
  world.furniture = {{"leg", {box({1.0, 0.02}, {0.04, 0.04}, radians(angle))}}};
  Stage stage(world);
  EXPECT_LT(deepest(stage, speed, speed, 1.2 / speed), give(speed));
}

INSTANTIATE_TEST_SUITE_P(Approaches, ApproachTest,
                         ::testing::Combine(::testing::Values(0.1, 0.3, 0.5),
                                            ::testing::Values(0.0, 30.0, 45.0, 70.0)));

TEST(ContactTest, TheDiscNeverCrossesAWallInAnyRandomWorld) {
  std::uint64_t bumps = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    World world = room(4.0, 4.0);
    for (const SolidSegment& solid : random_segments(random, 12, 4.0, 1.0)) {
      world.walls.push_back({{solid.segment.a, solid.segment.b}});
    }
    Pose2 start{0.0, 0.0, random.uniform(-kPi, kPi)};
    const SegmentIndex index(solid_segments(world));
    do {
      start.x = random.uniform(0.0, 4.0);
      start.y = random.uniform(0.0, 4.0);
    } while (index.distance(start.position(), 1.0) < kRadius + 0.01);

    sim::NoiseProfile noise;
    noise.wall_friction = seed % 2 == 0 ? 0.3 : 10.0;
    noise.bump_kick = 0.02;
    Stage stage(world, start, noise, seed);
    double depth = 0.0;
    for (int leg = 0; leg < 60; ++leg) {
      const double left = random.uniform(-0.2, 0.5);
      depth = std::max(depth, deepest(stage, left, random.uniform(-0.2, 0.5), 1.0));
    }
    EXPECT_LT(depth, give(0.5)) << "seed " << seed;
    bumps += stage.body.truth().bumps;
  }
  EXPECT_GT(bumps, 50u);
}

TEST(ContactTest, EncodersStallAtAWallOfAFloorThatGrips) {
  Stage stage(with_walls({facing({0.0, 0.0}, 0.0, 0.5, 1.0)}));
  const sim::BodySenses& senses = stage.drive(0.2, 0.2, 10.0);
  EXPECT_NEAR(senses.left_rolled, stage.pose().x, 0.002);
  EXPECT_NEAR(senses.right_rolled, stage.pose().x, 0.002);
  EXPECT_TRUE(senses.wheel_blocked[0] && senses.wheel_blocked[1]);
}

TEST(ContactTest, EncodersGoOnAtAWallWhileTheWheelsSlip) {
  sim::NoiseProfile noise;
  noise.push_slip = 1.0;
  Stage stage(with_walls({facing({0.0, 0.0}, 0.0, 0.5, 1.0)}), {}, noise);
  const sim::BodySenses& senses = stage.drive(0.2, 0.2, 10.0);
  EXPECT_NEAR(senses.left_rolled, 0.2 * (10.0 - 0.25), 0.01);
  EXPECT_NEAR(stage.pose().x, 0.5 - kRadius, give(0.2));
}

TEST(ContactTest, SlidesAlongASlipperyWallAndCatchesOnARoughOne) {
  const auto slid = [](double friction) {
    sim::NoiseProfile noise;
    noise.wall_friction = friction;
    Stage stage(with_walls({{{{0.5, -9.0}, {0.5, 9.0}}}}), {0.0, 0.0, radians(60.0)}, noise);
    stage.drive(0.2, 0.2, 10.0);
    return stage.pose().y;
  };
  EXPECT_GT(slid(0.0), 1.5);
  EXPECT_LT(slid(10.0), 0.8);
}

TEST(ContactTest, ComesOffAWallBackwards) {
  Stage stage(with_walls({facing({0.0, 0.0}, 0.0, 0.5, 1.0)}));
  EXPECT_TRUE(stage.drive(0.2, 0.2, 5.0).bump_left);
  const double pressed = stage.pose().x;
  EXPECT_FALSE(stage.drive(-0.2, -0.2, 2.0).bump_left);
  EXPECT_LT(stage.pose().x, pressed - 0.2);
}

/// A post that presses one millimetre into the shell at a bearing.
struct Press {
  double degrees;
  bool left;
  bool right;
};

class BumperTest : public ::testing::TestWithParam<Press> {};

TEST_P(BumperTest, TheHalfThatIsHitCloses) {
  const Press& press = GetParam();
  const Pose2 pose{1.0, 2.0, 2.5};
  const Wall post = facing(pose.position(), pose.yaw + radians(press.degrees), kRadius - 0.001, 0.005);
  Stage stage(with_walls({post}), pose);
  const sim::BodySenses& senses = stage.feel();
  EXPECT_EQ(senses.bump_left, press.left);
  EXPECT_EQ(senses.bump_right, press.right);
}

INSTANTIATE_TEST_SUITE_P(Bearings, BumperTest,
                         ::testing::Values(Press{0.0, true, true}, Press{29.0, true, true}, Press{31.0, true, false},
                                           Press{60.0, true, false}, Press{89.0, true, false},
                                           Press{91.0, false, false}, Press{180.0, false, false},
                                           Press{-29.0, true, true}, Press{-31.0, false, true},
                                           Press{-60.0, false, true}, Press{-89.0, false, true},
                                           Press{-91.0, false, false}));

TEST(BumperTest, TwoPostsCloseBothHalves) {
  const Wall left = facing({0.0, 0.0}, radians(60.0), kRadius - 0.001, 0.005);
  const Wall right = facing({0.0, 0.0}, radians(-60.0), kRadius - 0.001, 0.005);
  Stage stage(with_walls({left, right}));
  EXPECT_TRUE(stage.feel().bump_left && stage.feel().bump_right);
}

TEST(BumperTest, CountsATouchOnceHoweverLongItLasts) {
  Stage stage(with_walls({facing({0.0, 0.0}, 0.0, 0.4, 1.0)}));
  stage.drive(0.2, 0.2, 5.0);
  EXPECT_EQ(stage.body.truth().bumps, 1u);
  stage.drive(-0.2, -0.2, 1.0);
  stage.drive(0.2, 0.2, 5.0);
  EXPECT_EQ(stage.body.truth().bumps, 2u);
}

TEST(BumperTest, ATouchTurnsTheRobotAsideWhenTheNoiseSaysSo) {
  double squares = 0.0;
  constexpr int kRuns = 400;
  for (int seed = 0; seed < kRuns; ++seed) {
    sim::NoiseProfile noise;
    noise.bump_kick = 0.02;
    Stage stage(with_walls({facing({0.0, 0.0}, 0.0, 0.2, 1.0)}), {}, noise, static_cast<std::uint64_t>(seed));
    stage.drive(0.1, 0.1, 0.9);
    EXPECT_EQ(stage.body.truth().bumps, 1u);
    squares += stage.pose().yaw * stage.pose().yaw;
  }
  EXPECT_NEAR(std::sqrt(squares / kRuns), 0.02, 0.02 * 0.12);
}

}  // namespace
}  // namespace scrubjay::test
