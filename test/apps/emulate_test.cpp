#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <set>

#include "emulate_fixture.hpp"
#include "pty_client.hpp"

namespace scrubjay {
namespace {

using testing::HasSubstr;

constexpr std::uint8_t kMode = 35;
constexpr double kMillimetresPerCount = 0.444565;

/// Counts that the left wheel turned from one reading to another.
int counted(int from, int to) {
  return static_cast<std::int16_t>(to - from);
}

TEST_F(EmulateTest, ARobotDrivesAsItsClientSaysAndTheTruthAgrees) {
  Call call = start({"--truth", (folder_ / "truth.json").string()});
  const PtyClient client(link());
  client.send({128, 131});
  const int before = client.ask(43, 2);
  client.send({145, 0, 200, 0, 200});
  EXPECT_TRUE(eventually([&] { return counted(before, client.ask(43, 2)) > 1000; }));
  client.send({145, 0, 0, 0, 0});
  int count = client.ask(43, 2);
  EXPECT_TRUE(eventually([&] {
    const int earlier = count;
    count = client.ask(43, 2);
    client.ask(43, 2);  // a tick or more apart
    return count == earlier;
  }));
  const double counted_way = kMillimetresPerCount * counted(before, count);
  const nlohmann::json account = end(call);
  ASSERT_EQ(account.at("robots").size(), 1u);
  const nlohmann::json& robot = account.at("robots")[0];
  EXPECT_NEAR(1000.0 * robot.at("distance").get<double>(), counted_way, 1.0);
  EXPECT_NEAR(robot.at("turned").get<double>(), 0.0, 1e-9);
  EXPECT_EQ(robot.at("mode"), "safe");
  EXPECT_GT(robot.at("seconds_in_mode").at("safe"), 1.0);
  EXPECT_EQ(robot.at("rejected_commands"), 0);
  EXPECT_EQ(nlohmann::json::parse(content_of(folder_ / "truth.json")), account);
  EXPECT_FALSE(std::filesystem::is_symlink(link())) << "its link is gone";
}

TEST_F(EmulateTest, StreamsFrames) {
  Call call = start({});
  const PtyClient client(link());
  client.send({128, 148, 1, 7});
  const PtyClient::Bytes frames = client.receive(50);
  for (std::size_t i = 0; i + 5 <= 50; i += 5) {
    const std::vector<int> frame(frames.begin() + static_cast<std::ptrdiff_t>(i),
                                 frames.begin() + static_cast<std::ptrdiff_t>(i + 5));
    EXPECT_THAT(frame, testing::ElementsAre(19, 2, 7, 0, 256 - 19 - 2 - 7));
  }
}

TEST_F(EmulateTest, TellsWhatItWasMadeToShowAndPlay) {
  Call call = start({});
  const PtyClient client(link());
  client.send({128, 132, 139, 5, 100, 200, 138, 7, 140, 0, 1, 60, 8, 141, 0});
  EXPECT_EQ(client.ask(kMode, 1), 3);
  client.send({173});
  // Off: only the next Start is heard, so its answer says that all of it arrived.
  client.send({128});
  EXPECT_EQ(client.ask(kMode, 1), 1);
  const nlohmann::json robot = end(call, SIGINT).at("robots")[0];
  EXPECT_EQ(robot.at("leds"), nlohmann::json({5, 100, 200}));
  EXPECT_EQ(robot.at("motors"), 7);
  EXPECT_EQ(robot.at("songs_played"), 1);
}

TEST_F(EmulateTest, HasTheFaultsThatAreAskedFor) {
  Call call = start({"--mode-off-by-one", "--encoder-start", "65000", "--low-battery", "0.2", "--lifted", "0",
                     "--sticky-wheel", "left,0"});
  const PtyClient client(link());
  client.send({128, 132});
  EXPECT_EQ(client.ask(kMode, 1), 4) << "Full is 3";
  EXPECT_EQ(client.ask(43, 2), 65000);
  EXPECT_NEAR(static_cast<double>(client.ask(25, 2)) / client.ask(26, 2), 0.2, 0.01);
  EXPECT_EQ(client.ask(7, 1), 12) << "both wheels hang";
  client.send({145, 0, 200, 0, 200});
  EXPECT_TRUE(eventually([&] { return client.ask(14, 1) == 16; })) << "the left wheel draws too much";
  EXPECT_TRUE(eventually([&] { return client.ask(44, 2) > 65100; })) << "the right one turns in the air";
  EXPECT_EQ(client.ask(43, 2), 65000);
  EXPECT_EQ(end(call).at("robots")[0].at("distance"), 0.0);
}

TEST_F(EmulateTest, HasTheBadWireThatIsAskedFor) {
  Call call = start({"--drop", "0.02", "--flip", "0.02", "--delay", "50", "--silence", "2,0.5", "--seed", "3"});
  const PtyClient client(link());
  EXPECT_TRUE(eventually([&] {
    client.send({128, 148, 1, 7});
    return client.receive().size() > 10;
  }));
  client.receive(3000);
  const nlohmann::json wire = end(call).at("robots")[0].at("wire");
  for (const auto& fault : {"dropped", "flipped", "delayed", "silences", "silenced"}) EXPECT_GT(wire.at(fault), 0);
}

TEST_F(EmulateTest, PutsSeveralRobotsIntoOneWorld) {
  Call call = start({"--count", "3"});
  const PtyClient first(link() + "0");
  const PtyClient last(link() + "2");
  first.send({128});
  last.send({128, 132, 145, 0, 100, 0xFF, 0x9C});  // spins
  EXPECT_EQ(first.ask(kMode, 1), 1);
  EXPECT_TRUE(eventually([&] { return static_cast<std::int16_t>(last.ask(44, 2)) > 200; }));
  const nlohmann::json robots = end(call).at("robots");
  ASSERT_EQ(robots.size(), 3u);
  std::set<nlohmann::json> starts;
  for (const auto& robot : robots) starts.insert(robot.at("start"));
  EXPECT_EQ(starts.size(), 3u);
  EXPECT_EQ(robots[0].at("pose"), robots[0].at("start"));
  EXPECT_GT(robots[2].at("turned"), 0.3);
  EXPECT_EQ(robots[1].at("bytes").at("received"), 0);
}

TEST_F(EmulateTest, ASleepingRobotIsWokenByALineOnStdin) {
  const std::string pipe = (folder_ / "stdin").string();
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  Surroundings surroundings;
  surroundings.in_from = pipe;
  const std::string log = (folder_ / "log").string();
  Call call = start({"--asleep", "--truth-log", log}, surroundings);
  const PtyClient client(link());
  client.send({128, 142, kMode});
  EXPECT_TRUE(eventually([&] { return content_of(log).find("{\"time\":2.") != std::string::npos; }));
  EXPECT_EQ(client.receive().size(), 0u) << "it sleeps";
  std::ofstream(pipe) << "brc\n";
  EXPECT_TRUE(eventually([&] { return content_of(log).find("\"asleep\":false") != std::string::npos; }));
  client.send({128});
  EXPECT_EQ(client.ask(kMode, 1), 1);
  const nlohmann::json robot = end(call).at("robots")[0];
  EXPECT_EQ(robot.at("asleep"), false);
}

TEST_F(EmulateTest, ASleepingRobotIsWokenByASignal) {
  Call call = start({"--asleep"});
  const PtyClient client(link());
  call.send(SIGUSR1);
  EXPECT_TRUE(eventually([&] {
    client.send({128, 142, kMode});
    return !client.receive().empty();
  }));
  EXPECT_EQ(end(call).at("robots")[0].at("mode"), "passive");
}

TEST_F(EmulateTest, OutlivesClientsThatGoAndOnesThatDontRead) {
  const std::string log = (folder_ / "log").string();
  Call call = start({"--truth-log", log});
  {
    const PtyClient client(link());
    client.send({128, 132, 148, 1, 100, 145, 0, 50, 0, 50});
    client.receive(500);
  }
  // The stream goes on, with many times what a terminal holds.
  const PtyClient client(link());
  EXPECT_TRUE(eventually([&] { return content_of(log).find("{\"time\":9.") != std::string::npos; }));
  client.send({150, 0});
  EXPECT_TRUE(eventually([&] { return client.receive().empty() && client.ask(kMode, 1) == 3; }));
  const nlohmann::json robot = end(call).at("robots")[0];
  EXPECT_GT(robot.at("distance"), 0.0);
  EXPECT_GT(robot.at("bytes").at("unread"), 0);
}

TEST_F(EmulateTest, EndsByItselfWhenItsTimeIsOver) {
  const Outcome outcome =
      scrubjay({"emulate", own_world("room"), "--pty", link(), "--speed", "1000", "--max-time", "9"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out, HasSubstr("roomba-600 behind " + link()));
  EXPECT_THAT(outcome.out, HasSubstr("scrubjay explore --robot serial:" + link()));
  EXPECT_THAT(outcome.out, HasSubstr(link() + ": 9 s, 0.00 m driven"));
}

TEST_F(EmulateTest, SpeaksTheDialectOfItsModel) {
  for (const auto& [model, bytes] :
       {std::pair("roomba-400", 26), std::pair("create-1", 52), std::pair("create-2", 80)}) {
    SCOPED_TRACE(model);
    Call call = start({"--model", model});
    const PtyClient client(link());
    const std::uint8_t all = bytes == 26 ? 0 : bytes == 52 ? 6 : 100;
    client.send({128, 142, all});
    EXPECT_EQ(client.receive(static_cast<std::size_t>(bytes)).size(), static_cast<std::size_t>(bytes));
    end(call);
  }
}

TEST_F(EmulateTest, RefusesWhatItCantBe) {
  const auto refusal = [&](const Words& flags) {
    Words words{"emulate", own_world("room"), "--pty", link()};
    words.insert(words.end(), flags.begin(), flags.end());
    const Outcome outcome = scrubjay(words);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(is_one_line(outcome.err)) << outcome.err;
    EXPECT_EQ(folder_.file_count(), 0u);
    return outcome.err;
  };
  EXPECT_THAT(refusal({"--model", "turtlebot3-burger"}), HasSubstr("doesn't speak the Open Interface"));
  EXPECT_THAT(refusal({"--count", "0"}), HasSubstr("want 1 to 100 robots"));
  EXPECT_THAT(refusal({"--count", "90"}), HasSubstr("there is room for"));
  EXPECT_THAT(refusal({"--speed", "0"}), HasSubstr("--speed is 0"));
  EXPECT_THAT(refusal({"--max-time", "-1"}), HasSubstr("--max-time is -1"));
  EXPECT_THAT(refusal({"--drop", "1.5"}), HasSubstr("want a probability, from 0 to 1"));
  EXPECT_THAT(refusal({"--flip", "nan"}), HasSubstr("--flip is nan"));
  EXPECT_THAT(refusal({"--delay", "-1"}), HasSubstr("want milliseconds"));
  EXPECT_THAT(refusal({"--silence", "30"}), HasSubstr("want EVERY,FOR in seconds"));
  EXPECT_THAT(refusal({"--encoder-start", "70000"}), HasSubstr("want counts, 0 to 65535"));
  EXPECT_THAT(refusal({"--low-battery", "2"}), HasSubstr("--low-battery is 2"));
  EXPECT_THAT(refusal({"--lifted", "5,3"}), HasSubstr("want FROM[,UNTIL]"));
  EXPECT_THAT(refusal({"--sticky-wheel", "front,3"}), HasSubstr("want left or right"));
  EXPECT_THAT(refusal({"--truth-port", "70000"}), HasSubstr("want a port"));
  EXPECT_THAT(refusal({"--start", "0,0,0"}), HasSubstr("the start"));
}

}  // namespace
}  // namespace scrubjay
