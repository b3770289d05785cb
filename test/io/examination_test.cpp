#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <io/examined_roomba.hpp>
#include <scrubjay/io/examination.hpp>
#include <scrubjay/oi/command_decoder.hpp>

namespace scrubjay {
namespace {

using test::ExaminedRoomba;
using test::TalkingChannel;
using test::TouchedChannel;

class ModelTest : public testing::TestWithParam<oi::Model> {};

TEST_P(ModelTest, IsFoundOutByWhatItAnswers) {
  ExaminedRoomba robot(GetParam());
  Examination examination(robot.roomba, robot.clock());
  ASSERT_EQ(examination.find_robot(), Contact::Robot);
  EXPECT_EQ(examination.report().model, GetParam());
  const std::optional<oi::OiMode> mode = examination.report().mode;
  EXPECT_EQ(mode.has_value(), GetParam() != oi::Model::Roomba400);
  EXPECT_EQ(mode.value_or(oi::OiMode::Passive), oi::OiMode::Passive);
}

TEST_P(ModelTest, IsFoundWhileItStreams) {
  if (GetParam() == oi::Model::Roomba400) GTEST_SKIP() << "doesn't stream";
  ExaminedRoomba robot(GetParam());
  robot.roomba.write(encode(oi::Start{}));
  robot.roomba.write(encode(oi::Stream{{7, 25}}));
  Examination examination(robot.roomba, robot.clock());
  EXPECT_EQ(examination.find_robot(), Contact::Robot);
  EXPECT_EQ(examination.report().model, GetParam());
}

TEST_P(ModelTest, TellsAllThatItSensesAndLosesNothingOnAGoodWire) {
  ExaminedRoomba robot(GetParam());
  Examination examination(robot.roomba, robot.clock());
  ASSERT_EQ(examination.find_robot(), Contact::Robot);
  examination.time_replies(20);
  examination.listen(3.0);
  const DoctorReport& report = examination.report();
  EXPECT_EQ(report.replies.answered, 20);
  EXPECT_NEAR(report.replies.median, 0.015, 1e-9);  // the simulated firmware answers with its next tick
  EXPECT_NEAR(report.replies.p95, 0.015, 1e-9);
  EXPECT_NEAR(report.frames.per_second(), 1.0 / 0.015, 0.5);
  EXPECT_NEAR(static_cast<double>(report.frames.frames), 200.0, 2.0);
  EXPECT_EQ(report.frames.missing, 0U);
  EXPECT_EQ(report.frames.damaged, 0U);
  EXPECT_EQ(report.frames.bad_values, 0U);
  EXPECT_NEAR(report.frames.longest_gap, 0.015, 1e-9);
  EXPECT_FALSE(report.link_lost);
  for (const oi::PacketInfo& packet : oi::kPackets) {
    EXPECT_EQ(report.sensors.has(packet.id), packet.exists_on(GetParam())) << packet.name;
  }
}

TEST_P(ModelTest, IsNeverToldToMoveAndIsLeftInPassive) {
  ExaminedRoomba robot(GetParam());
  TouchedChannel wire(robot.roomba);
  {
    Examination examination(wire, robot.clock());
    examination.find_robot();
    examination.read_banner();
    examination.time_replies(10);
    examination.listen(0.5);
    examination.watch(0.5, [](const oi::Sensors&, double) { return true; });
  }
  oi::CommandDecoder decoder(GetParam());
  const auto harmless = [](const oi::Command& command) {
    const oi::Opcode opcode = opcode_of(command);
    return opcode == oi::Opcode::Start || opcode == oi::Opcode::Reset || opcode == oi::Opcode::Sensors ||
           opcode == oi::Opcode::Stream || opcode == oi::Opcode::PauseResumeStream;
  };
  decoder.feed(
      wire.sent, [&](const oi::Command& command) { EXPECT_TRUE(harmless(command)) << int(opcode_of(command)); },
      [](const oi::Rejected&) {});
  EXPECT_EQ(robot.roomba.firmware().mode(), oi::OiMode::Passive);
  EXPECT_EQ(robot.roomba.truth().pose, (Pose2{2.0, 2.0, 0.0}));
  std::array<std::uint8_t, 100> buffer;
  EXPECT_EQ(robot.roomba.read(buffer).count, 0U) << "still streams";
}

INSTANTIATE_TEST_SUITE_P(All, ModelTest, testing::Values(oi::Model::Create2, oi::Model::Create1, oi::Model::Roomba400));

TEST(ExaminationTest, CountsWhatABadWireLoses) {
  ExaminedRoomba robot;
  TouchedChannel wire(robot.roomba);
  Examination examination(wire, robot.clock());
  ASSERT_EQ(examination.find_robot(), Contact::Robot);
  int reads = 0;
  wire.from_robot = [&](std::vector<std::uint8_t>& bytes) {
    if (bytes.size() < 80) return;
    ++reads;
    if (reads % 10 == 0) bytes[40] ^= 4;  // a bit flips
    if (reads % 25 == 0) bytes.clear();   // a frame is lost without a trace
  };
  examination.listen(3.0);
  const FrameCount& frames = examination.report().frames;
  EXPECT_NEAR(static_cast<double>(frames.damaged), 16.0, 2.0);
  EXPECT_NEAR(static_cast<double>(frames.missing), 24.0, 2.0);
  EXPECT_NEAR(frames.longest_gap, 0.03, 1e-9);
  EXPECT_GE(frames.stray_bytes, frames.damaged * 80);
}

TEST(ExaminationTest, FindsTheRobotBehindAWireThatLosesBytes) {
  for (std::size_t every = 60; every < 300; every += 20) {
    ExaminedRoomba robot;
    TouchedChannel wire(robot.roomba);
    std::size_t passed = 0;
    wire.from_robot = [&](std::vector<std::uint8_t>& bytes) {
      std::erase_if(bytes, [&](std::uint8_t) {
        ++passed;
        return passed % (every + 7 * (passed % 3)) == 0;
      });
    };
    Examination examination(wire, robot.clock());
    // A wire that spoils each reply may hide the robot, but never make another one of it.
    if (examination.find_robot() == Contact::Robot) {
      EXPECT_EQ(examination.report().model, oi::Model::Create2) << every;
    } else {
      EXPECT_LT(every, 160U);
    }
  }
}

TEST(ExaminationTest, ASilenceMakesNoPoorerModelOfARobot) {
  // Of its first four answers none arrives: all that it was asked as a Create was in vain.
  ExaminedRoomba robot(oi::Model::Create1);
  TouchedChannel wire(robot.roomba);
  const auto queries = [&] { return std::count(wire.sent.begin(), wire.sent.end(), std::uint8_t{142}); };
  wire.from_robot = [&](std::vector<std::uint8_t>& bytes) {
    if (queries() <= 4) bytes.clear();
  };
  Examination examination(wire, robot.clock());
  ASSERT_EQ(examination.find_robot(), Contact::Robot);
  EXPECT_EQ(examination.report().model, oi::Model::Create1);
  EXPECT_GT(queries(), 5);
}

TEST(ExaminationTest, SaysThatNobodyAnswers) {
  TalkingChannel nobody;
  Examination examination(nobody, nobody.clock());
  EXPECT_EQ(examination.find_robot(), Contact::Silent);
  EXPECT_LE(nobody.clock()(), 2.0);
}

TEST(ExaminationTest, SaysThatSomebodyElseAnswers) {
  TalkingChannel other("$GPGGA,123519,4807.038,N\r\n");
  Examination examination(other, other.clock());
  EXPECT_EQ(examination.find_robot(), Contact::Foreign);
}

TEST(ExaminationTest, FindsOutThatTheModeIsReportedOneTooHigh) {
  sim::FirmwareOptions options;
  options.quirks.mode_one_too_high = true;
  ExaminedRoomba robot(oi::Model::Create2, options);
  Examination examination(robot.roomba, robot.clock());
  examination.find_robot();
  EXPECT_TRUE(examination.report().quirks.mode_one_too_high);
  EXPECT_EQ(examination.report().mode, oi::OiMode::Passive);
  examination.read_banner();
  examination.listen(0.5);
  EXPECT_EQ(examination.report().mode, oi::OiMode::Passive);
}

TEST(ExaminationTest, ReadsTheReleaseFromTheBanner) {
  sim::FirmwareOptions options;
  options.release = {3, 2, 6};
  ExaminedRoomba robot(oi::Model::Create2, options);
  Examination examination(robot.roomba, robot.clock());
  ASSERT_EQ(examination.find_robot(), Contact::Robot);
  EXPECT_TRUE(examination.read_banner());
  EXPECT_EQ(examination.report().release, (oi::Release{3, 2, 6}));
  EXPECT_TRUE(examination.report().quirks.distance_wrong);
  EXPECT_THAT(examination.report().banner, testing::HasSubstr("release-3.2.6"));
  EXPECT_EQ(robot.roomba.firmware().mode(), oi::OiMode::Passive);
}

TEST(ExaminationTest, GoesOnWithoutABanner) {
  ExaminedRoomba robot;
  TouchedChannel wire(robot.roomba);
  Examination examination(wire, robot.clock());
  ASSERT_EQ(examination.find_robot(), Contact::Robot);
  wire.from_robot = [](std::vector<std::uint8_t>& bytes) {
    if (bytes.size() != 80) bytes.clear();
  };
  EXPECT_TRUE(examination.read_banner());
  EXPECT_FALSE(examination.report().release.has_value());
  EXPECT_EQ(examination.report().banner, "");
}

TEST(ExaminationTest, SaysThatARobotDidNotComeBackFromItsNewStart) {
  ExaminedRoomba robot;
  TouchedChannel wire(robot.roomba);
  Examination examination(wire, robot.clock());
  ASSERT_EQ(examination.find_robot(), Contact::Robot);
  wire.from_robot = [](std::vector<std::uint8_t>& bytes) { bytes.clear(); };
  EXPECT_FALSE(examination.read_banner());
}

TEST(ExaminationTest, KeepsWhatAPacketSaidOverTime) {
  ExaminedRoomba robot;
  TouchedChannel wire(robot.roomba);
  Examination examination(wire, robot.clock());
  ASSERT_EQ(examination.find_robot(), Contact::Robot);
  int frames = 0;
  wire.from_robot = [&](std::vector<std::uint8_t>& bytes) {
    if (bytes.size() != 84) return;
    const auto shell = static_cast<std::uint8_t>(++frames < 20 ? 0b11 : 0b10);
    bytes[83] = static_cast<std::uint8_t>(bytes[83] - shell);  // the sum stays 0
    bytes[3] = shell;
  };
  examination.listen(1.0);
  const PacketHistory& shell = examination.report().history[number(oi::PacketId::BumpsAndWheelDrops)];
  EXPECT_EQ(shell.least, 0b10);
  EXPECT_EQ(shell.most, 0b11);
  EXPECT_EQ(shell.always, 0b10);
  EXPECT_EQ(shell.ever, 0b11);
}

TEST(ExaminationTest, DoesNotCountWhatItOnlyWatches) {
  ExaminedRoomba robot;
  Examination examination(robot.roomba, robot.clock());
  ASSERT_EQ(examination.find_robot(), Contact::Robot);
  examination.listen(1.0);
  const std::uint64_t frames = examination.report().frames.frames;
  int watched = 0;
  examination.watch(10.0, [&](const oi::Sensors&, double) { return ++watched < 50; });
  EXPECT_EQ(watched, 50);
  EXPECT_EQ(examination.report().frames.frames, frames);
}

TEST(ExaminationTest, EndsEachStepWhenSomebodyAsksToStop) {
  ExaminedRoomba robot;
  std::stop_source stop;
  Examination examination(robot.roomba, robot.clock(), stop.get_token());
  ASSERT_EQ(examination.find_robot(), Contact::Robot);
  stop.request_stop();
  const double begin = robot.roomba.now();
  examination.read_banner();
  examination.time_replies();
  examination.listen(60.0);
  EXPECT_LT(robot.roomba.now() - begin, 0.5);
}

}  // namespace
}  // namespace scrubjay
