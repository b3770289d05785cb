#include <gmock/gmock.h>

#include <scrubjay/simulation/simulated_roomba.hpp>

#include "stage.hpp"
#include "wire.hpp"

namespace scrubjay::test {
namespace {

using sim::RobotFaults;

/// A body with something wrong, in a world of its own.
class Faulty {
 public:
  explicit Faulty(const RobotFaults& faults, World scenery = {})
      : world_(std::move(scenery)),
        index_(solid_segments(world_)),
        body(world_, index_, {}, {}, Random(1), {}, faults) {}
  Faulty(const Faulty&) = delete;
  Faulty& operator=(const Faulty&) = delete;

  const sim::BodySenses& drive(double left, double right, double seconds) {
    for (int i = ticks_in(seconds); i > 1; --i) body.tick({left, right});
    return body.tick({left, right});
  }

 private:
  World world_;
  SegmentIndex index_;

 public:
  sim::RoombaBody body;
};

TEST(RobotFaultsTest, StartsWithAsMuchChargeAsIsAskedFor) {
  RobotFaults faults;
  faults.battery = 0.1;
  Faulty robot(faults);
  const Battery battery = robot.drive(0.0, 0.0, kTick).battery;
  EXPECT_NEAR(battery.charge, 0.1 * battery.capacity, 1e-4);
  EXPECT_NEAR(battery.voltage, 13.2 + 0.1 * (16.8 - 13.2), 1e-3);
}

TEST(RobotFaultsTest, HangsWhileItIsLiftedAndItsWheelsTurn) {
  RobotFaults faults;
  faults.lifted = {1.0, 3.0};
  Faulty robot(faults);
  EXPECT_FALSE(robot.drive(0.2, 0.2, 0.9).wheel_drop_left);
  const sim::BodySenses lifted = robot.drive(0.2, 0.2, 0.9);
  EXPECT_TRUE(lifted.wheel_drop_left && lifted.wheel_drop_right);
  EXPECT_EQ(lifted.cliff_flags, 0xF) << "there is no floor";
  EXPECT_FALSE(lifted.making_way);
  const Pose2 pose = robot.body.truth().pose;
  const sim::BodySenses later = robot.drive(0.2, -0.2, 1.0);
  EXPECT_EQ(robot.body.truth().pose, pose);
  EXPECT_GT(later.left_rolled, lifted.left_rolled + 0.1);
  const sim::BodySenses down = robot.drive(0.2, 0.2, 2.0);
  EXPECT_FALSE(down.wheel_drop_left || down.wheel_drop_right);
  EXPECT_EQ(down.cliff_flags, 0);
  EXPECT_GT((robot.body.truth().pose.position() - pose.position()).norm(), 0.2);
}

TEST(RobotFaultsTest, AStuckWheelStandsAndDrawsCurrentAndTheOtherOneTurnsAroundIt) {
  RobotFaults faults;
  faults.stuck_wheel[0] = {1.0, 2.0};
  Faulty robot(faults);
  const sim::BodySenses before = robot.drive(0.2, 0.2, 0.99);
  EXPECT_FALSE(before.wheel_blocked[0]);
  const sim::BodySenses stuck = robot.drive(0.2, 0.2, 0.96);
  EXPECT_LT(stuck.left_rolled - before.left_rolled, 0.2 * 3 * kTick);
  EXPECT_GT(stuck.right_rolled - before.right_rolled, 0.18);
  EXPECT_TRUE(stuck.wheel_blocked[0]);
  EXPECT_FALSE(stuck.wheel_blocked[1]);
  EXPECT_NEAR(robot.body.truth().pose.yaw, (stuck.right_rolled - stuck.left_rolled) / kAxle, 1e-6);
  const sim::BodySenses after = robot.drive(0.2, 0.2, 1.5);
  EXPECT_FALSE(after.wheel_blocked[0]);
  EXPECT_GT(after.left_rolled - stuck.left_rolled, 0.15);
}

TEST(RobotFaultsTest, AStuckWheelThatNobodyTurnsDrawsNoCurrent) {
  RobotFaults faults;
  faults.stuck_wheel[1] = {0.0};
  Faulty robot(faults);
  EXPECT_FALSE(robot.drive(0.2, 0.0, 1.0).wheel_blocked[1]);
}

TEST(RobotFaultsTest, ALiftedRobotFallsBackToPassive) {
  const World world;
  const SegmentIndex index(solid_segments(world));
  RobotFaults faults;
  faults.lifted = {0.5, 1.0};
  sim::SimulatedRoomba roomba(world, index, {}, {}, Random(1), {}, {}, faults);
  roomba.write(Bytes{128, 131});
  Bytes buffer(64);
  while (roomba.now() < 0.45) roomba.read(buffer);
  EXPECT_EQ(roomba.firmware().mode(), oi::OiMode::Safe);
  while (roomba.now() < 1.5) roomba.read(buffer);
  EXPECT_EQ(roomba.firmware().mode(), oi::OiMode::Passive);
}

constexpr double kSlop = 0.006;  ///< Box2D lets discs overlap by 5 mm, and a bit [m]

/// Two bodies of one world, in turn, as in an emulation.
class OtherRobotTest : public testing::Test {
 protected:
  void tick(const sim::WheelSpeeds& first, const sim::WheelSpeeds& second) {
    const auto as_disc = [](const sim::RoombaBody& body) { return sim::Disc{body.truth().pose.position(), kRadius}; };
    const sim::Disc one = as_disc(second_);
    first_.place_others(std::span(&one, 1));
    first_senses_ = first_.tick(first);
    const sim::Disc other = as_disc(first_);
    second_.place_others(std::span(&other, 1));
    second_senses_ = second_.tick(second);
  }
  void tick(const sim::WheelSpeeds& first, const sim::WheelSpeeds& second, double seconds) {
    for (int i = ticks_in(seconds); i > 0; --i) tick(first, second);
  }
  double gap() const {
    return (first_.truth().pose.position() - second_.truth().pose.position()).norm() - 2.0 * kRadius;
  }

