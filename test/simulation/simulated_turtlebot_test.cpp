#include <gmock/gmock.h>

#include <cstring>
#include <limits>

#include "burger.hpp"
#include "world/generated.hpp"

namespace scrubjay::test {
namespace {

const double kCount = 2.0 * kPi * 0.033 / 4096.0;

TEST(SimulatedTurtlebotTest, DrivesStraightAsToldOnAPerfectFloor) {
  Burger burger({}, {1.0, 2.0, 0.0});
  const Frame frame = burger.drive({0.2, 0.0}, 10.0);
  EXPECT_EQ(frame.stamp, 10.0);
  EXPECT_EQ(burger.robot.truth().ticks, 500u);
  EXPECT_EQ(burger.pose().y, 2.0);
  // Full speed, but for the time to reach it: half of 0.2 / 1.0 s, half a tick more or less.
  EXPECT_NEAR(burger.pose().x - 1.0, 0.2 * (10.0 - 0.1), 0.2 * Burger::kTick);
  EXPECT_NEAR(burger.robot.truth().distance, burger.pose().x - 1.0, 1e-9);
}

TEST(SimulatedTurtlebotTest, TellsTravelInWholeCountsAndLosesNone) {
  Burger burger({});
  Random driver(3);
  double left = 0.0;
  double right = 0.0;
  Pose2 reckoned;
  for (int i = 0; i < 20'000; ++i) {
    if (i % 40 == 0) burger.robot.drive({driver.uniform(-0.1, 0.2), driver.uniform(-1.0, 1.0)});
    const std::optional<Frame> frame = burger.robot.next();
    for (const double travel : {frame->left_travel, frame->right_travel}) {
      EXPECT_NEAR(travel / kCount, std::round(travel / kCount), 1e-6);
    }
    left += frame->left_travel;
    right += frame->right_travel;
    reckoned = reckoned * arc_motion({frame->left_travel, frame->right_travel}, Burger::spec().model.drive);
    // What the wheels turned is what the robot turned: never more than a count off, however long it drives.
    const double turn = (right - left) / 0.160;
    ASSERT_NEAR(angle_difference(turn, burger.pose().yaw), 0.0, 2.0 * kCount / 0.160);
  }
  EXPECT_GT(burger.robot.truth().distance, 10.0);
  EXPECT_NEAR((reckoned.position() - burger.pose().position()).norm(), 0.0, 0.01);
}

TEST(SimulatedTurtlebotTest, CountsAllOfASlowCreep) {
  Burger burger({});
  burger.robot.drive({0.0004, 0.0});  // a sixth of a count a tick
  double sum = 0.0;
  for (int i = 0; i < 10'000; ++i) sum += burger.robot.next()->left_travel;
  EXPECT_NEAR(sum, burger.pose().x, kCount);
  EXPECT_GT(sum, 0.05);
}

struct Speed {
  double linear, angular;
};

Speed steady_speed(const Motion& motion, const sim::NoiseProfile& noise = {}) {
  Burger burger({}, {}, noise);
  burger.drive(motion, 2.0);
  const Pose2 before = burger.pose();
  burger.robot.next();
  const Pose2 step = inverse(before) * burger.pose();
  return {std::copysign(step.position().norm(), step.x) / Burger::kTick, step.yaw / Burger::kTick};
}

TEST(SimulatedTurtlebotTest, IsNoFasterThanItsBase) {
  EXPECT_NEAR(steady_speed({1.0, 0.0}).linear, 0.22, 1e-9);
  EXPECT_NEAR(steady_speed({-1.0, 0.0}).linear, -0.22, 1e-9);
  EXPECT_NEAR(steady_speed({0.0, 10.0}).angular, 2.84, 1e-9);
  EXPECT_NEAR(steady_speed({0.0, -10.0}).angular, -2.84, 1e-9);
  EXPECT_NEAR(steady_speed({0.1, 0.5}).linear, 0.1, 1e-5);
  EXPECT_NEAR(steady_speed({0.1, 0.5}).angular, 0.5, 1e-9);
}

TEST(SimulatedTurtlebotTest, IsNoFasterThanItsBaseEvenIfItsWheelsCould) {
  sim::RobotSpec spec = Burger::spec();
  spec.model.max_wheel_speed = 1.0;
  const World world;
  const SegmentIndex index({});
  const auto after_a_second = [&](const Motion& motion) {
    sim::SimulatedTurtlebot robot(world, index, spec, {}, Random(1), {});
    robot.drive(motion);
    for (int i = 0; i < 50; ++i) robot.next();
    const Pose2 before = robot.truth().pose;
    robot.next();
    return Speed{(robot.truth().pose.x - before.x) / Burger::kTick,
                 angle_difference(robot.truth().pose.yaw, before.yaw) / Burger::kTick};
  };
  EXPECT_NEAR(after_a_second({0.9, 0.0}).linear, 0.22, 1e-9);
  EXPECT_NEAR(after_a_second({0.0, 5.0}).angular, 2.84, 1e-9);
}

TEST(SimulatedTurtlebotTest, KeepsTheCurveOfAMotionThatIsTooFast) {
  for (const Motion motion : {Motion{0.22, 2.84}, Motion{2.2, 2.84}, Motion{0.22, 28.4}, Motion{-1.0, 3.0}}) {
    const Speed speed = steady_speed(motion);
    EXPECT_NEAR(speed.angular / speed.linear / (motion.angular / motion.linear), 1.0, 1e-3) << motion.angular;
    EXPECT_LE(std::fabs(speed.linear) + 0.08 * std::fabs(speed.angular), 0.2272 + 1e-9);
    EXPECT_GT(std::fabs(speed.linear) + 0.08 * std::fabs(speed.angular), 0.2);
  }
}

TEST(SimulatedTurtlebotTest, StandsStillForWhatIsNoNumber) {
  Burger burger({});
  burger.robot.drive({std::numeric_limits<double>::quiet_NaN(), 0.0});
  burger.robot.next();
  burger.robot.drive({0.0, std::numeric_limits<double>::infinity()});
  burger.robot.next();
  EXPECT_EQ(burger.pose(), Pose2{});
}

TEST(SimulatedTurtlebotTest, GainsAndLosesSpeedNoFasterThanItsWheelsCan) {
  Burger burger({});
  double speed = 0.0;
  const auto ticks_to = [&](double wanted) {
    burger.robot.drive({wanted, 0.0});
    int ticks = 0;
    while (std::fabs(speed - wanted) > 1e-9 && ticks < 1000) {
      const double from = burger.pose().x;
      burger.robot.next();
      const double now = (burger.pose().x - from) / Burger::kTick;
      EXPECT_LE(std::fabs(now - speed), 1.0 * Burger::kTick + 1e-9);
      speed = now;
      ++ticks;
    }
    return ticks;
  };
  EXPECT_EQ(ticks_to(0.2), 10);
  EXPECT_EQ(ticks_to(-0.2), 20);
}

TEST(SimulatedTurtlebotTest, StopsAndStaysThere) {
  Burger burger({});
  burger.drive({0.2, 1.0}, 1.0);
  burger.robot.stop();
  for (int i = 0; i < 20; ++i) burger.robot.next();
  const Pose2 pose = burger.pose();
  const std::optional<Frame> frame = burger.robot.next();
  EXPECT_EQ(burger.pose(), pose);
  EXPECT_EQ(frame->left_travel, 0.0);
}

TEST(SimulatedTurtlebotTest, FeelsNothingOfWhatItRunsInto) {
  Burger burger(with_walls({facing({0.0, 0.0}, 0.0, 0.5, 1.0)}));
  burger.robot.drive({0.2, 0.0});
  for (int i = 0; i < 400; ++i) {
    const std::optional<Frame> frame = burger.robot.next();
    EXPECT_FALSE(frame->bumped() || frame->wheel_dropped() || frame->cliff_flags != 0 || frame->light_flags != 0);
  }
  EXPECT_EQ(burger.robot.truth().bumps, 1u);
  EXPECT_NEAR(burger.index.distance(burger.pose().position(), 1.0), 0.105, 0.006);
  burger.drive({-0.2, 0.0}, 1.0);
  burger.drive({0.2, 0.0}, 3.0);
  EXPECT_EQ(burger.robot.truth().bumps, 2u);
}

TEST(SimulatedTurtlebotTest, CountsWhatItsBackRunsInto) {
  Burger burger(with_walls({facing({0.0, 0.0}, kPi, 0.3, 1.0)}));
  burger.drive({-0.2, 0.0}, 3.0);
  EXPECT_EQ(burger.robot.truth().bumps, 1u);
}

TEST(SimulatedTurtlebotTest, SpinsItsWheelsAgainstAWallWhereTheFloorLetsIt) {
  sim::NoiseProfile noise;
  noise.push_slip = 1.0;
  const auto rolled = [&](const sim::NoiseProfile& profile) {
    Burger burger(with_walls({facing({0.0, 0.0}, 0.0, 0.5, 1.0)}), {}, profile);
    burger.robot.drive({0.2, 0.0});
    double sum = 0.0;
    for (int i = 0; i < 500; ++i) sum += burger.robot.next()->left_travel;
    return sum;
  };
  EXPECT_NEAR(rolled({}), 0.395, 0.01);
  EXPECT_NEAR(rolled(noise), 1.98, 0.01);
}

TEST(SimulatedTurtlebotTest, HangsWhereAWheelHasNoFloor) {
  World world;
  world.cliffs = {box({1.0, 0.0}, {1.0, 4.0}, 0.0)};
  Burger burger(world);
  burger.drive({0.2, 0.0}, 4.0);
  const Pose2 pose = burger.pose();
  EXPECT_NEAR(pose.x, 0.5, 0.2 * Burger::kTick);
  burger.drive({-0.2, 0.5}, 4.0);
  EXPECT_EQ(burger.pose(), pose);
}

TEST(SimulatedTurtlebotTest, HasNotTheSpeedStepsOfACreate2) {
  sim::NoiseProfile noise;
  noise.speed_step = 0.0285;
  noise.speed_deadband = 0.011;
  EXPECT_NEAR(steady_speed({0.01, 0.0}, noise).linear, 0.01, 1e-9);
  EXPECT_NEAR(steady_speed({0.15, 0.0}, noise).linear, 0.15, 1e-9);
}

TEST(SimulatedTurtlebotTest, UsesItsBatteryUp) {
  Burger burger({});
  const Battery full = burger.robot.next()->battery;
  EXPECT_NEAR(full.charge, 1.8, 1e-3);
  const Battery later = burger.drive({0.2, 0.0}, 600.0).battery;
  EXPECT_NEAR(later.charge, 1.8 - 0.764 / 6.0, 0.01);  // 0.5 A and twice 0.15 A at 0.2 of 0.2272 m/s
  EXPECT_LT(later.voltage, full.voltage);
}

TEST(SimulatedTurtlebotTest, GivesFramesWithoutALidar) {
  const World world = room(3.0, 3.0);
  const SegmentIndex index(solid_segments(world));
  sim::RobotSpec spec = Burger::spec();
  spec.model.lidar.reset();
  sim::SimulatedTurtlebot robot(world, index, spec, {}, Random(1), {1.0, 1.0, 0.0});
  for (int i = 0; i < 30; ++i) EXPECT_FALSE(robot.next()->scan);
}

/// FNV-1a over everything that a robot senses on its way through a house, and the truth.
std::uint64_t run_digest(const World& world, const SegmentIndex& index, std::string_view profile, std::uint64_t seed,
                         bool motion_distortion) {
  sim::SimulatedTurtlebot robot(world, index, Burger::spec(), Burger::noise(profile), Random(seed), {2.0, 1.0, 0.4},
                                {motion_distortion});
  std::uint64_t digest = 0xCBF29CE484222325ull;
  const auto add = [&](const auto& value) {
    std::array<unsigned char, sizeof(value)> bytes;
    std::memcpy(bytes.data(), &value, sizeof(value));
    for (const unsigned char byte : bytes) digest = (digest ^ byte) * 0x100000001B3ull;
  };
  for (int i = 0; i < 6000; ++i) {
    const std::optional<Frame> frame = robot.next();
    for (const double value : {frame->stamp, frame->left_travel, frame->right_travel, frame->battery.charge})
      add(value);
    for (const double value : {robot.truth().pose.x, robot.truth().pose.y, robot.truth().pose.yaw}) add(value);
    if (!frame->scan) continue;
    for (const float range : frame->scan->ranges) add(range);
    robot.drive(frame->scan->ranges[0] < 0.15f ? Motion{-0.05, 1.5} : Motion{0.22, 0.05});
  }
  EXPECT_GT(robot.truth().bumps, 0u) << "too tame to tell";
  return digest;
}

TEST(TurtlebotDeterminismTest, TheSameSeedGivesTheSameRunToTheBit) {
  Random random(7);
  const World world = random_house(random, 3, 3.0);
  const SegmentIndex index(solid_segments(world));
  for (const bool distortion : {false, true}) {
    const std::uint64_t first = run_digest(world, index, "carpet", 1, distortion);
    EXPECT_EQ(run_digest(world, index, "carpet", 1, distortion), first);
    EXPECT_NE(run_digest(world, index, "carpet", 2, distortion), first);
  }
}

}  // namespace
}  // namespace scrubjay::test
