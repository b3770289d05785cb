#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <io/temporary_folder.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "command_line.hpp"
#include "run_folder.hpp"

namespace scrubjay {
namespace {

using testing::HasSubstr;

TEST(HelpTest, FitsAnEightyColumnTerminal) {
  std::vector<Words> calls{{"--help"}};
  for (const char* command : {"explore", "replay", "compare", "calibrate", "emulate", "record", "tap", "render",
                              "rooms", "score", "info", "doctor"})
    calls.push_back({command, "--help"});
  for (const Words& call : calls) {
    const Outcome outcome = scrubjay(call);
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_THAT(outcome.out, HasSubstr("Usage: scrubjay"));
    std::istringstream lines(outcome.out);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80u) << line;
  }
}

TEST(HelpTest, ListsTheCommandsWhereNoneWasGiven) {
  const Outcome outcome = scrubjay({});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.out, "");
  for (const char* command : {"explore", "replay", "compare", "render", "score", "info"})
    EXPECT_THAT(outcome.err, HasSubstr(command));
}

TEST(HelpTest, TellsTheVersion) {
  const Outcome outcome = scrubjay({"--version"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out, testing::MatchesRegex("scrubjay [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

/// A short run with more flags.
Outcome explore(const TemporaryFolder& folder, const Words& more) {
  Words words{"explore", own_world("room"), "--max-time", "20", "--out", "out", "--record", "run.oilog"};
  words.insert(words.end(), more.begin(), more.end());
  return scrubjay_in(folder.path(), words);
}

TEST(OutputTest, IsEmptyWhenQuiet) {
  const TemporaryFolder folder;
  for (const Outcome& outcome :
       {explore(folder, {"--quiet"}), scrubjay_in(folder.path(), {"replay", "run.oilog", "--quiet"})}) {
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err, "");
  }
}

TEST(OutputTest, IsJsonAloneWhenAskedFor) {
  const TemporaryFolder folder;
  const Outcome run = explore(folder, {"--json"});
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(nlohmann::json::parse(run.out), metrics_of(folder / "out"));
  const Outcome replay = scrubjay_in(folder.path(), {"replay", "run.oilog", "--json", "--out", "again"});
  EXPECT_EQ(nlohmann::json::parse(replay.out), metrics_of(folder / "again"));
  const Outcome score = scrubjay_in(folder.path(), {"score", "out/map.yaml", own_world("room"), "--json"});
  EXPECT_TRUE(nlohmann::json::parse(score.out).contains("coverage"));
}

TEST(OutputTest, HasNoProgressWhereThereIsNoTerminal) {
  const TemporaryFolder folder;
  const Outcome outcome = explore(folder, {"--speed", "50"});
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(outcome.out.find_first_of("\033\r"), std::string::npos);
}

/// What a call shows on a terminal of its own.
std::string shown_on_terminal(const Words& words, const std::filesystem::path& folder) {
  const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (terminal < 0 || ::grantpt(terminal) != 0 || ::unlockpt(terminal) != 0) return {};
  // Held open until the call is over: a terminal that nobody has open reads as an error.
  const int held = ::open(::ptsname(terminal), O_RDWR | O_NOCTTY | O_CLOEXEC);
  Call call(words, {.folder = folder, .largest_file = {}, .err_to = ::ptsname(terminal), .out_to = {}});
  EXPECT_EQ(call.wait().code, 0);
  ::close(held);
  std::string text;
  char buffer[4096];
  for (ssize_t count = 0; (count = ::read(terminal, buffer, sizeof buffer)) > 0;)
    text.append(buffer, static_cast<std::size_t>(count));
  ::close(terminal);
  return text;
}

TEST(ProgressTest, IsOneLineOfATerminalThatIsClearedInTheEnd) {
  const TemporaryFolder folder;
  const std::string text =
      shown_on_terminal({"explore", own_world("apartment"), "--max-time", "100", "--speed", "100"}, folder.path());
  if (text.empty()) GTEST_SKIP() << "no terminal to be had";
  EXPECT_THAT(text, HasSubstr(" s "));
  EXPECT_THAT(text, HasSubstr(" cells "));
  EXPECT_THAT(text, HasSubstr("% covered"));
  EXPECT_TRUE(text.ends_with("\r\033[K"));
  EXPECT_EQ(text.find('\n'), std::string::npos);
  std::size_t longest = 0;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line, '\r');) {
    EXPECT_TRUE(line.empty() || line.starts_with("\033[K")) << line;
    longest = std::max(longest, line.size() - std::min<std::size_t>(line.size(), 3));
  }
  EXPECT_GT(longest, 30u);
  EXPECT_LE(longest, 80u);
}

TEST(ProgressTest, IsLeftOutWhenQuiet) {
  const TemporaryFolder folder;
  EXPECT_EQ(
      shown_on_terminal({"explore", own_world("room"), "--max-time", "50", "--speed", "100", "--quiet"}, folder.path()),
      "");
}

}  // namespace
}  // namespace scrubjay
