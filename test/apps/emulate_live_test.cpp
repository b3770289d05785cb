#include <gmock/gmock.h>

#include <chrono>
#include <io/line_listener.hpp>
#include <scrubjay/io/line_server.hpp>
#include <thread>

#include "emulate_fixture.hpp"
#include "pty_client.hpp"

namespace scrubjay {
namespace {

using testing::HasSubstr;

/// What an emulation tells while it runs.
class EmulateLiveTest : public EmulateTest {
 protected:
  /// With what it says to people in a file that can be read meanwhile.
  Call start_told(const Words& flags) const {
    Surroundings surroundings;
    surroundings.err_to = folder_.write("told", "");
    return start(flags, surroundings);
  }
  std::string told() const { return content_of(folder_ / "told"); }

  /// The port that it says it listens at.
  std::uint16_t port() const {
    const std::string before = "where they are: port ";
    std::string text;
    EXPECT_TRUE(eventually([&] { return (text = told()).find("Ctrl-C") != std::string::npos; }));
    const std::size_t at = text.find(before);
    EXPECT_NE(at, std::string::npos) << text;
    return static_cast<std::uint16_t>(std::stoi(text.substr(at + before.size())));
  }
};

nlohmann::json next_line(LineListener& listener) {
  return nlohmann::json::parse(listener.line());
}

TEST_F(EmulateLiveTest, TellsListenersWhereItsRobotsAre) {
  Call call = start_told({"--count", "2", "--truth-port", "0"});
  LineListener listener(port());
  const PtyClient client(link() + "1");
  client.send({128, 131, 145, 0, 100, 0xFF, 0x9C});  // turns left
  double time = -1.0;
  nlohmann::json last;
  do {
    const nlohmann::json first = next_line(listener);
    last = next_line(listener);
    EXPECT_EQ(first.at("robot"), 0);
    EXPECT_EQ(last.at("robot"), 1);
    EXPECT_EQ(first.at("time"), last.at("time"));
    EXPECT_EQ(first.at("turned"), 0.0);
    EXPECT_EQ(first.at("asleep"), false);
    EXPECT_GT(last.at("time"), time);
    time = last.at("time");
  } while (last.at("turned") < 1.0 && time < 600.0);
  EXPECT_EQ(last.at("mode"), "safe");
  EXPECT_EQ(last.at("bumps"), 0);
  EXPECT_EQ(last.at("pose").size(), 3u);
  const nlohmann::json robot = end(call).at("robots")[1];
  EXPECT_GE(robot.at("turned"), last.at("turned"));
  EXPECT_NEAR(robot.at("pose")[0], last.at("pose")[0], 1e-9) << "it turns where it stands";
}

TEST_F(EmulateLiveTest, TellsTenTimesASimulatedSecond) {
  Call call = start_told({"--truth-port", "0"});
  LineListener listener(port());
  const double first = next_line(listener).at("time");
  double last = first;
  for (int i = 0; i < 30; ++i) last = next_line(listener).at("time");
  EXPECT_NEAR(last - first, 3.0, 0.015);
  end(call);
}

TEST_F(EmulateLiveTest, GoesOnWithoutListenersAndTellsThoseWhoComeLater) {
  Call call = start_told({"--truth-port", "0"});
  double before = 0.0;
  for (int i = 0; i < 3; ++i) {
    LineListener listener(port());
    const double time = next_line(listener).at("time");
    EXPECT_GT(time, before);
    before = time;
  }
  EXPECT_GE(end(call).at("time"), before);
}

TEST_F(EmulateLiveTest, RefusesAPortThatIsTakenBeforeThereIsARobot) {
  const LineServer taken(0);
  Call call = start({"--truth-port", std::to_string(taken.port())});
  const Outcome outcome = call.wait();
  EXPECT_EQ(outcome.code, 1);
  EXPECT_TRUE(is_one_line(outcome.err)) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("cannot listen at port " + std::to_string(taken.port())));
  EXPECT_EQ(folder_.file_count(), 0u);
}

TEST_F(EmulateLiveTest, SaysThatItFellBehindTheClockAndGoesOnFromThere) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  Call call = start_told({});
  EXPECT_TRUE(eventually([&] { return told().find("Ctrl-C") != std::string::npos; }));
  const PtyClient client(link());
  client.send({128});
  EXPECT_EQ(client.ask(35, 1), 1) << "it runs";
  // Longer than it has patience to catch up with.
  call.send(SIGSTOP);
  std::this_thread::sleep_for(std::chrono::milliseconds(1500));
  call.send(SIGCONT);
  EXPECT_TRUE(eventually([&] { return told().find(" s behind the clock; going on from here\n") != std::string::npos; }))
      << told();
  EXPECT_EQ(client.ask(35, 1), 1) << "it still runs";
  const nlohmann::json account = end(call);
  const double lived = std::chrono::duration<double>(Clock::now() - begin).count();
  const double fell_behind = account.at("fell_behind");
  EXPECT_GT(fell_behind, 1.0);
  EXPECT_LT(account.at("time").get<double>() / kSpeed + fell_behind, lived)
      << "what it gave up it doesn't catch up with";
}

TEST_F(EmulateLiveTest, SaysNothingOfTheClockWhenItKeepsUp) {
  const Outcome outcome =
      scrubjay({"emulate", own_world("room"), "--pty", link(), "--speed", "2", "--max-time", "1", "--json", "--quiet"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(nlohmann::json::parse(outcome.out).at("fell_behind") == 0.0, outcome.err.empty()) << outcome.err;
}

}  // namespace
}  // namespace scrubjay
