#include <gtest/gtest.h>

#include <scrubjay/exploration/leftover_borders.hpp>

#include "planning/map_drawing.hpp"

namespace scrubjay::test {
namespace {

/// A map of `scale` x `scale` cells a character with the robot at 'r'.
std::vector<Leftover> leftovers_of(const std::vector<std::string>& rows, const SweepGainParams& params = {},
                                   const std::vector<CellIndex>& tried = {}, int scale = 4) {
  const MapDrawing map(rows, 0.05, scale);
  SweepGain gain(params);
  gain.update(map.view(), map.all());
  for (const CellIndex cell : tried) {
    for (int i = 0; i < params.tries; ++i) gain.tried(cell);
  }
  CostMapParams cost_params;
  cost_params.radius = 0.1735;
  cost_params.margin = 0.0;
  cost_params.through_unknown = true;
  CostMap costs(cost_params);
  costs.update(map.view(), map.all());
  PathSearch ways;
  ways.spread(costs.view(), map.cell('r'));
  return borders_left(gain, costs.view(), ways, 0.15);
}

TEST(LeftoverBordersTest, NothingIsLeftOfARoomThatIsKnown) {
  EXPECT_TRUE(leftovers_of({"######", "#r...#", "#....#", "######"}).empty());
}

TEST(LeftoverBordersTest, WhatCouldBeSweptIsNotListed) {
  EXPECT_TRUE(leftovers_of({"#######", "#r..??#", "#...??#", "#######"}).empty());
}

TEST(LeftoverBordersTest, ASlotMayBeTooNarrow) {
  // Of 0.3 m; 4 of its 6 cells don't lie at its walls.
  const auto left = leftovers_of({"##############",  //
                                  "#......#######",  //
                                  "#r.......????#",  //
                                  "#........????#",  //
                                  "#......#######",  //
                                  "##############"},
                                 {}, {}, 3);
  ASSERT_EQ(left.size(), 1u);
  EXPECT_STREQ(left[0].why, "too narrow for the robot");
  EXPECT_NEAR(left[0].where.x(), 1.38, 0.03);
  EXPECT_NEAR(left[0].where.y(), 0.45, 0.03);
  EXPECT_NEAR(left[0].size, 0.2, 0.01);
}

TEST(LeftoverBordersTest, ThereMayBeNoWay) {
  const auto left = leftovers_of({"##############",  //
                                  "#....##...???#",  //
                                  "#r...##...???#",  //
                                  "#....##...???#",  //
                                  "##############"});
  ASSERT_EQ(left.size(), 1u);
  EXPECT_STREQ(left[0].why, "no way there");
}

TEST(LeftoverBordersTest, SaysWhatWasGivenUpAndWhatIsOutOfBounds) {
  const std::vector<std::string> rows{"##########",  //
                                      "#....????#",  //
                                      "#r...????#",  //
                                      "#....????#",  //
                                      "##########"};
  std::vector<CellIndex> tried;
  for (std::int32_t y = 4; y < 16; ++y) tried.push_back({20, y});
  const auto given_up = leftovers_of(rows, {}, tried);
  ASSERT_EQ(given_up.size(), 1u);
  EXPECT_STREQ(given_up[0].why, "given up");

  SweepGainParams params;
  params.within = Bounds2{{0.0, 0.0}, {1.0, 1.0}};
  const auto out = leftovers_of(rows, params);
  ASSERT_EQ(out.size(), 1u);
  EXPECT_STREQ(out[0].why, "out of bounds");
}

}  // namespace
}  // namespace scrubjay::test
