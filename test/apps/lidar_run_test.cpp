#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <io/temporary_folder.hpp>

#include "command_line.hpp"
#include "run_folder.hpp"

namespace scrubjay {
namespace {

using testing::HasSubstr;

/// Explores with a TurtleBot3 Burger, and gives what it printed.
Outcome explored_world(const TemporaryFolder& folder, const std::string& world, const Words& more = {}) {
  Words words{"explore", own_world(world), "--model", "turtlebot3-burger", "--out", "out"};
  words.insert(words.end(), more.begin(), more.end());
  Outcome outcome = scrubjay_in(folder.path(), words);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return outcome;
}

TEST(LidarRunTest, ExploresAFlatToItsEnd) {
  const TemporaryFolder folder;
  const Outcome outcome = explored_world(folder, "apartment", {"--noise", "hard-floor"});
  EXPECT_THAT(outcome.out, HasSubstr("done after"));
  EXPECT_EQ(broken_result(folder / "out"), "");
  const nlohmann::json metrics = metrics_of(folder / "out");
  EXPECT_EQ(metrics.at("strategy"), "frontiers");
  EXPECT_EQ(metrics.at("localizer"), "scan-matching");
  EXPECT_EQ(metrics.at("ended"), "done");
  EXPECT_EQ(metrics.at("contacts"), 0);
  EXPECT_GE(metrics.at("coverage"), 0.99);
  EXPECT_GE(metrics.at("iou"), 0.95);
  EXPECT_LE(metrics.at("ate_m"), 0.05);
}

TEST(LidarRunTest, RepeatsARunToTheByte) {
  const TemporaryFolder folder;
  const Words flags{"--noise", "hard-floor", "--motion-distortion", "--max-time", "60"};
  explored_world(folder, "room", flags);
  const Contents first = contents_of(folder / "out");
  explored_world(folder, "room", flags);
  EXPECT_EQ(repeatable(contents_of(folder / "out")), repeatable(first));
  const Outcome again = scrubjay_in(folder.path(), {"explore", "--scenario", "out/scenario.yaml", "--out", "again"});
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(repeatable(contents_of(folder / "again")), repeatable(first));
}

TEST(LidarRunTest, DrivesHomeWhenAsked) {
  const TemporaryFolder folder;
  explored_world(folder, "room", {"--return-home"});
  const nlohmann::json pose = metrics_of(folder / "out").at("pose");
  EXPECT_NEAR(pose.at("x").get<double>(), 0.0, 0.1);
  EXPECT_NEAR(pose.at("y").get<double>(), 0.0, 0.1);
}

TEST(LidarRunTest, StaysWithinBoundsAndTellsWhatIsOutside) {
  const TemporaryFolder folder;
  const Outcome outcome = explored_world(folder, "family_house", {"--within", "-1.5,-1.5,1.5,1.5"});
  EXPECT_THAT(outcome.out, HasSubstr("out of bounds"));
  const nlohmann::json metrics = metrics_of(folder / "out");
  EXPECT_EQ(metrics.at("ended"), "done");
  EXPECT_FALSE(metrics.at("left").empty());
  for (const nlohmann::json& left : metrics.at("left")) {
    for (const char* key : {"x", "y", "size_m", "why"}) EXPECT_TRUE(left.contains(key)) << key;
  }
}

TEST(LidarRunTest, WritesAnOctreeToo) {
  const TemporaryFolder folder;
  explored_world(folder, "room", {"--max-time", "20", "--octomap", "map.bt", "--height", "0.5"});
  EXPECT_THAT(contents_of(folder.path()).at("map.bt"), HasSubstr("# Octomap OcTree binary file"));
}

TEST(LidarRunTest, MapsOnlyTheConeThatIsAskedFor) {
  const TemporaryFolder folder;
  explored_world(folder, "apartment", {"--strategy", "wander", "--max-time", "1"});
  const double all = metrics_of(folder / "out").at("coverage");
  explored_world(folder, "apartment", {"--strategy", "wander", "--max-time", "1", "--forward-cone", "10"});
  const double cone = metrics_of(folder / "out").at("coverage");
  EXPECT_GT(cone, 0.0);
  EXPECT_LT(cone, 0.3 * all);
}

}  // namespace
}  // namespace scrubjay
