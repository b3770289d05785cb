#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <scrubjay/robot/oi_robot.hpp>

#include "scripted_channel.hpp"

namespace scrubjay {
namespace {

using oi::PacketId;
using testing::ElementsAre;
using testing::IsEmpty;

Bytes drive_direct(int right, int left) {
  const auto high = [](int v) { return static_cast<std::uint8_t>(static_cast<std::uint16_t>(v) >> 8); };
  const auto low = [](int v) { return static_cast<std::uint8_t>(v); };
  return {145, high(right), low(right), high(left), low(left)};
}

/// A robot in a session that has begun.
class OiRobotDriveTest : public testing::Test {
 protected:
  OiRobotDriveTest() { channel.take_written(); }

  Frame next(const oi::Sensors& sensors, double stamp) {
    channel.give(stamp, stream_frame(sensors));
    return robot.next().value();
  }
  static oi::Sensors in_mode(int mode) {
    oi::Sensors sensors = at_rest();
    sensors.set(PacketId::OiMode, mode);
    return sensors;
  }

  ScriptedChannel channel;
  OiRobot robot{channel, {}};
};

TEST_F(OiRobotDriveTest, SendsTheRightWheelFirst) {
  robot.drive({0.2, 1.0});  // 1 rad/s is 117.5 mm/s a wheel
  EXPECT_THAT(channel.written, ElementsAre(drive_direct(318, 83)));
}

TEST_F(OiRobotDriveTest, SendsNegativeSpeedsInTwosComplement) {
  robot.drive({-0.2, 0.0});
  EXPECT_THAT(channel.written, ElementsAre(Bytes{145, 0xFF, 0x38, 0xFF, 0x38}));
}

TEST_F(OiRobotDriveTest, WritesOnlyWhenTheSpeedsChange) {
  robot.drive({0.0, 0.0});  // it stands already
  robot.drive({0.2, 0.0});
  robot.drive({0.2, 0.0});
  robot.drive({0.2000001, 0.0});
  robot.drive({0.0, 0.0});
  robot.drive({0.0, 0.0});
  EXPECT_THAT(channel.written, ElementsAre(drive_direct(200, 200), drive_direct(0, 0)));
}

TEST_F(OiRobotDriveTest, LimitsTheWheelsToWhatTheyCan) {
  robot.drive({3.0, 0.0});
  robot.drive({-3.0, 0.0});
  EXPECT_THAT(channel.written, ElementsAre(drive_direct(500, 500), drive_direct(-500, -500)));
}

TEST_F(OiRobotDriveTest, KeepsTheCurveWhereOneWheelWouldHaveToBeTooFast) {
  robot.drive({0.5, 1.0});
  const double share = 0.5 / (0.5 + 0.1175);
  EXPECT_THAT(channel.written, ElementsAre(drive_direct(500, static_cast<int>(share * 382.5 + 0.5))));
}

TEST_F(OiRobotDriveTest, StandsWhereTheMotionIsNoNumber) {
  robot.drive({0.2, 0.0});
  robot.drive({std::numeric_limits<double>::quiet_NaN(), 0.0});
  robot.drive({0.2, 0.0});
  robot.drive({0.2, std::numeric_limits<double>::infinity()});
  EXPECT_THAT(channel.written,
              ElementsAre(drive_direct(200, 200), drive_direct(0, 0), drive_direct(200, 200), drive_direct(0, 0)));
}

TEST_F(OiRobotDriveTest, StopStandsAndLeavesARobotThatMayCharge) {
  robot.drive({0.2, 0.0});
  channel.take_written();
  robot.stop();
  const Bytes stand{137, 0, 0, 0x80, 0};
  EXPECT_THAT(channel.written, ElementsAre(Bytes(256, 0), stand, kStart, stand, kStart));
}

TEST_F(OiRobotDriveTest, DrivesAgainAfterAStop) {
  robot.drive({0.2, 0.0});
  robot.stop();
  channel.take_written();
  robot.drive({0.2, 0.0});
  EXPECT_THAT(channel.written, ElementsAre(drive_direct(200, 200)));
}

TEST_F(OiRobotDriveTest, TakesUpSafeModeAgainAndTheMotionWithIt) {
  next(in_mode(2), 0.0);
  robot.drive({0.2, 0.0});
  EXPECT_THAT(channel.take_written(), ElementsAre(drive_direct(200, 200)));
  EXPECT_EQ(next(in_mode(1), 1.0).mode, oi::OiMode::Passive);
  EXPECT_THAT(channel.take_written(), ElementsAre(kSafe));
  robot.drive({0.2, 0.0});  // the robot stands: the same motion must be told again
  EXPECT_THAT(channel.take_written(), ElementsAre(drive_direct(200, 200)));
}

TEST_F(OiRobotDriveTest, WakesARobotThatWasSwitchedOff) {
  next(in_mode(2), 0.0);
  next(in_mode(0), 1.0);
  EXPECT_THAT(channel.written, ElementsAre(kStart, kSafe));
}

TEST_F(OiRobotDriveTest, LeavesFullModeAsItIs) {
  next(in_mode(2), 0.0);
  next(in_mode(3), 1.0);
  EXPECT_THAT(channel.written, IsEmpty());
}

TEST_F(OiRobotDriveTest, WaitsForTheRobotToStandOnItsWheels) {
  next(in_mode(2), 0.0);
  for (const int drops : {0b0100, 0b1000, 0b1100}) {
    oi::Sensors lifted = in_mode(1);
    lifted.set(PacketId::BumpsAndWheelDrops, drops);
    next(lifted, 1.0 + drops);
    EXPECT_THAT(channel.written, IsEmpty());
  }
  next(in_mode(1), 20.0);
  EXPECT_THAT(channel.written, ElementsAre(kSafe));
}

TEST_F(OiRobotDriveTest, DoesntDisturbARobotThatCharges) {
  next(in_mode(2), 0.0);
  oi::Sensors charging = in_mode(1);
  charging.set(PacketId::ChargingState, 2);
  next(charging, 1.0);
  EXPECT_THAT(channel.written, IsEmpty());
}

TEST_F(OiRobotDriveTest, TriesForControlAFewTimesASecondAndNotEveryTick) {
  next(in_mode(2), 0.0);
  for (int i = 0; i <= 200; ++i) next(in_mode(1), 1.0 + i * 0.015);
  EXPECT_GE(channel.written.size(), 9u);
  EXPECT_LE(channel.written.size(), 13u);
}

TEST(OiRobotQuirksTest, KnowsTheModeOfARobotThatReportsItOneTooHigh) {
  ScriptedChannel channel;
  OiRobot robot(channel, {}, {.mode_one_too_high = true});
  channel.take_written();
  oi::Sensors sensors = at_rest();
  sensors.set(PacketId::OiMode, 3);
  channel.give(0.0, stream_frame(sensors));
  channel.give(1.0, stream_frame(sensors));
  EXPECT_EQ(robot.next()->mode, oi::OiMode::Safe);
  EXPECT_EQ(robot.next()->mode, oi::OiMode::Safe);
  EXPECT_THAT(channel.take_written(), IsEmpty());
  sensors.set(PacketId::OiMode, 2);
  channel.give(2.0, stream_frame(sensors));
  EXPECT_EQ(robot.next()->mode, oi::OiMode::Passive);
  EXPECT_THAT(channel.take_written(), ElementsAre(kSafe));
}

}  // namespace
}  // namespace scrubjay
