#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <io/fake_robot.hpp>
#include <io/temporary_folder.hpp>

#include "command_line.hpp"
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
