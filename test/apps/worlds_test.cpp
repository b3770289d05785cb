#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <io/temporary_folder.hpp>

#include "command_line.hpp"
#include "run_folder.hpp"

namespace scrubjay {
namespace {

namespace fs = std::filesystem;

/// Explores for a minute, and expects whole results of it.
void expect_explored(const fs::path& world, const std::string& strategy) {
  SCOPED_TRACE(world.filename().string() + ", " + strategy);
  const TemporaryFolder folder;
  const Outcome outcome = scrubjay_in(folder.path(), {"explore", fs::absolute(world).string(), "--strategy", strategy,
                                                      "--max-time", "60", "--out", "out"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(names_of(contents_of(folder / "out")), kRunFiles);
  EXPECT_EQ(broken_result(folder / "out"), "");
  const nlohmann::json metrics = metrics_of(folder / "out");
  EXPECT_LE(metrics.at("simulated_time_s"), 60.02);
  EXPECT_GT(metrics.at("distance_m"), 0.5);
}

/// Files of a folder that end so, in order; at most `count`.
std::vector<fs::path> files_in(const fs::path& folder, const std::string& ending, std::size_t count) {
  std::vector<fs::path> files;
  if (!fs::exists(folder)) return files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ending) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  files.resize(std::min(files.size(), count));
  return files;
}

class OwnWorldsTest : public testing::TestWithParam<std::string> {};

TEST_P(OwnWorldsTest, AreExploredByEveryStrategy) {
  for (const char* strategy : {"random-2", "random-3", "random-look", "random-aware", "reactive", "wander",
                               "edge-follow", "contact-frontier"}) {
    expect_explored(own_world(GetParam()), strategy);
  }
}

INSTANTIATE_TEST_SUITE_P(Own, OwnWorldsTest, testing::ValuesIn([] {
                           std::vector<std::string> names;
                           for (const fs::path& world : files_in(SCRUBJAY_SOURCE_DIR "/worlds", ".yaml", 100)) {
                             names.push_back(world.stem().string());
                           }
                           return names;
                         }()),
                         [](const auto& world) { return world.param; });

TEST(OtherWorldsTest, FloorPlansAreExplored) {
  const std::vector<fs::path> plans = files_in(SCRUBJAY_SHARED_DATA "/houseexpo", ".json", 3);
  if (plans.empty()) GTEST_SKIP() << "no floor plans here";
  for (const fs::path& plan : plans) expect_explored(plan, "edge-follow");
}

TEST(OtherWorldsTest, MapsAreExplored) {
  const fs::path folder = SCRUBJAY_SHARED_DATA "/maps";
  if (!fs::exists(folder)) GTEST_SKIP() << "no maps here";
  for (const char* map : {"tb3_sandbox.yaml", "depot.yaml", "warehouse.yaml"})
    expect_explored(folder / map, "edge-follow");
}

TEST(OtherWorldsTest, AMapOfARunIsAWorldToo) {
  const TemporaryFolder folder;
  ASSERT_EQ(scrubjay_in(folder.path(), {"explore", own_world("room"), "--out", "out"}).code, 0);
  expect_explored(folder / "out/map.yaml", "edge-follow");
}

}  // namespace
}  // namespace scrubjay
