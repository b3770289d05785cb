#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <io/temporary_folder.hpp>
#include <random>

#include "command_line.hpp"
#include "run_folder.hpp"

namespace scrubjay {
namespace {

using testing::HasSubstr;

/// A way of exploring.
struct ReplayedWay {
  std::string strategy;
  std::string noise;
  std::string model;
};

class ReplayTest : public testing::TestWithParam<ReplayedWay> {
 protected:
  void record(const ReplayedWay& way, const std::string& time) const {
    const Outcome outcome = scrubjay_in(
        folder_.path(), {"explore", own_world("cluttered_flat"), "--strategy", way.strategy, "--noise", way.noise,
                         "--model", way.model, "--max-time", time, "--out", "live", "--record", "run.oilog"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
  }
  Outcome replay(const std::string& log, const std::string& out) const {
    return scrubjay_in(folder_.path(), {"replay", log, "--out", out});
  }

  TemporaryFolder folder_;
};

TEST_P(ReplayTest, MapsTheSameToTheByte) {
  record(GetParam(), "150");
  const Outcome outcome = replay("run.oilog", "again");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(broken_result(folder_ / "again"), "");
  const Contents live = contents_of(folder_ / "live");
  const Contents again = contents_of(folder_ / "again");
  for (const char* name : {"map.pgm", "map.yaml", "map.png", "trajectory.tum", "scenario.yaml"}) {
    EXPECT_EQ(again.at(name), live.at(name)) << name;
  }
  for (const char* figure : {"ended", "simulated_time_s", "distance_m", "bumps", "coverage", "wall_recall"}) {
    EXPECT_EQ(metrics_of(folder_ / "again").at(figure), metrics_of(folder_ / "live").at(figure)) << figure;
  }
}

INSTANTIATE_TEST_SUITE_P(Ways, ReplayTest,
                         testing::Values(ReplayedWay{"random-2", "none", "roomba-600"},
                                         ReplayedWay{"random-3", "hard-floor", "create-1"},
                                         ReplayedWay{"random-look", "carpet", "create-2"},
                                         ReplayedWay{"random-aware", "uncalibrated", "roomba-600"},
                                         ReplayedWay{"reactive", "carpet", "create-1"},
                                         ReplayedWay{"edge-follow", "none", "roomba-600"},
                                         ReplayedWay{"edge-follow", "hard-floor", "create-2"},
                                         ReplayedWay{"edge-follow", "carpet", "create-1"}),
                         [](const auto& way) { return "ReplayedWay" + std::to_string(way.index); });

using CutRecordingTest = ReplayTest;

TEST_F(CutRecordingTest, IsReplayedUpToTheCutOrRefusedInOneLine) {
  record({"edge-follow", "hard-floor", "roomba-600"}, "60");
  const std::string whole = content_of(folder_ / "run.oilog");
  std::vector<std::size_t> lengths{0, 1, 8, 9, 50, whole.size() - 1};
  std::mt19937 random(1);
  for (int i = 0; i < 20; ++i) lengths.push_back(random() % whole.size());
  int replayed = 0;
  int told = 0;
  for (const std::size_t length : lengths) {
    SCOPED_TRACE(length);
    const std::string out = "out" + std::to_string(length);
    folder_.write("cut.oilog", whole.substr(0, length));
    const Outcome outcome = replay("cut.oilog", out);
    // A cut behind all that the run needed isn't looked for.
    if (outcome.code != 0 || !outcome.err.empty()) {
      EXPECT_TRUE(is_one_line(outcome.err)) << outcome.err;
      EXPECT_THAT(outcome.err, HasSubstr("cut"));
      ++told;
    }
    EXPECT_EQ(broken_result(folder_ / out), "");
    if (outcome.code == 0) {
      ++replayed;
      EXPECT_TRUE(contents_of(folder_ / out).contains("metrics.json"));
      EXPECT_LE(metrics_of(folder_ / out).at("simulated_time_s"), metrics_of(folder_ / "live").at("simulated_time_s"));
    } else {
      const bool has_scenario = outcome.err.find("before its first whole frame") != std::string::npos;
      EXPECT_EQ(outcome.code, has_scenario ? 1 : 2);
      EXPECT_FALSE(std::filesystem::exists(folder_ / out / "metrics.json"));
    }
  }
  EXPECT_GE(replayed, 15);
  EXPECT_GE(told, 15);
}

TEST_F(CutRecordingTest, IsReplayedUpToWhereItIsDamaged) {
  record({"edge-follow", "none", "roomba-600"}, "60");
  std::string content = content_of(folder_ / "run.oilog");
  content[content.size() / 2] ^= 0x10;
  folder_.write("bad.oilog", content);
  const Outcome outcome = replay("bad.oilog", "out");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_TRUE(is_one_line(outcome.err)) << outcome.err;
  const double half = metrics_of(folder_ / "out").at("simulated_time_s");
  EXPECT_GT(half, 10.0);
  EXPECT_LT(half, 50.0);
}

TEST_F(CutRecordingTest, IsReplayedWithoutItsWorld) {
  std::filesystem::copy_file(own_world("room"), folder_ / "here.yaml");
  ASSERT_EQ(scrubjay_in(folder_.path(),
                        {"explore", "here.yaml", "--max-time", "30", "--out", "live", "--record", "run.oilog"})
                .code,
            0);
  const auto expect_unscored = [&](const Words& words, const std::string& why) {
    const Outcome outcome = scrubjay_in(folder_.path(), words);
    EXPECT_EQ(outcome.code, 0);
    EXPECT_TRUE(is_one_line(outcome.err)) << outcome.err;
    EXPECT_THAT(outcome.err, testing::AllOf(HasSubstr("run.oilog: replayed without scores: "), HasSubstr(why)));
    EXPECT_EQ(content_of(folder_ / "out/map.pgm"), content_of(folder_ / "live/map.pgm"));
    EXPECT_FALSE(metrics_of(folder_ / "out").contains("coverage")) << "there is no truth to score against";
  };
  const Words replayed{"replay", "run.oilog", "--out", "out"};
  const Words explored{"explore", "--robot", "log:run.oilog", "--out", "out"};
  folder_.write("here.yaml", "walls: 3\n");
  expect_unscored(replayed, "here.yaml:1");
  std::filesystem::remove(folder_ / "here.yaml");
  expect_unscored(replayed, "here.yaml: cannot read");
  expect_unscored(explored, "here.yaml: cannot read");
}

TEST_F(CutRecordingTest, IsReplayedByExploreWithTheSameWordsAndScores) {
  record({"edge-follow", "none", "roomba-600"}, "60");
  const std::string whole = content_of(folder_ / "run.oilog");
  folder_.write("cut.oilog", whole.substr(0, whole.size() / 2));
  const Outcome outcome = replay("cut.oilog", "out");
  const Outcome explored = scrubjay_in(folder_.path(), {"explore", "--robot", "log:cut.oilog", "--out", "out"});
  EXPECT_EQ(explored.code, 0);
  EXPECT_TRUE(is_one_line(explored.err)) << explored.err;
  EXPECT_EQ(explored.err, outcome.err);
  EXPECT_EQ(explored.out, outcome.out);
  EXPECT_THAT(explored.out, testing::AllOf(testing::StartsWith("end of the recording after "), HasSubstr("coverage")));
}

}  // namespace
}  // namespace scrubjay
