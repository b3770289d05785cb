#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <scrubjay/oi/command.hpp>
#include <scrubjay/robot/calibrated_robot.hpp>
#include <scrubjay/robot/oi_robot.hpp>

#include "scripted_channel.hpp"

namespace scrubjay {
namespace {

using oi::PacketId;
using testing::AllOf;
using testing::AnyOf;
using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;

const Bytes kSeekDock{143};
const Bytes kStream{148, 1, 100};
const Bytes kForward{145, 0, 100, 0, 100};
const Bytes kStand{145, 0, 0, 0, 0};
constexpr int kPassiveMode = 1;
constexpr int kSafeMode = 2;

/// A robot in a session that has begun.
class OiRobotOrderTest : public testing::Test {
 protected:
  OiRobotOrderTest() { channel.take_written(); }

  /// The next frame, a tick later.
  void next(int mode) {
    stamp_ += 0.015;
    oi::Sensors sensors = at_rest();
    sensors.set(PacketId::OiMode, mode);
    channel.give(stamp_, stream_frame(sensors));
    ASSERT_TRUE(robot.next().has_value());
  }
  /// What is written in so many ticks in which `motion` is wanted.
  std::vector<Bytes> written_in(int ticks, int mode, const Motion& motion) {
    channel.take_written();
    for (int i = 0; i < ticks; ++i) {
      next(mode);
      robot.drive(motion);
    }
    return channel.take_written();
  }

  /// Says nothing until the robot counts as silent.
  void fall_silent() {
    for (int i = 0; i < 10; ++i) {
      stamp_ += 0.02;
      channel.give(stamp_, {});
      EXPECT_FALSE(robot.poll());
    }
    ASSERT_EQ(robot.link(), LinkState::Silent);
  }

  ScriptedChannel channel;
  OiRobot robot{channel, {}};

