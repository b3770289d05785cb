/// \file
/// A serial robot that falls silent, and comes back or not.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "modem_lines.hpp"
#include "serial_robot_fixture.hpp"

namespace scrubjay {
namespace {

TEST_F(SerialRobotTest, GoesOnWithARobotThatWasSilentForAWhile) {
  FakeRobot fake(port());
  SerialRobot robot(address(), {}, stop_.get_token(), params_);
  double way = drive(robot, 20);
  fake.fall_silent();
  std::jthread healer([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(400));
    fake.speak_again();
  });
  way += drive(robot, 20);
  const LinkReport report = robot.report();
  EXPECT_GE(report.silences, 1u);
  EXPECT_EQ(report.reconnections, report.silences);
  EXPECT_GE(report.longest_silence, 0.3);
  EXPECT_GE(report.lost_frames, 15u);
  // It couldn't be told to stand; its encoders tell the way of the silence.
  EXPECT_NEAR(way, fake.rolled(), 0.03);
}

TEST_F(SerialRobotTest, LeavesARobotThatDocksAloneThroughASilence) {
  FakeRobot fake(port());
  SerialRobot robot(address(), {}, stop_.get_token(), params_);
  drive(robot, 20);
  EXPECT_TRUE(robot.order(oi::SeekDock{}));
  drive(robot, 20, 0.0);
  ASSERT_EQ(fake.mode(), oi::OiMode::Passive);
  const std::uint64_t silences = robot.report().silences;
  std::jthread unplugged([&] {
    fake.fall_silent();
    std::this_thread::sleep_for(std::chrono::milliseconds(150));
    fake.speak_again();
  });
  for (int i = 0; i < 200 && robot.report().silences == silences; ++i) drive(robot, 1, 0.0);
  drive(robot, 40, 0.0);
  EXPECT_GT(robot.report().silences, silences);
  EXPECT_EQ(fake.mode(), oi::OiMode::Passive) << "Safe would have ended its docking";
}

TEST_F(SerialRobotTest, SendsARobotThatWasStartedAnewToItsDockAgain) {
  FakeRobot fake(port());
  SerialRobot robot(address(), {}, stop_.get_token(), params_);
  drive(robot, 5);
  EXPECT_TRUE(robot.order(oi::SeekDock{}));
  drive(robot, 5, 0.0);
  fake.start_anew();
  drive(robot, 40, 0.0);
  EXPECT_EQ(fake.mode(), oi::OiMode::Passive);
}

TEST_F(SerialRobotTest, TellsASilentRobotToStand) {
  FakeRobot fake(port());
  SerialRobot robot(address(), {}, stop_.get_token(), params_);
  drive(robot, 20);
  fake.go_away();
  std::jthread healer([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    fake.come_back();
  });
  ASSERT_TRUE(robot.next());  // with the device opened anew
  EXPECT_TRUE(fake.stands());
  EXPECT_GE(robot.report().reconnections, 1u);
}

TEST_F(SerialRobotTest, WakesARobotThatFellAsleepOnTheWay) {
  FakeRobot fake(port());
  const ModemLines lines([&] { fake.pulse_brc(); });
  SerialRobot robot(address(), {}, stop_.get_token(), params_);
  drive(robot, 10);
  const int before = lines.pulses();
  fake.hear_power();
  EXPECT_GT(drive(robot, 30), 0.0);
  EXPECT_EQ(fake.mode(), oi::OiMode::Safe);
  EXPECT_GT(lines.pulses(), before);
}

TEST_F(SerialRobotTest, PullsTheWakeLineOnceASilence) {
  FakeRobot fake(port());
  const ModemLines lines([] {});
  SerialRobot robot(address(), {}, stop_.get_token(), params_);
  for (int silence = 0; silence < 2; ++silence) {
    drive(robot, 5);
    fake.fall_silent();
    const int before = lines.pulses();
    std::atomic<bool> is_over = false;
    std::jthread healer([&] {
      EXPECT_TRUE(soon([&] { return lines.pulses() > before; }));
      std::this_thread::sleep_for(std::chrono::milliseconds(500));  // for more attempts
      is_over = true;
      fake.speak_again();
    });
    while (!is_over) ASSERT_TRUE(robot.next());
    EXPECT_EQ(lines.pulses(), before + 1);
  }
}

TEST_F(SerialRobotTest, LeavesTheWakeLineAloneWhereItOnlyListens) {
  params_.session = OiRobot::Session::Listen;
  params_.give_up = 0.5;
  FakeRobot fake(port());
  const ModemLines lines([] {});
  SerialRobot robot(address(), {}, stop_.get_token(), params_);
  ASSERT_TRUE(robot.next());
  fake.fall_silent();
  while (robot.next()) {
  }
  EXPECT_EQ(lines.pulses(), 0);
}

TEST_F(SerialRobotTest, CountsNoJumpOfARobotThatWasStartedAnew) {
  for (const std::uint16_t first : {std::uint16_t{0}, std::uint16_t{40000}}) {
    FakeRobot fake(port(), {.firmware = {.quirks = {.sign_from_command = false}, .encoder_start = first}});
    SerialRobot robot(address(), {}, stop_.get_token(), params_);
    const double before = drive(robot, 60, 0.5);
    EXPECT_GT(before, 0.2);
    fake.go_away();
    fake.start_anew();
    std::jthread healer([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(2300));
      fake.come_back();
    });
    const auto frame = robot.next();
    ASSERT_TRUE(frame);
    EXPECT_NEAR(frame->left_travel, 0.0, 0.05);
    EXPECT_GT(drive(robot, 20), 0.0);
  }
}

TEST_F(SerialRobotTest, IsGoneWhenNoFrameComesForLong) {
  params_.give_up = 0.3;
  FakeRobot fake(port());
  SerialRobot robot(address(), {}, stop_.get_token(), params_);
  drive(robot, 3);
  fake.fall_silent();
  while (robot.next()) {
  }
  EXPECT_EQ(robot.report().silences, robot.report().reconnections + 1);
}

TEST_F(SerialRobotTest, WaitsForNoSilentRobotWhenAskedToStop) {
  FakeRobot fake(port());
  SerialRobot robot(address(), {}, stop_.get_token(), params_);
  drive(robot, 3);
  fake.fall_silent();
  stop_.request_stop();
  while (robot.next()) {
  }
  EXPECT_EQ(robot.report().silences, robot.report().reconnections + 1);
}

TEST_F(SerialRobotTest, AsksWhetherToWaitForASilentRobot) {
  FakeRobot fake(port());
  SerialRobot robot(address(), {}, stop_.get_token(), params_);
  drive(robot, 5);
  std::vector<double> silences;
  robot.while_silent([&](double silence) {
    silences.push_back(silence);
    return silences.size() < 5;
  });
  fake.fall_silent();
  while (robot.next()) {
  }
  ASSERT_EQ(silences.size(), 5U);
  EXPECT_GE(silences.front(), OiRobot::kSilence);
  EXPECT_TRUE(std::ranges::is_sorted(silences));
  fake.speak_again();
  robot.while_silent(nullptr);
  EXPECT_TRUE(robot.next());
}

TEST(SilenceTest, IsNoticedWithinATenthOfASecondEvenByAReadThatBeganJustBefore) {
  const double longest_read = std::chrono::duration<double>(SerialPort::kWait).count();
  EXPECT_LE(OiRobot::kSilence + longest_read, 0.0951);  // 5 ms are left to the scheduler
}

}  // namespace
}  // namespace scrubjay
