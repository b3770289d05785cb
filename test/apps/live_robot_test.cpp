#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <io/fake_robot.hpp>
#include <io/temporary_folder.hpp>
#include <scrubjay/io/recording.hpp>
#include <scrubjay/oi/all_packets.hpp>
#include <thread>

#include "command_line.hpp"
#include "driven_terminal.hpp"
#include "run_folder.hpp"

namespace scrubjay {
namespace {

using testing::HasSubstr;

/// A robot on a wire, and the program that talks to it.
class LiveRobotTest : public testing::Test {
 protected:
  std::string serial() const { return "serial:" + (folder_ / "port").string(); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  TemporaryFolder folder_;
  FakeRobot robot_{folder_ / "port"};
};

TEST_F(LiveRobotTest, ExploresUntilSomebodyAsksItToStop) {
  Call call({"explore", "--robot", serial(), "--out", path("out"), "--record", path("run.oilog")});
  EXPECT_TRUE(soon([&] { return robot_.rolled() > 0.05; }));
  call.send(SIGINT);
  const Outcome outcome = call.wait();
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, testing::StartsWith("stopped after "));
  EXPECT_THAT(outcome.out, HasSubstr("link: "));
  EXPECT_TRUE(robot_.stands());
  EXPECT_EQ(robot_.mode(), oi::OiMode::Passive);
  EXPECT_EQ(broken_result(folder_ / "out"), "");
  const nlohmann::json metrics = metrics_of(folder_ / "out");
  EXPECT_GT(metrics.at("link").at("frames"), 10);
  EXPECT_EQ(metrics.at("model"), "roomba-600");
  EXPECT_FALSE(metrics.contains("coverage"));

