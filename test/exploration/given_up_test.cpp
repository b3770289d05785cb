#include <gtest/gtest.h>

#include <scrubjay/exploration/given_up.hpp>
#include <scrubjay/mapping/growing_map.hpp>

namespace scrubjay {
namespace {

class GivenUpTest : public testing::Test {
 protected:
  GivenUpTest() { map.cover({0.0, 0.0}, 3.0); }
  void paint(const Point2& low, const Point2& high, LogOdds value) {
    const CellIndex from = map.view().geometry.cell_at(low);
    const CellIndex to = map.view().geometry.cell_at(high);
    for (std::int32_t y = from.y; y < to.y; ++y) {
      for (std::int32_t x = from.x; x < to.x; ++x) map.view()[{x, y}] = value;
    }
  }
  bool holds(const Point2& place) const { return memory.holds(map.view(), place); }

  GrowingMap map{0.05};
  GivenUpParams params;
  GivenUp memory{params};
  const Point2 goal{1.0, 1.0};
  const Point2 robot{-1.0, 0.0};
};

TEST_F(GivenUpTest, HoldsWhatIsNearAGoalThatWasGivenUp) {
  memory.remember(map.view(), goal, robot);
  EXPECT_TRUE(holds(goal));
  EXPECT_TRUE(holds({1.2, 1.1}));
  EXPECT_FALSE(holds({1.4, 1.0}));
}

TEST_F(GivenUpTest, ForgivesWhenTheMapAroundTheGoalChanges) {
  memory.remember(map.view(), goal, robot);
  paint({0.8, 0.8}, {1.2, 1.2}, -60);
  EXPECT_FALSE(holds(goal));
}

TEST_F(GivenUpTest, ForgivesWhenTheMapChangesWhereTheRobotWas) {
  memory.remember(map.view(), goal, robot);
  paint({-1.2, -0.2}, {-0.8, 0.2}, 60);
  EXPECT_FALSE(holds(goal));
}

TEST_F(GivenUpTest, DoesNotForgiveForAFewCellsOrWhatChangesElsewhere) {
  memory.remember(map.view(), goal, robot);
  paint({0.95, 0.95}, {1.05, 1.1}, -60);
  paint({-2.0, -2.0}, {-1.0, -1.0}, -60);
  EXPECT_TRUE(holds(goal));
}

TEST_F(GivenUpTest, MapsThatGrowChangeNothing) {
  memory.remember(map.view(), goal, robot);
  map.cover({5.0, -6.0}, 1.0);
  EXPECT_TRUE(holds(goal));
}

TEST_F(GivenUpTest, ForgivesOnRequest) {
  memory.remember(map.view(), goal, robot);
  memory.remember(map.view(), robot, goal);
  memory.forgive(goal);
  EXPECT_FALSE(holds(goal));
  EXPECT_TRUE(holds(robot));
}

TEST_F(GivenUpTest, WhatComesAndGoesIsHeldInTheEnd) {
  int forgiven = 0;
  for (int i = 0; i < 100; ++i) {
    memory.remember(map.view(), goal, robot);
    paint({0.85, 0.85}, {1.15, 1.15}, i % 2 == 0 ? -60 : 60);
    forgiven += holds(goal) ? 0 : 1;
  }
  EXPECT_GE(forgiven, 1);
  EXPECT_LE(forgiven, 3);
}

TEST_F(GivenUpTest, ForgivesForEverWhenAllIsDifferent) {
  for (int i = 0; i < 100; ++i) {
    memory.remember(map.view(), goal, robot);
    EXPECT_TRUE(holds(goal));
    paint({0.5, 0.5}, {1.5, 1.5}, i % 2 == 0 ? -60 : 60);
    EXPECT_FALSE(holds(goal)) << i;
  }
}

TEST_F(GivenUpTest, WhatHasToBeSeenAgainAndAgainIsNoise) {
  double stamp = 0.0;
  const auto see = [&] { memory.remember_seen(map.view(), goal, stamp += 2.0 * params.visit); };
  for (int i = 0; i < params.visits; ++i) {
    EXPECT_FALSE(holds(goal));
    see();
  }
  EXPECT_TRUE(holds(goal));
  paint({0.5, 0.5}, {1.5, 1.5}, -60);
  EXPECT_FALSE(holds(goal));
}

TEST_F(GivenUpTest, AShadowThatMovesAsTheRobotComesIsSeenOnce) {
  for (int i = 0; i < 10 * params.visits; ++i) {
    memory.remember_seen(map.view(), goal, 0.05 * params.visit * i / params.visits);
    EXPECT_FALSE(holds(goal)) << i;
  }
}

TEST_F(GivenUpTest, WhatShowsMoreEachTimeIsNoNoise) {
  for (int i = 0; i < 2 * params.visits; ++i) {
    paint({0.6, 0.6}, {1.4, 0.6 + 0.14 * (i + 1)}, -60);
    memory.remember_seen(map.view(), goal, 2.0 * params.visit * i);
    EXPECT_FALSE(holds(goal)) << i;
    if (i >= 4) break;  // all is known
  }
}

}  // namespace
}  // namespace scrubjay
