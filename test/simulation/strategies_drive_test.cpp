#include <gmock/gmock.h>

#include <functional>
#include <scrubjay/io/robot_file.hpp>
#include <scrubjay/io/world_reader.hpp>
#include <scrubjay/localization/localizer.hpp>
#include <scrubjay/mapping/contact_mapper.hpp>
#include <scrubjay/mission/mission.hpp>
#include <scrubjay/mission/strategies.hpp>
#include <scrubjay/mission/track.hpp>
#include <scrubjay/robot/oi_robot.hpp>
#include <scrubjay/simulation/simulated_roomba.hpp>
#include <set>

#include "stage.hpp"

namespace scrubjay::test {
namespace {

std::filesystem::path in_tree(const char* path) {
  return std::filesystem::path(SCRUBJAY_SOURCE_DIR) / path;
}

/// A whole exploration in simulation.
struct Exploration {
  Exploration(World scenery, std::string_view strategy, const sim::NoiseProfile& noise, std::uint64_t seed)
      : world(std::move(scenery)),
        index(solid_segments(world)),
        roomba(world, index, spec, noise, Random(seed).fork(0), *world.start),
        behavior(make_strategy(strategy, {.robot = spec.model, .random = Random(seed).fork(1)})) {}

  Report run(double seconds, std::function<void(const sim::Truth&)> each_tick) {
    struct Watcher final : Observer {
      void notify(const Snapshot&) override { act(); }
      std::function<void()> act;
    };
    Watcher watcher;
    watcher.act = [&] { each_tick(roomba.truth()); };
    OiRobot robot(roomba, spec.model);
    DeadReckoning localizer(spec.model.drive);
    ContactMapper mapper(spec.model, 0.05);
    Mission mission(robot, localizer, mapper, *behavior, {seconds});
    mission.watch(watcher);
    mission.watch(track);
    return mission.run({});
  }

  World world;
  SegmentIndex index;
  sim::RobotSpec spec;
  sim::SimulatedRoomba roomba;
  std::unique_ptr<Behavior> behavior;
  Track track;
};

World small_room() {
  World world = room(2.5, 2.0);
  world.furniture = {{"box", {box({1.8, 1.4}, {0.5, 0.4}, 0.4)}}, {"leg", {box({0.9, 1.3}, {0.04, 0.04}, 0.0)}}};
  world.start = Pose2{0.5, 0.5, 0.3};
  return world;
}

class StrategyDriveTest : public ::testing::TestWithParam<std::tuple<std::string_view, const char*>> {};

TEST_P(StrategyDriveTest, DrivesAMinuteWithoutCrossingAWallTheSameForASeed) {
  const auto [strategy, profile] = GetParam();
  const sim::NoiseProfile noise = read_noise(in_tree("urdf/noise.yaml"), profile);
  std::vector<StampedPose> first;
  for (int run = 0; run < 2; ++run) {
    Exploration exploration(small_room(), strategy, noise, 3);
    double least = 1.0;
    const Report report = exploration.run(60.0, [&](const sim::Truth& truth) {
      least = std::min(least, exploration.index.distance(truth.pose.position(), 1.0));
    });
    EXPECT_GT(least, kRadius - 0.0085);
    EXPECT_EQ(report.ended, Ended::TimeLimit);
    EXPECT_NEAR(report.time, 60.0, 0.1);
    EXPECT_GT(report.distance, 0.5);
    EXPECT_GT(exploration.track.points().size(), 500u);
    if (run == 0) first = exploration.track.points();
    EXPECT_EQ(exploration.track.points(), first);
  }
}

INSTANTIATE_TEST_SUITE_P(All, StrategyDriveTest,
                         ::testing::Combine(::testing::ValuesIn(strategy_names(RobotModel{})),
                                            ::testing::Values("none", "hard-floor")));

TEST(StrategyDriveTest, AnotherSeedDrivesAnotherWay) {
  const sim::NoiseProfile none;
  Exploration one(small_room(), "random-3", none, 1);
  Exploration two(small_room(), "random-3", none, 2);
  one.run(30.0, [](const sim::Truth&) {});
  two.run(30.0, [](const sim::Truth&) {});
  EXPECT_NE(one.track.points(), two.track.points());
}

/// Where the hall ends and the room behind begins [m].
constexpr double kWayOut = 3.2;

TEST(ReactiveTrapTest, ReactiveCirclesForEver) {
  Exploration exploration(read_world(in_tree("worlds/reactive_trap.yaml")), "reactive", {}, 1);
  std::set<std::pair<int, int>> early;
  std::set<std::pair<int, int>> late;
  double farthest = 0.0;
  const Report report = exploration.run(3600.0, [&](const sim::Truth& truth) {
    const std::pair place{static_cast<int>(truth.pose.x / 0.1), static_cast<int>(truth.pose.y / 0.1)};
    (truth.ticks < static_cast<std::uint64_t>(ticks_in(1800.0)) ? early : late).insert(place);
    farthest = std::max(farthest, truth.pose.x);
  });
  EXPECT_EQ(report.ended, Ended::TimeLimit);
  EXPECT_GT(report.distance, 100.0) << "it drives all the time";
  EXPECT_LT(farthest, kWayOut);
  std::set<std::pair<int, int>> both = early;
  both.insert(late.begin(), late.end());
  EXPECT_LE(both.size(), early.size() + early.size() / 20) << "the second half hour shows it next to nothing new";
}

TEST(ReactiveTrapTest, EdgeFollowGetsOut) {
  Exploration exploration(read_world(in_tree("worlds/reactive_trap.yaml")), "edge-follow", {}, 1);
  double farthest = 0.0;
  exploration.run(1200.0, [&](const sim::Truth& truth) { farthest = std::max(farthest, truth.pose.x); });
  EXPECT_GT(farthest, kWayOut + 1.0);
}

}  // namespace
}  // namespace scrubjay::test
