#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <scrubjay/robot/oi_robot.hpp>

#include "scripted_channel.hpp"

namespace scrubjay {
namespace {

using oi::PacketId;
using testing::ElementsAre;

RobotModel model_of(oi::Model protocol) {
  RobotModel model;
  model.protocol = protocol;
  return model;
}

/// All frames until the robot gives none.
std::vector<Frame> frames_of(OiRobot& robot) {
  std::vector<Frame> frames;
  while (const auto frame = robot.next()) frames.push_back(*frame);
  return frames;
}

TEST(OiRobotTest, WakesTheRobotTakesControlAndStartsTheStream) {
  ScriptedChannel channel;
  const OiRobot robot(channel, {});
  EXPECT_THAT(channel.written, ElementsAre(Bytes{128}, Bytes{131}, Bytes{148, 1, 100}));
}

TEST(OiRobotTest, AsksACreate1ForTheGroupThatItHas) {
  ScriptedChannel channel;
  const OiRobot robot(channel, model_of(oi::Model::Create1));
  EXPECT_THAT(channel.written, ElementsAre(Bytes{128}, Bytes{131}, Bytes{148, 1, 6}));
}

TEST(OiRobotTest, FillsAFrameFromAllSensors) {
  oi::Sensors s = at_rest();
  s.set(PacketId::BumpsAndWheelDrops, 0b0110);  // bump left, wheel drop right
  s.set(PacketId::Wall, 1);
  s.set(PacketId::CliffFrontLeft, 1);
  s.set(PacketId::CliffRight, 1);
  s.set(PacketId::VirtualWall, 1);
  s.set(PacketId::DirtDetect, 77);
  s.set(PacketId::InfraredCharacterOmni, 161);
  s.set(PacketId::InfraredCharacterLeft, 164);
  s.set(PacketId::InfraredCharacterRight, 168);
  s.set(PacketId::ChargingState, 2);
  s.set(PacketId::Voltage, 14500);
  s.set(PacketId::Current, -1250);
  s.set(PacketId::Temperature, -5);
  s.set(PacketId::BatteryCharge, 1200);
  s.set(PacketId::BatteryCapacity, 2696);
  s.set(PacketId::WallSignal, 900);
  s.set(PacketId::LightBumper, 0b100001);
  for (int i = 0; i < kLightSensorCount; ++i) {
    s.set(static_cast<PacketId>(number(PacketId::LightBumpLeftSignal) + i), 100 * (i + 1));
  }
  ScriptedChannel channel;
  channel.give(3.5, stream_frame(s));
  OiRobot robot(channel, {});
  const auto frame = robot.next();
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->stamp, 3.5);
  EXPECT_TRUE(frame->bump_left);
  EXPECT_FALSE(frame->bump_right);
  EXPECT_FALSE(frame->wheel_drop_left);
  EXPECT_TRUE(frame->wheel_drop_right);
  EXPECT_TRUE(frame->wall);
  EXPECT_EQ(frame->cliff_flags, 0b1010);
  EXPECT_TRUE(frame->virtual_wall);
  EXPECT_EQ(frame->dirt, 77);
  EXPECT_EQ(frame->infrared_omni, 161);
  EXPECT_EQ(frame->infrared_left, 164);
  EXPECT_EQ(frame->infrared_right, 168);
  EXPECT_EQ(frame->wall_signal, 900);
  EXPECT_TRUE(frame->sees(LightSensor::Left) && frame->sees(LightSensor::Right));
  EXPECT_THAT(frame->light_signal, ElementsAre(100, 200, 300, 400, 500, 600));
  EXPECT_EQ(frame->mode, oi::OiMode::Safe);
  EXPECT_TRUE(frame->battery.charging);
  EXPECT_DOUBLE_EQ(frame->battery.voltage, 14.5);
  EXPECT_DOUBLE_EQ(frame->battery.current, -1.25);
  EXPECT_DOUBLE_EQ(frame->battery.charge, 1.2);
  EXPECT_DOUBLE_EQ(frame->battery.capacity, 2.696);
  EXPECT_DOUBLE_EQ(frame->battery.temperature, -5.0);
}

TEST(OiRobotTest, ReadsNoInfraredCharacterAsZeroOnACreate1) {
  oi::Sensors s = at_rest();
  s.set(PacketId::InfraredCharacterOmni, 255);
  ScriptedChannel channel;
  channel.give(0.0, stream_frame(s, oi::Model::Create1));
  OiRobot robot(channel, model_of(oi::Model::Create1));
  EXPECT_EQ(robot.next()->infrared_omni, 0);
}

TEST(OiRobotTest, GivesAllFramesOfOneRead) {
  ScriptedChannel channel;
  channel.give(0.0, stream_frame(counted(0, 0)) + stream_frame(counted(10, 20)) + stream_frame(counted(25, 30)));
  OiRobot robot(channel, {});
  const auto frames = frames_of(robot);
  ASSERT_EQ(frames.size(), 3u);
  const double per_count = DifferentialDrive{}.metres_per_count();
  EXPECT_DOUBLE_EQ(frames[1].left_travel, 10 * per_count);
  EXPECT_DOUBLE_EQ(frames[2].left_travel, 15 * per_count);
  EXPECT_DOUBLE_EQ(frames[2].right_travel, 10 * per_count);
}

TEST(OiRobotTest, GivesEveryFrameOfAReadThatFillsTheBuffer) {
  Bytes burst;
  for (int i = 0; i < 40; ++i) burst = burst + stream_frame(counted(i, i));
  ScriptedChannel channel;
  channel.give(0.0, burst);
  OiRobot robot(channel, {});
  EXPECT_EQ(frames_of(robot).size(), 40u);
}

TEST(OiRobotTest, PutsAFrameTogetherFromReadsOfOneByte) {
  ScriptedChannel channel;
  double stamp = 0.0;
  for (int i = 0; i < 3; ++i) {
    for (const std::uint8_t byte : stream_frame(counted(10 * i, 10 * i))) channel.give(stamp += 1e-4, {byte});
  }
  OiRobot robot(channel, {});
  const auto frames = frames_of(robot);
  ASSERT_EQ(frames.size(), 3u);
  EXPECT_NEAR(frames[2].stamp, stamp, 1e-12);  // it arrives with its last byte
  EXPECT_EQ(robot.counters().lost, 0u);
}

TEST(OiRobotTest, LosesNothingToAStrayHeaderBeforeAFrame) {
  ScriptedChannel channel;
  channel.give(0.0, Bytes{19} + stream_frame(counted(0, 0)));
  channel.give(kTick, Bytes{19, 81, 19} + stream_frame(counted(5, 5)));
  channel.give(2 * kTick, {19});
  channel.give(3 * kTick, stream_frame(counted(10, 10)));
  OiRobot robot(channel, {});
  EXPECT_EQ(frames_of(robot).size(), 3u);
  EXPECT_EQ(robot.counters().frames, 3u);
  EXPECT_EQ(robot.counters().skipped, 5u);
}

TEST(OiRobotTest, ADroppedByteCostsItsOwnFrameOnly) {
  const Bytes good = stream_frame(counted(300, 300));
  for (std::size_t dropped = 0; dropped < good.size(); ++dropped) {
    Bytes cut = good;
    cut.erase(cut.begin() + static_cast<std::ptrdiff_t>(dropped));
    ScriptedChannel channel;
    channel.give(0.0, stream_frame(counted(290, 290)));
    channel.give(kTick, cut);
    channel.give(2 * kTick, stream_frame(counted(310, 310)));
    OiRobot robot(channel, {});
    const auto frames = frames_of(robot);
    ASSERT_EQ(frames.size(), 2u) << "byte " << dropped;
    // The way of the lost tick isn't lost.
    EXPECT_DOUBLE_EQ(frames[1].left_travel, 20 * DifferentialDrive{}.metres_per_count());
  }
}

TEST(OiRobotTest, IgnoresFramesOfAnotherLengthAndCountsThem) {
  const oi::SensorId ids[] = {7, 43, 44};
  Bytes other(oi::kMaxStreamFrame);
  oi::Sensors bumped = counted(9999, 9999);
  bumped.set(PacketId::BumpsAndWheelDrops, 3);
  other.resize(oi::encode_stream_frame(ids, bumped, oi::Model::Create2, other));
  ScriptedChannel channel;
  channel.give(0.0, stream_frame(counted(0, 0)));
  channel.give(kTick, other + stream_frame(counted(10, 10)));
  OiRobot robot(channel, {});
  const auto frames = frames_of(robot);
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_FALSE(frames[1].bumped());
  EXPECT_EQ(robot.counters().other_length, 1u);
  EXPECT_EQ(robot.sensors()[PacketId::LeftEncoderCounts], 10);
}

TEST(OiRobotTest, DoesntStoreAValueOutOfRange) {
  oi::Sensors s = at_rest();
  s.set(PacketId::LightBumpLeftSignal, 1200);
  s.set(PacketId::BumpsAndWheelDrops, 1);
  ScriptedChannel channel;
  channel.give(0.0, stream_frame(s));
  s.set(PacketId::LightBumpLeftSignal, 60000);
  s.set(PacketId::BumpsAndWheelDrops, 0xF2);
  s.set(PacketId::OiMode, 200);
  channel.give(kTick, stream_frame(s));
  OiRobot robot(channel, {});
  const auto frames = frames_of(robot);
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_EQ(frames[1].light_signal[0], 1200);
  EXPECT_TRUE(frames[1].bump_right);
  EXPECT_FALSE(frames[1].bump_left);
  EXPECT_EQ(frames[1].mode, oi::OiMode::Safe);
  EXPECT_EQ(robot.sensors()[PacketId::LightBumpLeftSignal], 1200);
  EXPECT_EQ(robot.rejected_values(), 3u);
}

TEST(OiRobotTest, NoticesSilenceWithinATenthOfASecond) {
  ScriptedChannel channel;
  channel.give(10.0, stream_frame(at_rest()));
  for (int i = 1; i <= 11; ++i) channel.give(10.0 + i * 0.01, {});  // a closed channel behind them
  OiRobot robot(channel, {});
  ASSERT_TRUE(robot.next());
  EXPECT_EQ(robot.link(), LinkState::Alive);
  EXPECT_FALSE(robot.next());
  EXPECT_EQ(robot.link(), LinkState::Silent);
}

TEST(OiRobotTest, NoticesSilenceWithinATenthOfASecondByReadsThatTakeALittleLonger) {
  for (const double first : {0.005, 0.010, 0.0155, 0.0202}) {
    ScriptedChannel channel;
    channel.give(10.0, stream_frame(at_rest()));
    for (int i = 0; i < 6; ++i) channel.give(10.0 + first + i * 0.0202, {});  // as SerialPort does, and its calls
    OiRobot robot(channel, {});
    ASSERT_TRUE(robot.next());
    EXPECT_FALSE(robot.next());
    EXPECT_EQ(robot.link(), LinkState::Silent);
    EXPECT_LT(robot.stamp(), 10.096) << first;
  }
}

TEST(OiRobotTest, CallsARobotSilentNeitherTooEarlyNorTooLate) {
  for (const double gap : {0.05, 0.09, 0.11, 0.5}) {
    ScriptedChannel channel;
    channel.give(10.0, stream_frame(at_rest()));
    channel.give(10.0 + gap, {});
    channel.give(10.0 + gap, stream_frame(at_rest()));
    OiRobot robot(channel, {});
    ASSERT_TRUE(robot.next());
    EXPECT_EQ(robot.next().has_value(), gap < OiRobot::kSilence) << gap << " s";
    EXPECT_EQ(robot.link(), gap < OiRobot::kSilence ? LinkState::Alive : LinkState::Silent) << gap << " s";
  }
}

TEST(OiRobotTest, CallsARobotSilentThatSendsNoiseOnly) {
  ScriptedChannel channel;
  channel.give(0.0, stream_frame(at_rest()));
  for (int i = 1; i <= 20; ++i) channel.give(i * 0.015, Bytes(84, 0x55));
  OiRobot robot(channel, {});
  ASSERT_TRUE(robot.next());
  EXPECT_FALSE(robot.next());
  EXPECT_EQ(robot.link(), LinkState::Silent);
}

TEST(OiRobotTest, CallsARobotSilentThatNeverSaidAnything) {
  ScriptedChannel channel;
  for (int i = 0; i <= 20; ++i) channel.give(100.0 + i * 0.015, {});
  OiRobot robot(channel, {});
  EXPECT_FALSE(robot.next());
  EXPECT_EQ(robot.link(), LinkState::Silent);
}

TEST(OiRobotTest, IsAliveAgainWhenTheRobotSpeaksAgain) {
  ScriptedChannel channel;
  channel.give(0.0, stream_frame(at_rest()));
  channel.give(0.2, {});
  channel.give(0.4, stream_frame(at_rest()));
  OiRobot robot(channel, {});
  ASSERT_TRUE(robot.next());
  ASSERT_FALSE(robot.next());
  EXPECT_EQ(robot.link(), LinkState::Silent);
  EXPECT_TRUE(robot.next());
  EXPECT_EQ(robot.link(), LinkState::Alive);
}

TEST(OiRobotTest, TellsAClosedChannelFromASilentRobot) {
  ScriptedChannel channel;
  channel.give(0.0, stream_frame(at_rest()));
  channel.end_stamp = 60.0;
  OiRobot robot(channel, {});
  ASSERT_TRUE(robot.next());
  EXPECT_FALSE(robot.next());
  EXPECT_EQ(robot.link(), LinkState::Closed);
}

TEST(OiRobotTest, NoticesAChannelThatTakesNoBytes) {
  ScriptedChannel channel;
  channel.give(0.0, {});
  OiRobot robot(channel, {});
  channel.writable = false;
  robot.drive({0.2, 0.0});
  EXPECT_EQ(robot.link(), LinkState::Closed);
  EXPECT_FALSE(robot.next());
}

}  // namespace
}  // namespace scrubjay
