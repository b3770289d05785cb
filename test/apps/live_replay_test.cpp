#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <io/fake_robot.hpp>
#include <io/temporary_folder.hpp>
#include <scrubjay/io/recording.hpp>

#include "command_line.hpp"
#include "run_folder.hpp"

namespace scrubjay {
namespace {

using testing::HasSubstr;

FakeRobot::Traits one_too_high() {
  FakeRobot::Traits traits;
  traits.firmware.quirks.mode_one_too_high = true;
  return traits;
}

/// Recordings of robots on a wire.
class LiveReplayTest : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string serial() const { return "serial:" + path("port"); }

  /// Explores until the robot has rolled a little, and is asked to stop while it rolls on.
  void explore(const FakeRobot& robot, const Words& more = {}) const {
    Words words{"explore", "--robot", serial(), "--out", path("live"), "--record", path("run.oilog")};
    words.insert(words.end(), more.begin(), more.end());
    Call call(words);
    EXPECT_TRUE(soon([&] { return robot.rolled() > 0.2; }));
    call.send(SIGINT);
    const Outcome outcome = call.wait();
    EXPECT_EQ(outcome.code, 0) << outcome.err;
  }
  Outcome replay(const Words& more = {}) const {
    Words words{"replay", path("run.oilog"), "--out", path("again")};
    words.insert(words.end(), more.begin(), more.end());
    return scrubjay(words);
  }
  void expect_same_run() const {
    for (const char* name : {"map.pgm", "map.yaml", "map.png", "trajectory.tum", "scenario.yaml"}) {
      EXPECT_TRUE(content_of(folder_ / "again" / name) == content_of(folder_ / "live" / name)) << name;
    }
    const nlohmann::json live = metrics_of(folder_ / "live");
    nlohmann::json again = metrics_of(folder_ / "again");
    again["link"] = live.at("link");  // which only a wire has
    EXPECT_EQ(again, live);
  }
  std::string ended() const { return metrics_of(folder_ / "again").at("ended"); }

  TemporaryFolder folder_;
};

TEST_F(LiveReplayTest, EndsWhereAndAsTheRunDid) {
  const FakeRobot robot(folder_ / "port");
  explore(robot);
  EXPECT_EQ(metrics_of(folder_ / "live").at("ended"), "stopped");
  const Outcome outcome = replay();
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  expect_same_run();
}

class OtherDialectTest : public LiveReplayTest, public testing::WithParamInterface<oi::Model> {};

TEST_P(OtherDialectTest, IsReplayedAsItWasSpoken) {
  const FakeRobot robot(folder_ / "port", {.protocol = GetParam()});
  explore(robot, {"--model", "roomba-600"});
  const Outcome outcome = replay();
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  expect_same_run();
  EXPECT_GT(metrics_of(folder_ / "again").at("distance_m"), 0.1);
}

TEST_P(OtherDialectTest, IsRecordedWithoutDriving) {
  const FakeRobot robot(folder_ / "port", {.protocol = GetParam()});
  const Outcome outcome = scrubjay({"record", "--robot", serial(), "--model", "roomba-600", "--out", path("run.oilog"),
                                    "--max-time", "0.5", "--quiet"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(RecordingReader(path("run.oilog")).scenario(), HasSubstr("protocol: "));
  EXPECT_EQ(replay().code, 0);
  EXPECT_GT(metrics_of(folder_ / "again").at("simulated_time_s"), 0.4);
}

INSTANTIATE_TEST_SUITE_P(Dialects, OtherDialectTest, testing::Values(oi::Model::Create1, oi::Model::Roomba400),
                         [](const auto& protocol) { return "Model" + std::to_string(protocol.index); });

TEST_F(LiveReplayTest, KnowsTheQuirksThatWereFound) {
  const FakeRobot robot(folder_ / "port", one_too_high());
  explore(robot);
  EXPECT_THAT(RecordingReader(path("run.oilog")).scenario(), HasSubstr("mode_one_too_high: true"));
  EXPECT_EQ(replay().code, 0);
  expect_same_run();
}

TEST_F(LiveReplayTest, EndsWithTheRecordingWhereNobodyWasOnAMission) {
  const FakeRobot robot(folder_ / "port");
  Call call({"record", "--robot", serial(), "--out", path("run.oilog")});
  EXPECT_TRUE(soon([&] { return robot.frames_sent() > 100; }));
  call.send(SIGINT);
  EXPECT_EQ(call.wait().code, 0);
  EXPECT_THAT(replay().out, testing::StartsWith("end of the recording after "));
  EXPECT_EQ(ended(), "end of the recording");
}

TEST_F(LiveReplayTest, EndsWithTheRecordingThatWasCut) {
  const FakeRobot robot(folder_ / "port");
  explore(robot);
  const std::string whole = content_of(folder_ / "run.oilog");
  folder_.write("run.oilog", whole.substr(0, whole.size() / 2));
  const Outcome outcome = replay();
  EXPECT_EQ(outcome.code, 0);
  EXPECT_TRUE(is_one_line(outcome.err)) << outcome.err;
  EXPECT_EQ(ended(), "end of the recording");
}

TEST_F(LiveReplayTest, IsRefusedWithoutASingleFrame) {
  for (const std::string strategy : {"strategy: edge-follow\n", ""}) {
    {
      RecordingWriter writer(path("run.oilog"), "model: roomba-600\n" + strategy);
      writer.record(Direction::Received, 0.0, std::vector<std::uint8_t>(100, 7));
      writer.close();
    }
    for (const Words& words :
         {Words{"replay", path("run.oilog")}, Words{"explore", "--robot", "log:" + path("run.oilog")}}) {
      const Outcome outcome = scrubjay_in(folder_.path(), words);
      EXPECT_EQ(outcome.code, 1);
      EXPECT_EQ(outcome.out, "");
      EXPECT_TRUE(is_one_line(outcome.err)) << outcome.err;
      EXPECT_THAT(outcome.err, HasSubstr("run.oilog: holds no whole frame of a roomba-600"));
    }
  }
}

}  // namespace
}  // namespace scrubjay
