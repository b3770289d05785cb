#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <scrubjay/geometry/random.hpp>
#include <scrubjay/robot/oi_robot.hpp>

#include "scripted_channel.hpp"

namespace scrubjay {
namespace {

using oi::PacketId;
using testing::ElementsAre;

const Bytes kQuery{142, 0};

/// A Roomba 400, which can't stream.
class OiRobotPollingTest : public testing::Test {
 protected:
  static RobotModel roomba_400() {
    RobotModel model;
    model.protocol = oi::Model::Roomba400;
    return model;
  }
  /// As the robot is told by Drive: velocity and radius [mm/s, mm].
  std::pair<int, int> told(const Motion& motion) {
    channel.take_written();
    robot.drive(motion);
    const Bytes bytes = channel.written.at(0);
    EXPECT_EQ(bytes.at(0), 137);
    const auto word = [&](std::size_t i) { return static_cast<std::int16_t>(bytes.at(i) << 8 | bytes.at(i + 1)); };
    return {word(1), word(3)};
  }

  ScriptedChannel channel;
  OiRobot robot{channel, roomba_400()};
};

TEST_F(OiRobotPollingTest, TakesControlAndAsksOnce) {
  EXPECT_THAT(channel.written, ElementsAre(Bytes{128}, Bytes{130}, kQuery));
}

TEST_F(OiRobotPollingTest, AsksAgainWhenTheReplyIsWhole) {
  channel.take_written();
  const Bytes bytes = reply(measured(0, 0));
  channel.give(0.0, {bytes.begin(), bytes.begin() + 10});
  channel.give(0.005, {bytes.begin() + 10, bytes.end()});
  ASSERT_TRUE(robot.next());
  EXPECT_THAT(channel.written, ElementsAre(kQuery));
}

TEST_F(OiRobotPollingTest, ReadsHalfTheWheelsDifferenceInMillimetres) {
  channel.give(0.0, reply(measured(0, 0)));
  channel.give(0.02, reply(measured(8, 3)));
  robot.next();
  const Frame frame = robot.next().value();
  EXPECT_NEAR(frame.left_travel, 0.005, 1e-15);
  EXPECT_NEAR(frame.right_travel, 0.011, 1e-15);
}

TEST_F(OiRobotPollingTest, DoesntStoreAValueOutOfRange) {
  oi::Sensors s = measured(0, 0);
  s.set(PacketId::Wall, 1);
  channel.give(0.0, reply(s));
  s.set(PacketId::Wall, 200);
  channel.give(0.02, reply(s));
  robot.next();
  EXPECT_TRUE(robot.next()->wall);
  EXPECT_EQ(robot.rejected_values(), 1u);
  EXPECT_EQ(robot.sensors()[PacketId::Wall], 1);
}

TEST_F(OiRobotPollingTest, ADroppedByteCostsOneReply) {
  Bytes cut = reply(measured(5, 0));
  cut.pop_back();
  channel.give(0.0, reply(measured(0, 0)));
  channel.give(0.015, cut);
  for (const double stamp : {0.03, 0.045}) channel.give(stamp, {});
  robot.next();
  channel.take_written();
  channel.give(0.06, reply(measured(6, 0)));
  const auto frame = robot.next();
  ASSERT_TRUE(frame);
  EXPECT_NEAR(frame->left_travel, 0.006, 1e-15);
  EXPECT_EQ(frame->stamp, 0.06);
  // Asked again once after the time out, and once for the frame after this.
  EXPECT_THAT(channel.written, ElementsAre(kQuery, kQuery));
}

TEST_F(OiRobotPollingTest, AStrayByteDoesntShiftTheRepliesBehindIt) {
  channel.give(0.0, reply(measured(0, 0)));
  channel.give(0.015, Bytes{19} + reply(measured(5, 0)));
  channel.give(0.03, {});
  channel.give(0.045, reply(measured(7, 0)));
  robot.next();
  robot.next();
  EXPECT_NEAR(robot.next()->left_travel, 0.007, 1e-15);
}

TEST_F(OiRobotPollingTest, WaitsForSilenceWhenALateByteMayFollow) {
  const Bytes shifted = Bytes{0x55} + reply(measured(5, 0));  // no bumper has so many bits
  channel.give(0.0, reply(measured(0, 0)));
  channel.give(0.015, {shifted.begin(), shifted.end() - 1});
  channel.give(0.017, {shifted.back()});
  channel.give(0.03, {});
  channel.give(0.045, reply(measured(7, 0)));
  robot.next();
  robot.next();
  EXPECT_GT(robot.rejected_values(), 0u);
  EXPECT_NEAR(robot.next()->left_travel, 0.007, 1e-15);
}

TEST_F(OiRobotPollingTest, NoticesSilenceAndGoesOnAsking) {
  channel.give(0.0, reply(measured(0, 0)));
  for (int i = 1; i <= 5; ++i) channel.give(i * 0.015, {});
  robot.next();
  channel.take_written();
  EXPECT_FALSE(robot.next());
  EXPECT_EQ(robot.link(), LinkState::Silent);
  EXPECT_THAT(channel.written, ElementsAre(kQuery));
  channel.give(0.2, reply(measured(1, 0)));
  EXPECT_TRUE(robot.next());
}

TEST_F(OiRobotPollingTest, DrivesByRadius) {
  EXPECT_EQ(told({0.2, 0.0}), std::pair(200, -32768));
  EXPECT_EQ(told({-0.2, 0.0}), std::pair(-200, -32768));
  // Wheels of 141 and 259 mm/s; a radius of 400 mm but for their rounding.
  EXPECT_EQ(told({0.2, 0.5}), std::pair(200, 398));
  EXPECT_EQ(told({0.2, -0.5}), std::pair(200, -398));
  EXPECT_EQ(told({-0.2, 0.5}), std::pair(-200, -398));
}

TEST_F(OiRobotPollingTest, SpinsWhereTheRadiusIsNone) {
  EXPECT_EQ(told({0.0, 1.0}), std::pair(118, 1));
  EXPECT_EQ(told({0.0, -1.0}), std::pair(118, -1));
  // Hardly forward: a radius of 1 mm on the wire means a spin, whose velocity is that of the wheels.
  EXPECT_EQ(told({0.002, 1.5}), std::pair(176, 1));
}

TEST_F(OiRobotPollingTest, KeepsTheRateOfTurnForAnyMotion) {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const Motion motion{random.uniform(-0.2, 0.2), random.uniform(-2.0, 2.0)};
    const auto [velocity, radius] = told(motion);
    const double wheels = radius == -32768        ? 0.0
                          : std::abs(radius) == 1 ? radius * velocity / 117.5
                                                  : static_cast<double>(velocity) / radius;
    const double ahead = std::abs(radius) == 1 ? 0.0 : velocity * 1e-3;
    // The radius is whole and at most 2 m, the velocity whole.
    EXPECT_NEAR(wheels, motion.angular, 0.02 + 0.5 / std::abs(radius) + (std::abs(radius) == 2000 ? 0.1 : 0.0));
    EXPECT_NEAR(ahead, motion.linear, 0.004);
  }
}

}  // namespace
}  // namespace scrubjay
