#include <gtest/gtest.h>

#include <scrubjay/behavior/reactive.hpp>

#include "situations.hpp"

namespace scrubjay::test {
namespace {

TEST(ReactiveTest, DrivesUntilSomethingIsAheadAndTurnsUntilNothingIs) {
  Reactive strategy({});
  const Frame blocked = lit_frame(LightSensor::CenterLeft, 0.03);
  EXPECT_EQ(decide(strategy, quiet_frame()).motion, (Motion{0.1, 0.0}));
  EXPECT_EQ(decide(strategy, blocked).motion, (Motion{0.0, 0.5}));
  EXPECT_EQ(decide(strategy, blocked).motion, (Motion{0.0, 0.5}));
  EXPECT_EQ(decide(strategy, quiet_frame()).motion, (Motion{0.1, 0.0}));
}

TEST(ReactiveTest, TurnsLeftWhateverTheSide) {
  for (const LightSensor sensor : {LightSensor::FrontLeft, LightSensor::FrontRight}) {
    Reactive strategy({});
    EXPECT_GT(decide(strategy, lit_frame(sensor, 0.03)).motion.angular, 0.0);
  }
}

TEST(ReactiveTest, AWallAlongOneSideDoesNotStopIt) {
  Reactive strategy({});
  EXPECT_EQ(decide(strategy, lit_frame(LightSensor::Left, 0.02)).motion, (Motion{0.1, 0.0}));
}

TEST(ReactiveTest, TurnsAwayFromCliffsAndVirtualWalls) {
  Reactive strategy({});
  EXPECT_EQ(decide(strategy, cliff_frame(CliffSensor::Right)).motion.linear, 0.0);
  Frame fence = quiet_frame();
  fence.virtual_wall = true;
  EXPECT_EQ(decide(strategy, fence).motion.linear, 0.0);
}

}  // namespace
}  // namespace scrubjay::test
