#include <gtest/gtest.h>

#include <scrubjay/exploration/sweep_gain.hpp>
#include <scrubjay/geometry/random.hpp>
#include <scrubjay/mapping/growing_map.hpp>

#include "planning/map_drawing.hpp"

namespace scrubjay::test {
namespace {

SweepGain gain_of(const MapDrawing& map, const SweepGainParams& params = {}) {
  SweepGain gain(params);
  gain.update(map.view(), map.all());
  return gain;
}

TEST(SweepGainTest, CountsTheUnknownCellsUnderADisc) {
  const MapDrawing map({"..........",  //
                        "..........",  //
                        "..........",  //
                        "....a?....",  //
                        "....??....",  //
                        "..........",  //
                        "..........",  //
                        "........b."});
  const SweepGain gain = gain_of(map);
  EXPECT_EQ(gain.gain(map.cell('a')), 3);
  EXPECT_EQ(gain.gain(map.cell('b')), 0);
  EXPECT_FALSE(gain.wanted(map.cell('a')));
}

TEST(SweepGainTest, UnknownFloorAtAWallIsNotWanted) {
  const MapDrawing map({"#####",  //
                        "?????",  //
                        "?????",  //
                        "....."});
  const SweepGain gain = gain_of(map);
  EXPECT_FALSE(gain.wanted({2, 2}));
  EXPECT_TRUE(gain.wanted({2, 1}));
  EXPECT_TRUE(gain.wanted({-3, 1})) << "nor is there anything known outside";
}

TEST(SweepGainTest, GivesUpWhatWasTriedInVain) {
  MapDrawing map({".....",  //
                  ".u?..",  //
                  "....."});
  map.set({map.cell('u'), {2, 2}}, '?');
  SweepGain gain = gain_of(map);
  for (int i = 0; i < SweepGainParams{}.tries; ++i) {
    EXPECT_TRUE(gain.wanted({1, 1}));
    gain.tried({1, 1});
  }
  EXPECT_FALSE(gain.wanted({1, 1}));
  EXPECT_TRUE(gain.given_up({1, 1}));
  EXPECT_EQ(gain.gain({1, 1}), 1);
  gain.update(map.view(), map.all());
  EXPECT_TRUE(gain.given_up({1, 1})) << "as long as nothing changes";

  map.set({{2, 1}, {3, 2}}, '.');
  gain.update(map.view(), {{2, 1}, {3, 2}});
  EXPECT_TRUE(gain.wanted({1, 1})) << "the floor beside it has become free";
}

TEST(SweepGainTest, NothingIsWantedOutOfBounds) {
  const MapDrawing map({"??????", "??????"});
  SweepGainParams params;
  params.within = Bounds2{{0.0, 0.0}, {0.15, 1.0}};
  const SweepGain gain = gain_of(map, params);
  EXPECT_TRUE(gain.wanted({2, 0}));
  EXPECT_FALSE(gain.wanted({3, 0}));
  EXPECT_TRUE(gain.out_of_bounds({3, 0}));
}

TEST(SweepGainTest, CountsWhatBecomesFree) {
  MapDrawing map({"????", "????"});
  SweepGain gain = gain_of(map);
  map.set({{1, 0}, {3, 2}}, '.');
  gain.update(map.view(), {{1, 0}, {3, 2}});
  EXPECT_EQ(gain.freed(), 4);
}

TEST(SweepGainTest, CountsTheWallsThatItWasSureOfAndThoseThatAreNoneAnyMore) {
  MapDrawing map({"....", "....", "...."});
  SweepGain gain = gain_of(map);
  const auto make = [&](CellIndex cell, LogOdds value) {
    map.view()[cell] = value;
    gain.update(map.view(), {cell, {cell.x + 1, cell.y + 1}});
  };
  make({1, 1}, kOccupiedLogOdds);  // touched once or twice
  EXPECT_EQ(gain.walls(), 0);
  make({1, 1}, -60);
  EXPECT_EQ(gain.refuted(), 0);
  make({2, 1}, kMaxLogOdds);
  make({2, 1}, 30);
  EXPECT_EQ(gain.walls(), 1);
  EXPECT_EQ(gain.refuted(), 0);
  make({2, 1}, 0);
  EXPECT_EQ(gain.walls(), 1);
  EXPECT_EQ(gain.refuted(), 1);
}

TEST(SweepGainTest, KeptUpItIsWhatItWouldBeFromNothing) {
  Random random(5);
  GrowingMap map(0.05);
  map.cover({0.0, 0.0}, 0.5);
  SweepGain kept{{}};
  kept.update(map.view(), cells_of(map.view().geometry));
  for (int round = 0; round < 60; ++round) {
    const Point2 place{random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0)};
    const GridGeometry before = map.view().geometry;
    map.cover(place, 0.3);
    const CellRect changed = cells_around(map.view().geometry, place, 0.3);
    for (std::int32_t y = changed.low.y; y < changed.high.y; ++y) {
      for (std::int32_t x = changed.low.x; x < changed.high.x; ++x) {
        if (random.below(3) == 0) map.view()[{x, y}] = static_cast<LogOdds>(random.below(161) - 80);
      }
    }
    kept.update(map.view(), changed);
    if (before == map.view().geometry && round % 8 != 0) continue;
    SweepGain fresh{{}};
    fresh.update(map.view(), cells_of(map.view().geometry));
    for (std::int32_t y = 0; y < map.view().geometry.height; ++y) {
      for (std::int32_t x = 0; x < map.view().geometry.width; ++x) {
        ASSERT_EQ(kept.wanted({x, y}), fresh.wanted({x, y})) << round << ": " << x << ", " << y;
      }
    }
    for (std::int32_t y = 0; y < map.view().geometry.height; ++y) {
      for (std::int32_t x = 0; x < map.view().geometry.width; ++x) {
        ASSERT_EQ(kept.gain({x, y}), fresh.gain({x, y})) << round << ": " << x << ", " << y;
      }
    }
  }
}

}  // namespace
}  // namespace scrubjay::test
