#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <io/temporary_folder.hpp>
#include <nlohmann/json.hpp>
#include <scrubjay/io/pseudo_terminal.hpp>
#include <sstream>
#include <thread>

#include "command_line.hpp"
#include "driven_terminal.hpp"

namespace scrubjay {
namespace {

/// A simulated robot behind a pseudo-terminal, in real time.
class DoctorTest : public testing::Test {
 protected:
  void emulate(const Words& more = {}) {
    Words words{"emulate", own_world("room"), "--pty", port()};
    words.insert(words.end(), more.begin(), more.end());
    emulator_.emplace(words);
    while (!std::filesystem::is_symlink(port())) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  ~DoctorTest() override {
    if (!emulator_) return;
    emulator_->send(SIGTERM);
    emulator_->wait();
  }
  std::string port() const { return (folder_ / "robot").string(); }

  TemporaryFolder folder_;
  std::optional<Call> emulator_;
};

TEST_F(DoctorTest, ReportsAllThatItFoundInEightyColumns) {
  emulate();
  const Outcome outcome = scrubjay({"doctor", "--port", port(), "--listen", "1"});
  for (const char* word :
       {"port ", "robot ", "Create 2", "release ", "Passive", "battery ", "frames ", "lost ", "latency ", "bumpers ",
        "cliffs ", "light bumper ", "wheel drops ", "encoders ", "currents ", "infrared ", "buttons ", "--check"}) {
    EXPECT_THAT(outcome.out, testing::HasSubstr(word));
  }
  std::istringstream lines(outcome.out);
  for (std::string line; std::getline(lines, line);) {
    EXPECT_LT(line.size(), line.starts_with("port ") ? 80U + port().size() : 80U) << line;
  }
  // A machine with too much else to do loses frames, which is as it should be: the verdict is in code and words alike.
  EXPECT_EQ(outcome.code == 0, outcome.out.ends_with("\nhealthy\n")) << outcome.out;
}

TEST_F(DoctorTest, TellsProgramsTheSame) {
  emulate();
  const Outcome outcome = scrubjay({"doctor", "--port", port(), "--no-reset", "--listen", "1", "--json"});
  const nlohmann::json report = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(report.at("contact"), "robot");
  EXPECT_EQ(report.at("robot").at("model"), "create-2");
  EXPECT_EQ(report.at("robot").at("mode"), "Passive");
  EXPECT_GT(report.at("frames").at("count"), 10);
  EXPECT_GT(report.at("sensors").at("voltage").at("value"), 12'000);
  EXPECT_EQ(report.at("healthy").get<bool>(), outcome.code == 0);
}

TEST_F(DoctorTest, FindsAnOlderModel) {
  emulate({"--model", "create-1"});
  const Outcome outcome = scrubjay({"doctor", "--port", port(), "--listen", "1", "--json"});
  EXPECT_EQ(nlohmann::json::parse(outcome.out).at("robot").at("model"), "create-1");
}

TEST_F(DoctorTest, AsksTheUserInATerminalAndPassesOverByEnter) {
  emulate();
  TerminalCall call({"doctor", "--port", port(), "--no-reset", "--listen", "1"});
  for (const char* task : {"1 of 5: press the bumper on the left", "2 of 5", "3 of 5", "4 of 5", "5 of 5: turn"}) {
    ASSERT_TRUE(call.wait_for(task)) << call.shown();
    EXPECT_FALSE(call.is_cooked());
    call.type("\r");
  }
  EXPECT_EQ(call.wait(), 1);
  EXPECT_THAT(call.shown(), testing::HasSubstr("Not felt: left bumper"));
  EXPECT_TRUE(call.is_cooked());
}

TEST_F(DoctorTest, SaysThatNobodyAnswersAndWhatToTry) {
  const PseudoTerminal deaf(port());
  const Outcome outcome = scrubjay({"doctor", "--port", port()});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.out, testing::HasSubstr("problem: Nobody answers\n"));
  EXPECT_THAT(outcome.out, testing::HasSubstr("try: "));
  EXPECT_TRUE(is_one_line(outcome.err)) << outcome.err;
}

TEST_F(DoctorTest, TriesTheRateThatItIsToldFirst) {
  emulate();
  const Outcome outcome = scrubjay({"doctor", "--port", port() + "@38400", "--no-reset", "--listen", "0.5", "--json"});
  const nlohmann::json report = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(report.at("contact"), "robot");
  EXPECT_EQ(report.at("port").at("baud"), 38400);
}

TEST_F(DoctorTest, RefusesAPortThatIsNone) {
  const Outcome nowhere = scrubjay({"doctor", "--port", (folder_ / "nowhere").string()});
  EXPECT_EQ(nowhere.code, 2);
  EXPECT_TRUE(is_one_line(nowhere.err));
  EXPECT_EQ(scrubjay({"doctor", "--port", folder_.write("file", "text").string()}).code, 2);
  EXPECT_EQ(scrubjay({"doctor", "--port", port(), "--listen", "0"}).code, 2);
  const Outcome slow = scrubjay({"doctor", "--port", port() + "@slow"});
  EXPECT_EQ(slow.code, 2);
  EXPECT_THAT(slow.err, testing::HasSubstr("--port: 'slow' is no baud rate"));
}

}  // namespace
}  // namespace scrubjay
