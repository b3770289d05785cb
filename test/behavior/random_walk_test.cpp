#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <scrubjay/behavior/random_walk.hpp>
#include <string>

#include "situations.hpp"

namespace scrubjay::test {
namespace {

constexpr double kTick = 0.015;  // [s]

/// How often a strategy starts each option while the robot senses the same all the time.
template <typename Strategy>
std::map<std::string, int> options_chosen(const Frame& sensed, int choices = 3000) {
  // Options are made to last less than a tick, so that each tick shows a choice.
  RandomWalkParams params;
  params.forward_distance = 1e-6;
  params.turn_angle = 1e-6;
  Strategy strategy({}, Random(7), params);
  std::map<std::string, int> count;
  for (int i = 0; i < choices; ++i) {
    Frame frame = sensed;
    frame.stamp = kTick * i;
    ++count[decide(strategy, frame).doing];
  }
  return count;
}

void expect_shares(const std::map<std::string, int>& count, const std::map<std::string, double>& shares) {
  EXPECT_EQ(count.size(), shares.size());
  int total = 0;
  for (const auto& [option, times] : count) total += times;
  for (const auto& [option, share] : shares) {
    ASSERT_TRUE(count.contains(option)) << option;
    EXPECT_NEAR(count.at(option), share * total, 0.05 * total) << option;
  }
}

TEST(RandomWalkTest, OptionsTakeTheirFullTime) {
  Random3 strategy({}, Random(3));
  // 0.3 m at 0.1 m/s takes 3 s, 0.5 rad at 0.5 rad/s takes 1 s; two of the same in a row take twice that.
  std::string doing;
  double since = 0.0;
  for (int i = 0; i < 20'000; ++i) {
    const std::string now = decide(strategy, quiet_frame(kTick * i)).doing;
    if (now == doing) continue;
    const double whole = doing == "forward" ? 3.0 : 1.0;
    const double lasted = kTick * i - since;
    if (!doing.empty()) {
      const double times = std::max(1.0, std::round(lasted / whole));
      EXPECT_NEAR(lasted, times * whole, times * 1.01 * kTick) << doing;
    }
    doing = now;
    since = kTick * i;
  }
}

TEST(RandomWalkTest, SpeedsAreTheThesiss) {
  Random3 strategy({}, Random(3));
  std::map<std::string, Motion> motions;
  for (int i = 0; i < 20'000; ++i) {
    const Decision decision = decide(strategy, quiet_frame(kTick * i));
    EXPECT_FALSE(decision.done);
    motions[decision.doing] = decision.motion;
  }
  const std::map<std::string, Motion> wanted{
      {"forward", {0.1, 0.0}}, {"turning left", {0.0, 0.5}}, {"turning right", {0.0, -0.5}}};
  EXPECT_EQ(motions, wanted);
}

TEST(RandomWalkTest, ATouchEndsAForwardButNotATurn) {
  Random2 strategy({}, Random(5));
  Frame touch = quiet_frame();
  touch.bump_left = true;
  int blocked = 0;
  for (int i = 0; i < 4000; ++i) {
    touch.stamp = kTick * i;
    const Decision decision = decide(strategy, touch);
    EXPECT_EQ(decision.motion.linear, 0.0) << "never pushes";
    blocked += std::string_view(decision.doing) == "blocked";
  }
  EXPECT_GT(blocked, 10) << "random-2 can't know that forward is blocked before it tries";
}

TEST(RandomWalkTest, CliffsAndVirtualWallsEndAForward) {
  Frame fence = quiet_frame();
  fence.virtual_wall = true;
  for (Frame frame : {fence, cliff_frame(CliffSensor::FrontLeft)}) {
    Random2 strategy({}, Random(5));
    for (int i = 0; i < 2000; ++i) {
      frame.stamp = kTick * i;
      EXPECT_EQ(decide(strategy, frame).motion.linear, 0.0);
    }
  }
}

TEST(RandomWalkTest, TheSameSeedChoosesTheSame) {
  Random3 one({}, Random(11));
  Random3 same({}, Random(11));
  Random3 other({}, Random(12));
  bool differs = false;
  for (int i = 0; i < 5000; ++i) {
    const Frame frame = quiet_frame(kTick * i);
    const Motion motion = decide(one, frame).motion;
    EXPECT_EQ(motion, decide(same, frame).motion);
    differs |= !(motion == decide(other, frame).motion);
  }
  EXPECT_TRUE(differs);
}

TEST(Random2Test, TossesACoin) {
  expect_shares(options_chosen<Random2>(quiet_frame()), {{"forward", 0.5}, {"turning left", 0.5}});
}

TEST(Random3Test, ThrowsAThreeSidedDie) {
  expect_shares(options_chosen<Random3>(quiet_frame()),
                {{"forward", 1.0 / 3}, {"turning left", 1.0 / 3}, {"turning right", 1.0 / 3}});
}

TEST(RandomLookTest, GoesForwardOnlyIfNothingIsAhead) {
  expect_shares(options_chosen<RandomLook>(quiet_frame()), {{"forward", 0.5}, {"turning left", 0.5}});
  expect_shares(options_chosen<RandomLook>(lit_frame(LightSensor::CenterRight, 0.03)), {{"turning left", 1.0}});
}

TEST(RandomAwareTest, NeverTurnsTowardsABlockedSide) {
  expect_shares(options_chosen<RandomAware>(quiet_frame()),
                {{"forward", 1.0 / 3}, {"turning left", 1.0 / 3}, {"turning right", 1.0 / 3}});
  expect_shares(options_chosen<RandomAware>(lit_frame(LightSensor::Left, 0.03)),
                {{"forward", 0.5}, {"turning right", 0.5}});
  expect_shares(options_chosen<RandomAware>(lit_frame(LightSensor::FrontRight, 0.03)), {{"turning left", 1.0}});
}

TEST(RandomAwareTest, BlockedOnBothSidesItKeepsTurningOneWay) {
  Frame between = lit_frame(LightSensor::FrontLeft, 0.03);
  between.light_signal[static_cast<std::size_t>(LightSensor::Right)] = light_signal_at(0.03, {});
  std::map<std::string, int> ways;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    RandomAware strategy({}, Random(seed));
    const std::string first = decide(strategy, between).doing;
    ++ways[first];
    for (int i = 1; i < 600; ++i) {
      between.stamp = kTick * i;
      EXPECT_EQ(decide(strategy, between).doing, first);
    }
    between.stamp = 0.0;
  }
  EXPECT_GT(ways["turning left"], 5);
  EXPECT_GT(ways["turning right"], 5);
}

}  // namespace
}  // namespace scrubjay::test