 private:
  double stamp_ = 1.0;
};

TEST_F(OiRobotOrderTest, SaysASongAndPlaysIt) {
  oi::Song song;
  song.slot = 2;
  song.notes = {{60, 32}, {67, 64}};
  EXPECT_TRUE(robot.order(song));
  EXPECT_TRUE(robot.order(oi::Play{2}));
  EXPECT_THAT(channel.written, ElementsAre(Bytes{140, 2, 2, 60, 32, 67, 64}, Bytes{141, 2}));
}

TEST_F(OiRobotOrderTest, TurnsOnLightsWhileItDrives) {
  written_in(10, kSafeMode, {0.1, 0.0});
  EXPECT_TRUE(robot.order(oi::Leds{oi::Leds::kDock, 128, 255}));
  EXPECT_THAT(channel.take_written(), ElementsAre(Bytes{139, 4, 128, 255}));
  EXPECT_THAT(written_in(10, kSafeMode, {0.1, 0.0}), Contains(kForward)) << "and drives on";
}

TEST_F(OiRobotOrderTest, ALightOrASongLeavesTheModeToBeKept) {
  robot.order(oi::Leds{});
  robot.order(oi::Play{0});
  EXPECT_THAT(written_in(40, kPassiveMode, {}), Contains(kSafe));
}

TEST_F(OiRobotOrderTest, IsLeftAloneOnItsWayToTheDock) {
  written_in(10, kSafeMode, {0.1, 0.0});
  EXPECT_TRUE(robot.order(oi::SeekDock{}));
  EXPECT_THAT(channel.take_written(), ElementsAre(kSeekDock));
  EXPECT_THAT(written_in(200, kPassiveMode, {}), IsEmpty()) << "neither Safe nor a motion of none";
}

TEST_F(OiRobotOrderTest, IsLeftAloneWhileItCleans) {
  for (const oi::Command& command : {oi::Command(oi::Clean{}), oi::Command(oi::Spot{}), oi::Command(oi::Max{})}) {
    EXPECT_TRUE(robot.order(command));
    EXPECT_THAT(written_in(50, kPassiveMode, {}), IsEmpty());
  }
}

TEST_F(OiRobotOrderTest, AMotionTakesControlBackFromTheDocking) {
  robot.order(oi::SeekDock{});
  written_in(50, kPassiveMode, {});
  EXPECT_THAT(written_in(50, kPassiveMode, {0.1, 0.0}), Contains(kSafe));
  EXPECT_THAT(written_in(5, kSafeMode, {0.1, 0.0}), Contains(kForward));
  EXPECT_THAT(written_in(5, kSafeMode, {}), Contains(kStand)) << "to stand is a motion again";
}

TEST_F(OiRobotOrderTest, SafeTakesControlBackFromTheDocking) {
  robot.order(oi::SeekDock{});
  written_in(50, kPassiveMode, {});
  EXPECT_TRUE(robot.order(oi::Safe{}));
  EXPECT_THAT(channel.take_written(), ElementsAre(kSafe));
  // Lost on the way, it is said again.
  EXPECT_THAT(written_in(50, kPassiveMode, {}), Contains(kSafe));
}

TEST_F(OiRobotOrderTest, SongsDoNotEndTheDocking) {
  robot.order(oi::SeekDock{});
  robot.order(oi::Play{0});
  EXPECT_THAT(written_in(50, kPassiveMode, {}), IsEmpty());
}

TEST_F(OiRobotOrderTest, OneThatDocksIsNotToldToStandWhenItFallsSilent) {
  robot.order(oi::SeekDock{});
  written_in(10, kPassiveMode, {});
  fall_silent();
  EXPECT_THAT(channel.written, IsEmpty());
}

TEST_F(OiRobotOrderTest, AShortSilenceDoesNotEndTheDocking) {
  robot.order(oi::SeekDock{});
  for (int silence = 0; silence < 3; ++silence) {
    written_in(10, kPassiveMode, {});
    fall_silent();
    robot.restart();
    const std::vector<Bytes> written = channel.take_written();
    EXPECT_THAT(written, Contains(kStream));
    EXPECT_THAT(written, Not(Contains(AnyOf(kStart, kSafe, kSeekDock))));
  }
  EXPECT_THAT(written_in(100, kPassiveMode, {}), IsEmpty());
}

TEST_F(OiRobotOrderTest, IsOrderedAgainWhereItMayHaveBeenStartedAnew) {
  robot.order(oi::SeekDock{});
  written_in(10, kPassiveMode, {});
  fall_silent();
  robot.restart();
  channel.take_written();
  robot.restart();
  std::vector<Bytes> written = channel.take_written();
  std::erase_if(written, [](const Bytes& bytes) { return bytes.front() == 0; });
  EXPECT_THAT(written, ElementsAre(kStart, kSeekDock, kStream));
  EXPECT_THAT(written_in(100, kPassiveMode, {}), IsEmpty());
}

TEST_F(OiRobotOrderTest, AMotionBehindTheDockingIsTakenUpAfterASilence) {
  robot.order(oi::SeekDock{});
  written_in(10, kPassiveMode, {});
  written_in(50, kSafeMode, {0.1, 0.0});
  fall_silent();
  channel.take_written();
  robot.restart();
  EXPECT_THAT(channel.written, AllOf(Contains(kSafe), Not(Contains(kSeekDock))));
}

TEST_F(OiRobotOrderTest, IsToldAgainToDockIfItStaysUnderControl) {
  written_in(10, kSafeMode, {0.1, 0.0});
  robot.order(oi::SeekDock{});
  EXPECT_THAT(written_in(15, kSafeMode, {}), IsEmpty()) << "it may need a moment";
  EXPECT_THAT(written_in(15, kSafeMode, {}), ElementsAre(kSeekDock));
  EXPECT_THAT(written_in(100, kPassiveMode, {}), IsEmpty());
}

TEST_F(OiRobotOrderTest, StopEndsTheDocking) {
  robot.order(oi::SeekDock{});
  written_in(10, kPassiveMode, {});
  robot.stop();
  EXPECT_THAT(channel.written, Contains(Bytes{128})) << "Start: to Passive, and the robot stands";
}

TEST_F(OiRobotOrderTest, SaysSoWhenTheChannelHasEnded) {
  channel.writable = false;
  EXPECT_FALSE(robot.order(oi::Play{0}));
  EXPECT_EQ(robot.link(), LinkState::Closed);
}

TEST(OiRobotThatListensTest, OrdersNothing) {
  ScriptedChannel channel;
  OiRobot robot(channel, {}, {}, OiRobot::Session::Listen);
  channel.take_written();
  EXPECT_FALSE(robot.order(oi::SeekDock{}));
  EXPECT_FALSE(robot.order(oi::Safe{}));
  EXPECT_FALSE(robot.order(oi::Play{0}));
  EXPECT_THAT(channel.written, IsEmpty());
}

TEST(RobotTest, OneThatIsNoneOfTheOpenInterfaceTakesNoOrders) {
  class Plain final : public Robot {
    std::optional<Frame> next() override { return std::nullopt; }
    void drive(const Motion&) override {}
    void stop() override {}
  };
  Plain plain;
  Robot& robot = plain;
  EXPECT_FALSE(robot.order(oi::SeekDock{}));
}

TEST(CalibratedRobotOrderTest, HandsOnWhatItIsOrderedAndWhatBecameOfIt) {
  ScriptedChannel channel;
  OiRobot robot(channel, {});
  channel.take_written();
  CalibratedRobot calibrated(robot, {1.02, 0.97, 1.1}, DifferentialDrive{});
  EXPECT_TRUE(calibrated.order(oi::Play{1}));
  EXPECT_THAT(channel.written, ElementsAre(Bytes{141, 1}));
  channel.writable = false;
  EXPECT_FALSE(calibrated.order(oi::Play{1}));
}

}  // namespace
}  // namespace scrubjay
