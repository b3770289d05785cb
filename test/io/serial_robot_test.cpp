#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <scrubjay/oi/all_packets.hpp>

#include "serial_robot_fixture.hpp"

namespace scrubjay {
namespace {

using testing::HasSubstr;

TEST_F(SerialRobotTest, FindsARobotAndDrivesIt) {
  FakeRobot fake(port());
  SerialRobot robot(address(), {}, stop_.get_token(), params_);
  EXPECT_EQ(robot.model().protocol, oi::Model::Create2);
  const double way = drive(robot, 30);
  EXPECT_GT(way, 0.02);
  EXPECT_GE(robot.report().frames, 30u);
  EXPECT_EQ(fake.mode(), oi::OiMode::Safe);
}

TEST_F(SerialRobotTest, FindsTheDialectByItself) {
  for (const oi::Model protocol : {oi::Model::Create1, oi::Model::Roomba400}) {
    FakeRobot fake(port(), {.protocol = protocol});
    params_.body = [](oi::Model found) {
      RobotModel model;
      model.radius = found == oi::Model::Roomba400 ? 0.4 : 0.1;
      return model;
    };
    SerialRobot robot(address(), {}, stop_.get_token(), params_);
    EXPECT_EQ(robot.model().protocol, protocol);
    EXPECT_EQ(robot.model().radius, protocol == oi::Model::Roomba400 ? 0.4 : 0.1);
    EXPECT_FALSE(robot.model().has_light_sensors);
    EXPECT_TRUE(robot.next());
  }
}

TEST_F(SerialRobotTest, SaysWhenAnotherRobotThanTheExpectedOneAnswers) {
  FakeRobot fake(port(), {.protocol = oi::Model::Create1});
  SerialRobot robot(address(), RobotModel{}, stop_.get_token(), params_);
  EXPECT_EQ(robot.model().protocol, oi::Model::Create1);
  EXPECT_THAT(robot.remarks(), testing::Contains("the robot speaks as a Create 1, not as a Create 2"));
}

TEST_F(SerialRobotTest, FindsTheRateByItself) {
  FakeRobot fake(port(), {.rate = 57600});
  SerialRobot robot(address(), {}, stop_.get_token(), params_);
  EXPECT_THAT(robot.remarks(), testing::Contains("the robot answers at 57600 baud, not at 115200"));
  EXPECT_TRUE(robot.next());
}

TEST_F(SerialRobotTest, NoticesARobotThatReportsItsModeOneTooHigh) {
  FakeRobot fake(port(), {.firmware = {.quirks = {.mode_one_too_high = true, .sign_from_command = false}}});
  SerialRobot robot(address(), {}, stop_.get_token(), params_);
  drive(robot, 10);
  EXPECT_EQ(robot.next()->mode, oi::OiMode::Safe);
  EXPECT_EQ(fake.mode(), oi::OiMode::Safe);
}

TEST_F(SerialRobotTest, SaysWhatToTryWhereNoRobotAnswers) {
  FakeRobot fake(port());
  fake.fall_silent();
  const std::string message = message_of([&] { SerialRobot(address(), {}, stop_.get_token(), params_); });
  EXPECT_THAT(message, HasSubstr("port: no robot answers at 115200, 57600 or 19200 baud"));
  EXPECT_THAT(message, HasSubstr("press its Clean button"));
}

TEST_F(SerialRobotTest, ShowsTheFirstBytesOfSomethingThatIsNoRobot) {
  FakeRobot fake(port(), {.chatter = "$GPGGA,1"});
  const std::string message = message_of([&] { SerialRobot(address(), {}, stop_.get_token(), params_); });
  EXPECT_THAT(message, HasSubstr("something answers, but no robot"));
  EXPECT_THAT(message, HasSubstr("24 47 50 47 47 41 2C 31"));
}

TEST_F(SerialRobotTest, GivesUpLookingWhenAskedToStop) {
  FakeRobot fake(port());
  fake.fall_silent();
  stop_.request_stop();
  EXPECT_THAT(message_of([&] { SerialRobot(address(), {}, stop_.get_token(), params_); }), HasSubstr("stopped"));
}

TEST_F(SerialRobotTest, LeavesARobotThatStandsAndMayCharge) {
  FakeRobot fake(port());
  {
    SerialRobot robot(address(), {}, stop_.get_token(), params_);
    drive(robot, 10);
    EXPECT_FALSE(fake.stands());
  }
  EXPECT_TRUE(fake.stands());
  EXPECT_EQ(fake.mode(), oi::OiMode::Passive);
  const std::uint64_t before = fake.frames_sent();
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  EXPECT_LE(fake.frames_sent(), before + 1);  // the stream has ended
}

TEST_F(SerialRobotTest, BeginsAnewAfterAStop) {
  FakeRobot fake(port());
  SerialRobot robot(address(), {}, stop_.get_token(), params_);
  drive(robot, 5);
  robot.stop();
  EXPECT_TRUE(fake.stands());
  EXPECT_GT(drive(robot, 20), 0.0);
  EXPECT_EQ(fake.mode(), oi::OiMode::Safe);
}

TEST_F(SerialRobotTest, StopsAMotionThatNobodyRenews) {
  FakeRobot fake(port());
  SerialRobot robot(address(), {}, stop_.get_token(), params_);
  drive(robot, 5);
  ASSERT_TRUE(soon([&] { return !fake.stands(); }));
  EXPECT_TRUE(soon([&] { return fake.stands(); }));
  EXPECT_EQ(robot.report().watchdog_stops, 1u);
  drive(robot, 5);  // whoever drives again moves it again
  EXPECT_TRUE(soon([&] {
    drive(robot, 1);
    return !fake.stands();
  }));
}

TEST_F(SerialRobotTest, LetsAMotionBeThatIsRenewed) {
  params_.renewal = 1.0;  // for a loaded machine
  FakeRobot fake(port());
  SerialRobot robot(address(), {}, stop_.get_token(), params_);
  drive(robot, 120);
  EXPECT_EQ(robot.report().watchdog_stops, 0u);
}

TEST_F(SerialRobotTest, OnlyListensWhereItIsToldTo) {
  params_.session = OiRobot::Session::Listen;
  FakeRobot fake(port());
  SerialRobot robot(address(), {}, stop_.get_token(), params_);
  drive(robot, 10);
  EXPECT_EQ(fake.mode(), oi::OiMode::Passive);
  EXPECT_TRUE(fake.stands());
}

TEST_F(SerialRobotTest, ListensToARobotOfAnyDialectInTheModeThatItHas) {
  params_.session = OiRobot::Session::Listen;
  params_.connect_timeout = 20.0;  // for a loaded machine
  for (const oi::Model protocol : oi::kRichestFirst) {
    FakeRobot fake(port(), {.protocol = protocol});
    fake.hear(oi::Start{});
    fake.hear(oi::Control{});
    fake.hear(oi::Drive{oi::Velocity(100), oi::Radius::straight()});
    {
      SerialRobot robot(address(), {}, stop_.get_token(), params_);
      EXPECT_EQ(robot.model().protocol, protocol);
      for (int i = 0; i < 5; ++i) EXPECT_TRUE(robot.next());
      robot.stop();
      EXPECT_TRUE(robot.next());
    }
    EXPECT_EQ(fake.mode(), oi::OiMode::Safe);
    EXPECT_FALSE(fake.stands());
  }
}

TEST_F(SerialRobotTest, SendsNothingToARobotThatStreamsAlready) {
  params_.session = OiRobot::Session::Listen;
  params_.connect_timeout = 20.0;
  FakeRobot fake(port());
  fake.hear(oi::Start{});
  fake.hear(oi::Full{});
  fake.hear(oi::stream_of_all(oi::Model::Create2));
  {
    SerialRobot robot(address(), {}, stop_.get_token(), params_);
    robot.record(std::make_unique<RecordingWriter>(folder_ / "run.oilog", ""));
    for (int i = 0; i < 5; ++i) EXPECT_TRUE(robot.next());
    robot.stop();
    robot.close_recording();
  }
  EXPECT_EQ(fake.heard(), 0U);
  EXPECT_EQ(fake.mode(), oi::OiMode::Full);
  const std::uint64_t before = fake.frames_sent();
  EXPECT_TRUE(soon([&] { return fake.frames_sent() > before + 2; })) << "the stream has ended";
}

TEST_F(SerialRobotTest, StartsAnewNoRobotThatItListensTo) {
  params_.session = OiRobot::Session::Listen;
  params_.connect_timeout = 20.0;
  FakeRobot fake(port());
  fake.hear(oi::Start{});
  fake.hear(oi::Safe{});
  SerialRobot robot(address(), {}, stop_.get_token(), params_);
  ASSERT_TRUE(robot.next());
  fake.hear(oi::PauseResumeStream{oi::Bounded<0, 1>(0)});
  while (robot.report().reconnections == 0) ASSERT_TRUE(robot.next());
  EXPECT_EQ(fake.mode(), oi::OiMode::Safe);
}

TEST_F(SerialRobotTest, RecordsASessionThatReplaysToTheSameFrames) {
  FakeRobot fake(port());
  std::vector<Frame> live;
  {
    SerialRobot robot(address(), {}, stop_.get_token(), params_);
    robot.record(std::make_unique<RecordingWriter>(folder_ / "run.oilog", ""));
    for (int i = 0; i < 30; ++i) {
      live.push_back(robot.next().value());
      robot.drive({0.2, 0.5});
    }
    robot.close_recording();
  }
  RecordingReader reader(folder_ / "run.oilog");
  RecordedChannel channel(reader);
  OiRobot replayed(channel, {});
  for (const Frame& frame : live) {
    const auto again = replayed.next();
    ASSERT_TRUE(again);
    EXPECT_EQ(again->stamp, frame.stamp);
    EXPECT_EQ(again->left_travel, frame.left_travel);
    replayed.drive({0.2, 0.5});
  }
}

}  // namespace
}  // namespace scrubjay
