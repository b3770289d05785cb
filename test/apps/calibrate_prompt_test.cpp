#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <io/temporary_folder.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <scrubjay/geometry/pose2.hpp>
#include <sstream>

#include "command_line.hpp"
#include "driven_terminal.hpp"
#include "pty_client.hpp"

namespace scrubjay {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr const char* kEnter = "Press Enter to start: ";
constexpr const char* kAskStraight = "Millimetres from the tape to the robot's front: ";
constexpr const char* kAskSquare = "As in 12,-5: ";

/// A robot behind a pseudo-terminal, at many times real time, on a floor of 7 m by 7 m.
class CalibratePromptTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_.write("hall.yaml",
                  "name: hall\nwalls:\n  - [[0, 0], [7, 0], [7, 7], [0, 7], [0, 0]]\nstart: [3, 3, 0.3]\n");
  }
  void emulate(const Words& more = {}) {
    Words words{"emulate", path("hall.yaml"), "--pty",       path("port"),  "--speed",  "10",
                "--quiet", "--truth",         path("truth"), "--truth-log", path("log")};
    words.insert(words.end(), more.begin(), more.end());
    emulator_.emplace(words);
    ASSERT_TRUE(eventually([&] { return !now().is_null(); }));
  }
  Words words(const Words& more) const {
    Words all{"calibrate", "--robot", "serial:" + path("port"), "--out", path("calibration.yaml"), "--side", "0.3"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string calibration() const { return content_of(folder_ / "calibration.yaml"); }

  /// What its owner sees of the robot now: the last whole line of the live truth.
  nlohmann::json now() const {
    const std::string log = content_of(folder_ / "log");
    const std::size_t end = log.rfind('\n');
    if (end == std::string::npos || end == 0) return {};
    const std::size_t begin = log.rfind('\n', end - 1);
    return nlohmann::json::parse(log.substr(begin == std::string::npos ? 0 : begin + 1, end));
  }
  Pose2 pose() const {
    const nlohmann::json pose = now().at("pose");
    return {pose[0], pose[1], pose[2]};
  }
  /// Ends the emulation: what really happened to the robot.
  nlohmann::json truth() {
    emulator_->send(SIGTERM);
    EXPECT_EQ(emulator_->wait().code, 0);
    return nlohmann::json::parse(content_of(folder_ / "truth")).at("robots")[0];
  }

  TemporaryFolder folder_;
  std::optional<Call> emulator_;
};

TEST_F(CalibratePromptTest, AsksAgainUntilTheAnswerIsOne) {
  emulate();
  TerminalCall call(words({"--drives", "straight", "--straight", "0.5"}));
  ASSERT_TRUE(call.wait_for(kEnter)) << call.shown();
  EXPECT_THAT(call.shown(), HasSubstr("drives 0.5 m straight ahead"));
  call.type("\r");
  ASSERT_TRUE(call.wait_for(kAskStraight)) << call.shown();
  for (const char* answer : {"far", "", "12,5", "510 mm", "nan", "1e999", "5.1.0", "--"}) {
    call.forget();
    call.type(std::string(answer) + "\r");
    ASSERT_TRUE(call.wait_for("That is none; want one number.")) << answer;
    ASSERT_TRUE(call.wait_for(kAskStraight)) << answer;
  }
  for (const char* answer : {"51", "-510", "510000"}) {
    call.forget();
    call.type(std::string(answer) + "\r");
    ASSERT_TRUE(call.wait_for("straight: no wheels can have ended there")) << answer;
    ASSERT_TRUE(call.wait_for(kAskStraight)) << answer;
  }
  call.type(" +510.0 \r");
  EXPECT_EQ(call.wait(), 0) << call.shown();
  EXPECT_THAT(call.shown(), HasSubstr("510 mm"));
  EXPECT_THAT(calibration(), HasSubstr("{figure: straight, measured: [0.51], "));
}

TEST_F(CalibratePromptTest, FindsWhatTheSimulationFindsWithTheTruthForARuler) {
  const Words robot{"--noise", "uncalibrated", "--seed", "5"};
  const Words drive{"--drives", "square-left", "--json"};
  Words simulated{"calibrate", path("hall.yaml"), "--side", "0.3", "--out", path("simulated.yaml")};
  simulated.insert(simulated.end(), robot.begin(), robot.end());
  simulated.insert(simulated.end(), drive.begin(), drive.end());
  const nlohmann::json expected = nlohmann::json::parse(scrubjay(simulated).out);

  emulate(robot);
  TerminalCall call(words(drive));
  ASSERT_TRUE(call.wait_for(kEnter));
  EXPECT_THAT(call.shown(), HasSubstr("drives a square to the left"));
  const Pose2 start = pose();
  call.type("\r");
  ASSERT_TRUE(call.wait_for(kAskSquare));
  const Pose2 end = inverse(start) * pose();
  call.type("12-5\r");
  ASSERT_TRUE(call.wait_for("That is none; want two numbers."));
  EXPECT_GT(end.position().norm(), 0.05) << "too near to tell front from side";
  call.forget();
  call.type(std::to_string(1000.0 * end.x) + ", " + std::to_string(1000.0 * end.y) + "\r");
  EXPECT_EQ(call.wait(), 0);
  const nlohmann::json found = nlohmann::json::parse(call.shown().substr(call.shown().find('{')));
  for (const char* factor : {"left", "right", "axle"}) {
    EXPECT_NEAR(found.at(factor).get<double>(), expected.at(factor).get<double>(), 0.01) << factor;
  }
}

TEST_F(CalibratePromptTest, DrivesAgainWhereSomethingWasInTheWay) {
  emulate({"--start", "6.5,3,0"});
  TerminalCall call(words({"--drives", "straight", "--straight", "0.5"}));
  ASSERT_TRUE(call.wait_for(kEnter));
  call.forget();
  call.type("\r");
  ASSERT_TRUE(call.wait_for("straight: something is in the way")) << call.shown();
  ASSERT_TRUE(call.wait_for(kEnter)) << call.shown();
  {
    // Away from the wall; between the drives the port is anybody's.
    const PtyClient carrier(folder_ / "port");
    carrier.send({128, 131, 145, 0xFF, 0x38, 0xFF, 0x38});
    EXPECT_TRUE(eventually([&] { return pose().x < 5.9; }));
    carrier.send({145, 0, 0, 0, 0});
    EXPECT_EQ(carrier.ask(39, 2), 0);
  }
  call.type("\r");
  ASSERT_TRUE(call.wait_for(kAskStraight)) << call.shown();
  call.type("500\r");
  EXPECT_EQ(call.wait(), 0) << call.shown();
  EXPECT_THAT(calibration(), HasSubstr("measured: [0.5]"));
  EXPECT_EQ(truth().at("bumps"), 1);
}

TEST_F(CalibratePromptTest, CtrlCEndsADriveAndTheRobotStands) {
  emulate();
  TerminalCall call(words({"--drives", "straight"}));
  ASSERT_TRUE(call.wait_for(kEnter));
  call.type("\r");
  ASSERT_TRUE(eventually([&] { return now().at("distance") > 0.02; }));
  call.type("\x03");
  EXPECT_EQ(call.wait(), 1);
  EXPECT_THAT(call.shown(), HasSubstr("straight: stopped before it was done"));
  EXPECT_EQ(calibration(), "");
  const PtyClient client(folder_ / "port");
  EXPECT_EQ(client.ask(39, 2), 0);
  EXPECT_EQ(client.ask(35, 1), 1) << "in a mode that charges";
}

TEST_F(CalibratePromptTest, CtrlCEndsItAtAQuestionToo) {
  emulate();
  TerminalCall call(words({"--drives", "straight"}));
  ASSERT_TRUE(call.wait_for(kEnter));
  call.type("\x03");
  EXPECT_EQ(call.wait(), -SIGINT);
  EXPECT_EQ(calibration(), "");
}

TEST_F(CalibratePromptTest, EndsWhenNobodyAnswers) {
  emulate();
  TerminalCall call(words({}));
  ASSERT_TRUE(call.wait_for(kEnter));
  call.type("\x04");
  EXPECT_EQ(call.wait(), 2);
  EXPECT_THAT(call.shown(), HasSubstr("\nscrubjay: nobody answers"));

  const Outcome outcome = scrubjay(words({}));  // with nothing on stdin
  EXPECT_EQ(outcome.code, 2);
  std::istringstream lines(outcome.err.substr(0, outcome.err.find("scrubjay: nobody")));
  for (std::string line; std::getline(lines, line);) EXPECT_LT(line.size(), 80u) << line;
  EXPECT_THAT(outcome.err, testing::EndsWith("\nscrubjay: nobody answers; want somebody at a terminal, or all that was "
                                             "measured as --measured\n"));
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(calibration(), "");
  EXPECT_EQ(truth().at("distance"), 0.0);
}

TEST_F(CalibratePromptTest, TakesWhatAScriptMeasuredAndAsksNothing) {
  emulate();
  const Outcome outcome =
      scrubjay(words({"--drives", "spin,straight", "--straight", "0.3", "--measured", "-3", "300"}));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, Not(HasSubstr("Press")));
  EXPECT_THAT(outcome.out, HasSubstr("357.00 deg"));
  EXPECT_THAT(outcome.out, HasSubstr(" 300 mm"));

  const Outcome wrong = scrubjay(words({"--drives", "spin", "--measured", "half"}));
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("--measured for spin is 'half'; want degrees beyond the turn"));
  const Outcome few = scrubjay(words({"--drives", "spin,spin", "--measured", "3"}));
  EXPECT_EQ(few.code, 2);
  EXPECT_THAT(few.err, HasSubstr("--measured holds 1 words; want one for each of the 2 drives"));
  EXPECT_EQ(scrubjay(words({"--measured", "3", "hall.yaml"})).code, 2);
}

TEST_F(CalibratePromptTest, RefusesARobotThatIsAnotherModelBeforeItAsks) {
  emulate({"--model", "create-1"});
  const Outcome outcome = scrubjay(words({"--model", "create-2"}));
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("the robot doesn't speak as a create-2 does; want its --model"));
  EXPECT_THAT(outcome.err, Not(HasSubstr("Press")));
}

}  // namespace
}  // namespace scrubjay
