#include <gtest/gtest.h>

#include <scrubjay/behavior/wander.hpp>
#include <scrubjay/io/world_reader.hpp>
#include <scrubjay/localization/localizer.hpp>
#include <set>
#include <string>
#include <tuple>

#include "burger.hpp"

namespace scrubjay::test {
namespace {

class WanderDriveTest : public ::testing::TestWithParam<std::tuple<const char*, const char*>> {};

TEST_P(WanderDriveTest, TenMinutesWithoutABump) {
  const auto [name, profile] = GetParam();
  World world = read_world(std::filesystem::path(SCRUBJAY_SOURCE_DIR) / "worlds" / (std::string(name) + ".yaml"));
  const Pose2 start = *world.start;
  Burger burger(std::move(world), start, Burger::noise(profile), 7, {.motion_distortion = true});
  DeadReckoning localizer(Burger::spec().model.drive);
  Wander wander(Burger::spec().model, Random(7).fork(1));
  std::set<std::pair<int, int>> visited;  // squares of half a metre
  const sim::Truth& truth = burger.robot.truth();
  while (static_cast<double>(truth.ticks) * Burger::kTick < 600.0) {
    const Frame frame = *burger.robot.next();
    burger.robot.drive(wander.decide({frame, localizer.update(frame), {}, {}}).motion);
    visited.emplace(static_cast<int>(truth.pose.x / 0.5), static_cast<int>(truth.pose.y / 0.5));
  }
  EXPECT_EQ(truth.bumps, 0u);
  EXPECT_GT(truth.distance, 60.0) << "at 0.22 m/s it could be 132 m";
  EXPECT_GT(visited.size(), 20u);
}

INSTANTIATE_TEST_SUITE_P(Worlds, WanderDriveTest,
                         ::testing::Combine(::testing::Values("room", "cluttered_flat", "corridor_flat"),
                                            ::testing::Values("none", "hard-floor")));

}  // namespace
}  // namespace scrubjay::test