  World world_ = room(6.0, 6.0);
  SegmentIndex index_{solid_segments(world_)};
  sim::RoombaBody first_{world_, index_, {}, {}, Random(1), {2.0, 3.0, 0.0}};
  sim::RoombaBody second_{world_, index_, {}, {}, Random(2), {3.0, 3.0, kPi}};
  sim::BodySenses first_senses_;
  sim::BodySenses second_senses_;
};

TEST_F(OtherRobotTest, BlocksAndIsFeltByBoth) {
  tick({0.2, 0.2}, {}, 6.0);
  EXPECT_NEAR(gap(), 0.0, kSlop);
  EXPECT_TRUE(first_senses_.bump_left && first_senses_.bump_right);
  EXPECT_TRUE(second_senses_.bump_left && second_senses_.bump_right);
  EXPECT_EQ(second_.truth().pose.position(), Point2(3.0, 3.0)) << "nobody is pushed away";
  EXPECT_EQ(first_.truth().bumps, 1u);
}

TEST_F(OtherRobotTest, IsSeenByTheLightSensors) {
  tick({}, {});
  const double far = first_senses_.light_signal[2];
  tick({0.2, 0.2}, {}, 3.1);
  EXPECT_GT(gap(), 0.05);
  EXPECT_GT(first_senses_.light_signal[2], far + 50.0);
}

TEST_F(OtherRobotTest, ThatMeetHeadOnNeverOverlap) {
  for (int i = 0; i < ticks_in(6.0); ++i) {
    tick({0.5, 0.5}, {0.5, 0.49});
    ASSERT_GT(gap(), -kSlop);
  }
}

TEST_F(OtherRobotTest, LeavesNoTraceOnceItHasGone) {
  tick({}, {});
  const sim::Disc away{{-50.0, -50.0}, kRadius};
  first_.place_others(std::span(&away, 1));
  for (int i = ticks_in(8.0); i > 0; --i) first_.tick({0.2, 0.2});
  EXPECT_GT(first_.truth().pose.x, 3.2) << "where it stood";
}

}  // namespace
}  // namespace scrubjay::test
