#include <gtest/gtest.h>

#include <scrubjay/exploration/pending_change.hpp>

namespace scrubjay {
namespace {

GridGeometry grown_to(double x, double y, std::int32_t width, std::int32_t height) {
  GridGeometry map;
  map.origin = {x, y};
  map.width = width;
  map.height = height;
  return map;
}

TEST(PendingChangeTest, AllIsNewAtFirst) {
  PendingChange pending;
  pending.add(grown_to(0.0, 0.0, 9, 4), {});
  EXPECT_EQ(pending.take(), (CellRect{{0, 0}, {9, 4}}));
  EXPECT_TRUE(pending.take().empty());
}

TEST(PendingChangeTest, GathersWhatChangedSinceTheLastLook) {
  PendingChange pending;
  const GridGeometry map = grown_to(0.0, 0.0, 20, 20);
  pending.add(map, {});
  pending.take();
  pending.add(map, {{2, 3}, {4, 5}});
  pending.add(map, {});
  pending.add(map, {{7, 1}, {8, 2}});
  EXPECT_EQ(pending.take(), (CellRect{{2, 1}, {8, 5}}));
}

TEST(PendingChangeTest, WhatChangedMovesWithTheCellsOfAMapThatGrows) {
  PendingChange pending;
  pending.add(grown_to(0.0, 0.0, 20, 20), {});
  pending.take();
  pending.add(grown_to(0.0, 0.0, 20, 20), {{2, 3}, {4, 5}});
  pending.add(grown_to(-0.5, -0.25, 40, 40), {});
  EXPECT_EQ(pending.take(), (CellRect{{12, 8}, {14, 10}}));
}

}  // namespace
}  // namespace scrubjay