  const Outcome again = scrubjay({"replay", path("run.oilog"), "--out", path("again")});
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(content_of(folder_ / "again/trajectory.tum").substr(0, 200),
            content_of(folder_ / "out/trajectory.tum").substr(0, 200));
  EXPECT_EQ(scrubjay({"explore", "--robot", "log:" + path("run.oilog"), "--out", path("third")}).code, 0);
}

/// Signals that follow each other.
class SignalledLiveRobotTest : public LiveRobotTest, public testing::WithParamInterface<std::vector<int>> {};

TEST_P(SignalledLiveRobotTest, IsStoppedBeforeTheProgramEnds) {
  Call call({"explore", "--robot", serial(), "--out", path("out")});
  EXPECT_TRUE(soon([&] { return robot_.rolled() > 0.05; }));
  const bool asked_twice = GetParam().size() > 1;
  call.send(GetParam().front());
  // Again and again: one that comes while another of its kind is pending is none.
  for (int i = 0; asked_twice && i < 50; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    call.send(GetParam().back());
  }
  const Outcome outcome = call.wait();
  EXPECT_TRUE(robot_.stands());
  EXPECT_EQ(robot_.mode(), oi::OiMode::Passive);
  EXPECT_EQ(outcome.signal, asked_twice ? GetParam().back() : 0);
  EXPECT_EQ(std::filesystem::exists(folder_ / "out/map.pgm"), !asked_twice);
}

INSTANTIATE_TEST_SUITE_P(Signals, SignalledLiveRobotTest,
                         testing::Values(std::vector<int>{SIGINT, SIGINT}, std::vector<int>{SIGINT, SIGTERM},
                                         std::vector<int>{SIGQUIT}, std::vector<int>{SIGTERM}));

TEST_F(LiveRobotTest, IsNotLeftDrivingByAProgramThatIsSuspended) {
  Call call({"explore", "--robot", serial(), "--out", path("out")});
  EXPECT_TRUE(soon([&] { return robot_.rolled() > 0.05; }));
  for (const int signal : {SIGTSTP, SIGTTIN, SIGTTOU}) call.send(signal);
  const double before = robot_.rolled();
  EXPECT_TRUE(soon([&] { return robot_.rolled() > before + 0.05; }));
  call.send(SIGTERM);  // a suspended one would never hear it
  EXPECT_EQ(call.wait().code, 0);
  EXPECT_TRUE(robot_.stands());
}

TEST_F(LiveRobotTest, IsDrivenByAKeyboardThatIsHeardInASilenceToo) {
  TerminalCall call({"drive", "--robot", serial()});
  ASSERT_TRUE(call.wait_for("mode Safe")) << call.shown();
  robot_.fall_silent();
  ASSERT_TRUE(call.wait_for("THE ROBOT IS SILENT")) << call.shown();
  call.type("q");
  EXPECT_EQ(call.wait(), 0) << call.shown();
}

TEST_F(LiveRobotTest, IsRecordedInTheModeThatItHas) {
  robot_.hear(oi::Start{});
  robot_.hear(oi::Full{});
  robot_.hear(oi::stream_of_all(oi::Model::Create2));
  const Outcome outcome = scrubjay({"record", "--robot", serial(), "--out", path("run.oilog"), "--max-time", "0.2"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(robot_.mode(), oi::OiMode::Full);
}

TEST_F(LiveRobotTest, RecordsWithoutDriving) {
  const Outcome outcome = scrubjay({"record", "--robot", serial(), "--out", path("run.oilog"), "--max-time", "0.5"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("link: "));
  EXPECT_EQ(robot_.mode(), oi::OiMode::Passive);
  EXPECT_EQ(scrubjay({"replay", path("run.oilog"), "--out", path("out")}).code, 0);
  EXPECT_GT(metrics_of(folder_ / "out").at("simulated_time_s"), 0.4);
}

TEST_F(LiveRobotTest, TapsAWireThatIsExploredThroughIt) {
  Call tap({"tap", "--port", path("port"), "--pty", path("tap"), "--record", path("tap.oilog")});
  ASSERT_TRUE(soon([&] { return std::filesystem::exists(folder_ / "tap.oilog"); }));
  const Outcome outcome =
      scrubjay({"explore", "--robot", "serial:" + path("tap"), "--out", path("out"), "--max-time", "1"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  tap.send(SIGTERM);
  const Outcome tapped = tap.wait();
  EXPECT_EQ(tapped.code, 0) << tapped.err;
  EXPECT_THAT(tapped.out, HasSubstr("bytes from the robot"));
  EXPECT_EQ(scrubjay({"replay", path("tap.oilog"), "--out", path("again")}).code, 0);
  EXPECT_GT(metrics_of(folder_ / "again").at("distance_m"), 0.0);
}

/// A calibration by which a robot goes twice as far as its wheels tell.
class CalibratedRobotTest : public LiveRobotTest {
 protected:
  std::string file_ = folder_.write("twice.yaml", "model: roomba-600\nleft: 2\nright: 2\naxle: 1\n");
  std::string others_ = folder_.write("other.yaml", "model: create-1\nleft: 2\nright: 2\naxle: 1\n");
};

TEST_F(CalibratedRobotTest, IsDrivenByItsFactors) {
  TerminalCall call({"drive", "--robot", serial(), "--calibration", file_});
  ASSERT_TRUE(call.wait_for("mode Safe")) << call.shown();
  ASSERT_TRUE(call.hold_until("w", "driven 0.1")) << call.shown();
  call.forget();
  call.type("q");
  EXPECT_EQ(call.wait(), 0);
  const std::string shown = call.shown();
  const std::size_t last = shown.rfind("driven ");
  ASSERT_NE(last, std::string::npos);
  EXPECT_NEAR(std::stod(shown.substr(last + 7)), 2.0 * robot_.rolled(), 0.02);
}

TEST_F(CalibratedRobotTest, IsRecordedWithItsFactors) {
  const Outcome outcome = scrubjay(
      {"record", "--robot", serial(), "--out", path("run.oilog"), "--max-time", "0.1", "--calibration", file_});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(RecordingReader(path("run.oilog")).scenario(), HasSubstr("calibration: {left: 2, right: 2, axle: 1}"));
}

TEST_F(CalibratedRobotTest, IsTappedWithItsFactors) {
  const Outcome outcome = scrubjay({"tap", "--port", path("port"), "--pty", path("tap"), "--record", path("tap.oilog"),
                                    "--max-time", "0.1", "--calibration", file_});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(RecordingReader(path("tap.oilog")).scenario(), HasSubstr("calibration: {left: 2, right: 2, axle: 1}"));
}

TEST_F(CalibratedRobotTest, IsRefusedTheFactorsOfAnother) {
  TerminalCall drive({"drive", "--robot", serial(), "--calibration", others_});
  EXPECT_EQ(drive.wait(), 2);
  EXPECT_THAT(drive.shown(), HasSubstr("other.yaml: the calibration of a create-1"));
  const Outcome record =
      scrubjay({"record", "--robot", serial(), "--out", path("run.oilog"), "--calibration", others_});
  EXPECT_EQ(record.code, 2);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "run.oilog"));
  const Outcome tap = scrubjay(
      {"tap", "--port", path("port"), "--pty", path("tap"), "--record", path("tap.oilog"), "--calibration", others_});
  EXPECT_EQ(tap.code, 2);
  EXPECT_TRUE(robot_.stands());
}

TEST_F(LiveRobotTest, ExploresWithNoOtherRobotsFactors) {
  FakeRobot other(folder_ / "other", {.protocol = oi::Model::Create1});
  const std::string file = folder_.write("roomba.yaml", "model: roomba-600\nleft: 2\nright: 2\naxle: 1\n");
  const Outcome outcome = scrubjay(
      {"explore", "--robot", "serial:" + path("other"), "--out", path("out"), "--calibration", file, "--quiet"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("but the robot is a create-1"));
  EXPECT_TRUE(other.stands());
}

TEST_F(LiveRobotTest, ExploresWithTheFactorsOfTheRobotThatAnswers) {
  FakeRobot other(folder_ / "other", {.protocol = oi::Model::Create1});
  const std::string file = folder_.write("create.yaml", "model: create-1\nleft: 2\nright: 2\naxle: 1\n");
  const Outcome outcome = scrubjay({"explore", "--robot", "serial:" + path("other"), "--out", path("out"),
                                    "--calibration", file, "--max-time", "1", "--quiet"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(content_of(folder_ / "out/scenario.yaml"), HasSubstr("calibration: {left: 2, right: 2, axle: 1}"));
}

TEST_F(LiveRobotTest, RefusesAModelWithoutAnOpenInterface) {
  const auto refusal = [&](Words words) {
    words.insert(words.end(), {"--model", "turtlebot3-burger"});
    const Outcome outcome = scrubjay(words);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_TRUE(is_one_line(outcome.err)) << outcome.err;
    return outcome.err;
  };
  const char* const told = "--model is turtlebot3-burger, which doesn't speak the Open Interface; want roomba-600";
  EXPECT_THAT(refusal({"explore", "--robot", serial(), "--out", path("out")}), HasSubstr(told));
  EXPECT_THAT(refusal({"record", "--robot", serial(), "--out", path("run.oilog")}), HasSubstr(told));
  EXPECT_THAT(refusal({"tap", "--port", path("port"), "--pty", path("tap"), "--record", path("run.oilog")}),
              HasSubstr(told));
  EXPECT_THAT(refusal({"calibrate", "--robot", serial(), "--out", path("run.yaml")}), HasSubstr(told));
  TerminalCall drive({"drive", "--robot", serial(), "--model", "turtlebot3-burger"});
  EXPECT_EQ(drive.wait(), 2);
  EXPECT_THAT(drive.shown(), HasSubstr("doesn't speak the Open Interface"));
  EXPECT_EQ(folder_.file_count(), 1U) << "only the port's link";
}

TEST_F(LiveRobotTest, RefusesWhatARealRobotCantBeTold) {
  const auto refusal = [&](const Words& more) {
    Words words{"explore", "--robot", serial()};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = scrubjay(words);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_TRUE(is_one_line(outcome.err)) << outcome.err;
    return outcome.err;
  };
  EXPECT_THAT(refusal({own_world("room")}), HasSubstr("WORLD is for a simulated robot"));
  EXPECT_THAT(refusal({"--noise", "carpet"}), HasSubstr("--noise is for a simulated robot"));
  EXPECT_THAT(refusal({"--speed", "2"}), HasSubstr("--speed is for a simulated robot"));
}

TEST(RobotAddressTest, RefusesWhatIsNone) {
  const auto refusal = [](const std::string& robot) { return scrubjay({"explore", "--robot", robot}).err; };
  EXPECT_THAT(refusal("seriall:/dev/x"), HasSubstr("'seriall:/dev/x'; want sim, serial:PATH[@BAUD] or log:FILE"));
  EXPECT_THAT(refusal("serial:"), HasSubstr("names no port"));
  EXPECT_THAT(refusal("serial:/dev/x@fast"), HasSubstr("'fast' is no baud rate"));
  EXPECT_THAT(refusal("log:"), HasSubstr("want sim"));
  EXPECT_THAT(refusal("log:missing.oilog"), HasSubstr("missing.oilog: cannot read"));
}

TEST(NoRobotTest, SaysWhatToTry) {
  const TemporaryFolder folder;
  FakeRobot robot(folder / "port");
  robot.fall_silent();
  const Outcome outcome = scrubjay_in(folder.path(), {"explore", "--robot", "serial:port", "--out", "out"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_TRUE(is_one_line(outcome.err)) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("no robot answers at 115200, 57600 or 19200 baud"));
}

}  // namespace
}  // namespace scrubjay
