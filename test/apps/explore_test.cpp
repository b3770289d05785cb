#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <io/temporary_folder.hpp>

#include "command_line.hpp"
#include "run_folder.hpp"

namespace scrubjay {
namespace {

using testing::AllOf;
using testing::Ge;
using testing::HasSubstr;
using testing::Le;

/// Explores for a while, with more flags if any, and gives what is then in the folder.
Contents explored(const TemporaryFolder& folder, const std::string& out, const Words& more = {}) {
  Words words{"explore", own_world("apartment"), "--noise", "hard-floor", "--max-time", "90", "--out", out};
  words.insert(words.end(), more.begin(), more.end());
  const Outcome outcome = scrubjay_in(folder.path(), words);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  return contents_of(folder / out);
}

TEST(ExploreTest, LeavesAWholeFolderAndTellsWhereThePictureIs) {
  const TemporaryFolder folder;
  const Outcome outcome = scrubjay_in(folder.path(), {"explore", own_world("room"), "--max-time", "60"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out, HasSubstr("picture: out/room/map.png\n"));
  EXPECT_EQ(names_of(contents_of(folder / "out/room")), kRunFiles);
  EXPECT_EQ(broken_result(folder / "out/room"), "");
}

TEST(ExploreTest, MeasuresItself) {
  const TemporaryFolder folder;
  explored(folder, "out", {"--start", "4.1,3.3,0.25"});
  const nlohmann::json metrics = metrics_of(folder / "out");
  EXPECT_EQ(metrics.at("start"), (nlohmann::json{{"x", 4.1}, {"y", 3.3}, {"theta", 0.25}}));
  EXPECT_NEAR(metrics.at("simulated_time_s").get<double>(), 90.0, 0.02);
  EXPECT_GT(metrics.at("distance_m"), 1.0);
  EXPECT_GE(metrics.at("bumps"), 0);
  for (const char* share : {"coverage", "iou", "wall_precision", "wall_recall"}) {
    EXPECT_THAT(metrics.at(share).get<double>(), AllOf(Ge(0.0), Le(1.0))) << share;
  }
  EXPECT_GT(metrics.at("coverage"), 0.01);
  EXPECT_THAT(metrics.at("ate_m").get<double>(), AllOf(Ge(0.0), Le(0.5)));
  EXPECT_THAT(metrics.at("final_error_m").get<double>(), AllOf(Ge(0.0), Le(2.0)));
  EXPECT_EQ(metrics.at("ended"), "time limit");
}

TEST(ExploreTest, RepeatsARunToTheByte) {
  const TemporaryFolder folder;
  const Contents first = explored(folder, "first");
  EXPECT_EQ(repeatable(explored(folder, "second")), repeatable(first));
}

TEST(ExploreTest, GivesAnotherRunForAnotherSeed) {
  const TemporaryFolder folder;
  EXPECT_NE(explored(folder, "first").at("ground_truth.tum"),
            explored(folder, "second", {"--seed", "2"}).at("ground_truth.tum"));
}

TEST(ExploreTest, RepeatsARunFromItsScenario) {
  const TemporaryFolder folder;
  const Contents first = explored(folder, "first",
                                  {"--strategy", "random-aware", "--model", "create-1", "--seed",
                                   "18446744073709551615", "--start", "4.1,3.3,1.1", "--resolution", "0.04"});
  const Outcome outcome =
      scrubjay_in(folder.path(), {"explore", "--scenario", "first/scenario.yaml", "--out", "second"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(repeatable(contents_of(folder / "second")), repeatable(first));
}

TEST(ExploreTest, LetsAFlagOverruleTheScenario) {
  const TemporaryFolder folder;
  explored(folder, "first");
  EXPECT_EQ(
      scrubjay_in(folder.path(), {"explore", "--scenario", "first/scenario.yaml", "--seed", "7", "--out", "second"})
          .code,
      0);
  EXPECT_EQ(metrics_of(folder / "second").at("seed"), 7);
  EXPECT_EQ(metrics_of(folder / "second").at("noise"), "hard-floor");
}

TEST(ExploreTest, MapsTheSameWhetherItIsRecordedOrPacedOrNot) {
  const TemporaryFolder folder;
  const Contents plain = repeatable(explored(folder, "plain"));
  EXPECT_EQ(repeatable(explored(folder, "recorded", {"--record", "run.oilog"})), plain);
  EXPECT_EQ(repeatable(explored(folder, "paced", {"--speed", "300"})), plain);
}

TEST(ExploreTest, ReplacesAnOlderRunInTheSameFolder) {
  const TemporaryFolder folder;
  explored(folder, "out", {"--seed", "2"});
  const Contents again = explored(folder, "out");
  EXPECT_EQ(repeatable(again), repeatable(explored(folder, "fresh")));
}

}  // namespace
}  // namespace scrubjay
