#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <io/temporary_folder.hpp>
#include <random>
#include <thread>

#include "command_line.hpp"
#include "run_folder.hpp"

namespace scrubjay {
namespace {

using std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

/// Kills runs of one scenario at random moments, over an older run's files, and looks at what is left.
class KilledRunTest : public testing::Test {
 protected:
  Words explore(const std::string& seed, const std::string& time, const std::string& out) const {
    return {"explore",    own_world("apartment"),
            "--strategy", "random-3",
            "--seed",     seed,
            "--max-time", time,
            "--out",      (folder_ / out).string(),
            "--record",   (folder_ / "run.oilog").string()};
  }

  void kill_often(const std::string& time) {
    ASSERT_EQ(scrubjay(explore("1", time, "old")).code, 0);
    const auto begin = steady_clock::now();
    ASSERT_EQ(scrubjay(explore("2", time, "new")).code, 0);
    const Seconds length = steady_clock::now() - begin;
    const Contents old_run = contents_of(folder_ / "old");
    const Contents new_run = contents_of(folder_ / "new");

    std::mt19937 random(7);
    int killed = 0;
    for (int i = 0; i < 20; ++i) {
      SCOPED_TRACE(i);
      std::filesystem::remove_all(folder_ / "out");
      const bool over_an_old_one = i % 2 == 0;
      if (over_an_old_one) std::filesystem::copy(folder_ / "old", folder_ / "out");
      Call call(explore("2", time, "out"));
      std::this_thread::sleep_for(length * std::uniform_real_distribution(0.0, 1.05)(random));
      call.send(SIGKILL);
      killed += call.wait().signal == SIGKILL;
      EXPECT_EQ(broken_result(folder_ / "out"), "");
      for (const auto& [name, content] : contents_of(folder_ / "out", false)) {
        if (name == "timing.json") continue;
        const bool is_old = over_an_old_one && content == old_run.at(name);
        EXPECT_TRUE(is_old || content == new_run.at(name)) << name << " is of no run";
      }
      if (over_an_old_one) {
        EXPECT_EQ(names_of(contents_of(folder_ / "out", false)), kRunFiles);
      }
    }
    EXPECT_GE(killed, 5) << "too late to see anything";
  }

  TemporaryFolder folder_;
};

TEST_F(KilledRunTest, LeavesWholeFilesWhileItDrives) {
  kill_often("2000");
}

TEST_F(KilledRunTest, LeavesWholeFilesWhileItWrites) {
  kill_often("60");
}

TEST_F(KilledRunTest, LeavesARecordingThatCanBeReplayedAndTheOlderOneBesideIt) {
  ASSERT_EQ(scrubjay(explore("1", "30", "out")).code, 0);
  const std::string older = content_of(folder_ / "run.oilog");
  Call call(explore("2", "10000000", "out"));
  while (!std::filesystem::exists(folder_ / "run.oilog~") || content_of(folder_ / "run.oilog").size() < 200'000) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  call.send(SIGKILL);
  EXPECT_EQ(call.wait().signal, SIGKILL);
  EXPECT_EQ(content_of(folder_ / "run.oilog~"), older);
  EXPECT_EQ(scrubjay({"replay", (folder_ / "run.oilog").string(), "--out", (folder_ / "again").string()}).code, 0);
  EXPECT_EQ(broken_result(folder_ / "again"), "");
  EXPECT_GT(metrics_of(folder_ / "again").at("simulated_time_s"), 30.0);
}

TEST_F(KilledRunTest, LeavesAWholeRecordingBesideItHoweverOftenItIsKilled) {
  const std::filesystem::path recording = folder_ / "run.oilog";
  ASSERT_EQ(scrubjay(explore("1", "30", "out")).code, 0);
  const std::string whole = content_of(recording);
  for (int i = 0; i < 3; ++i) {
    SCOPED_TRACE(i);
    const std::string before = content_of(recording).substr(0, 1000);
    Call call(explore(std::to_string(i + 2), "10000000", "out"));
    while (content_of(recording).starts_with(before) || content_of(recording).size() < 50'000) {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    call.send(SIGKILL);
    EXPECT_EQ(call.wait().signal, SIGKILL);
    EXPECT_TRUE(content_of(folder_ / "run.oilog~") == whole);
  }
  ASSERT_EQ(scrubjay(explore("9", "30", "out")).code, 0);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "run.oilog~")) << "the new one is whole";
}

/// Both ways of asking a run to stop, and both paces of one.
class StoppedRunTest : public testing::TestWithParam<std::tuple<int, std::string>> {};

TEST_P(StoppedRunTest, LeavesCompleteResultsOfTheRunSoFar) {
  const auto& [signal, speed] = GetParam();
  const TemporaryFolder folder;
  const std::string log = (folder / "run.oilog").string();
  Call call({"explore", own_world("apartment"), "--strategy", "random-2", "--noise", "hard-floor", "--max-time", "1e7",
             "--speed", speed, "--out", (folder / "out").string(), "--record", log});
  // The recording begins once the program listens to signals.
  while (!std::filesystem::exists(log) || std::filesystem::file_size(log) < 20'000) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  call.send(signal);
  const Outcome outcome = call.wait();
  // Whoever asks a run to stop gets what was asked for: no failure.
  EXPECT_EQ(outcome.code, 0) << outcome.signal;
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out, testing::StartsWith("stopped after "));
  EXPECT_EQ(names_of(contents_of(folder / "out")), kRunFiles);
  EXPECT_EQ(broken_result(folder / "out"), "");
  const nlohmann::json metrics = metrics_of(folder / "out");
  EXPECT_EQ(metrics.at("ended"), "stopped");
  EXPECT_GT(metrics.at("simulated_time_s"), 1.0);

  EXPECT_EQ(scrubjay({"replay", log, "--quiet", "--out", (folder / "again").string()}).code, 0);
  EXPECT_EQ(metrics_of(folder / "again").at("ended"), "stopped");
  EXPECT_EQ(content_of(folder / "again/map.pgm"), content_of(folder / "out/map.pgm"));
  EXPECT_EQ(content_of(folder / "again/trajectory.tum"), content_of(folder / "out/trajectory.tum"));
}

INSTANTIATE_TEST_SUITE_P(Signals, StoppedRunTest,
                         testing::Combine(testing::Values(SIGINT, SIGTERM), testing::Values("0", "200")));

TEST(StoppedComparisonTest, FailsInOneLineAndWritesNoTable) {
  const TemporaryFolder folder;
  Call call({"compare", own_world("apartment"), "--strategies", "random-2", "--seeds", "2", "--max-time", "1e7",
             "--csv", (folder / "table.csv").string()});
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  call.send(SIGINT);
  const Outcome outcome = call.wait();
  if (outcome.signal == SIGINT) GTEST_SKIP() << "stopped before it began";
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(outcome.out, "");
  EXPECT_TRUE(is_one_line(outcome.err)) << outcome.err;
  EXPECT_EQ(folder.file_count(), 0u);
}

}  // namespace
}  // namespace scrubjay
