#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <scrubjay/exploration/frontier_map.hpp>
#include <scrubjay/geometry/random.hpp>
#include <scrubjay/mapping/growing_map.hpp>
#include <set>
#include <string>

namespace scrubjay {
namespace {

using Cell = std::pair<std::int32_t, std::int32_t>;  // of a lattice that doesn't move when the map grows
using Cells = std::set<Cell>;

// A map from rows of text, the highest first: '.' free, '#' occupied, ' ' unknown.
struct DrawnMap {
  explicit DrawnMap(const std::vector<std::string>& rows) {
    geometry.width = static_cast<std::int32_t>(rows.front().size());
    geometry.height = static_cast<std::int32_t>(rows.size());
    for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
      for (const char c : *row) cells.push_back(c == '.' ? -50 : c == '#' ? 50 : 0);
    }
  }
  GridView<const LogOdds> view() const { return {geometry, cells.data()}; }

  GridGeometry geometry;
  std::vector<LogOdds> cells;
};

Cells cells_of_frontier(const Frontier& frontier, const GridGeometry& geometry) {
  const auto left = static_cast<std::int32_t>(std::lround(geometry.origin.x() / geometry.resolution));
  const auto low = static_cast<std::int32_t>(std::lround(geometry.origin.y() / geometry.resolution));
  Cells cells;
  for (const CellIndex c : frontier.cells) cells.insert({c.x + left, c.y + low});
  EXPECT_EQ(cells.size(), frontier.cells.size());
  return cells;
}

std::set<Cells> frontiers_as_sets(const FrontierMap& frontiers, const GridGeometry& geometry) {
  std::set<Cells> sets;
  for (const Frontier& frontier : frontiers.frontiers()) sets.insert(cells_of_frontier(frontier, geometry));
  EXPECT_EQ(sets.size(), frontiers.frontiers().size());
  return sets;
}

// The definition, cell by cell.
std::set<Cells> frontiers_by_definition(GridView<const LogOdds> map) {
  const auto unknown = [&](CellIndex c) { return !map.contains(c) || trinary(map[c]) == kUnknown; };
  Cells open;
  for (std::int32_t y = 0; y < map.geometry.height; ++y) {
    for (std::int32_t x = 0; x < map.geometry.width; ++x) {
      const bool beside = unknown({x - 1, y}) || unknown({x + 1, y}) || unknown({x, y - 1}) || unknown({x, y + 1});
      if (trinary(map[{x, y}]) == kFree && beside) open.insert({x, y});
    }
  }
  const auto left = static_cast<std::int32_t>(std::lround(map.geometry.origin.x() / map.geometry.resolution));
  const auto low = static_cast<std::int32_t>(std::lround(map.geometry.origin.y() / map.geometry.resolution));
  std::set<Cells> components;
  while (!open.empty()) {
    Cells component;
    std::vector<Cell> todo{*open.begin()};
    open.erase(open.begin());
    while (!todo.empty()) {
      const Cell c = todo.back();
      todo.pop_back();
      component.insert({c.first + left, c.second + low});
      for (const auto& [dx, dy] : {Cell{-1, -1}, {0, -1}, {1, -1}, {-1, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}}) {
        if (open.erase({c.first + dx, c.second + dy}) > 0) todo.push_back({c.first + dx, c.second + dy});
      }
    }
    components.insert(component);
  }
  return components;
}

TEST(FrontierMapTest, FindsFreeCellsBesideUnknownOnes) {
  const DrawnMap map({
      "#######",  //
      "#...  #",  //
      "#...  #",  //
      "#.....#",  //
      "#######",  //
  });
  FrontierMap frontiers;
  frontiers.update(map.view(), cells_of(map.geometry));
  ASSERT_EQ(frontiers.frontiers().size(), 1u);
  const Frontier& frontier = frontiers.frontiers().front();
  EXPECT_EQ(cells_of_frontier(frontier, map.geometry), (Cells{{3, 3}, {3, 2}, {4, 1}, {5, 1}}));
  EXPECT_EQ(frontier.bounds, (CellRect{{3, 1}, {6, 4}}));
  EXPECT_NEAR(frontier.centroid.x(), (3.5 + 3.5 + 4.5 + 5.5) / 4 * 0.05, 1e-12);
  EXPECT_NEAR(frontier.centroid.y(), (3.5 + 2.5 + 1.5 + 1.5) / 4 * 0.05, 1e-12);
}

TEST(FrontierMapTest, CornersConnectFrontiersButDoNotMakeThem) {
  const DrawnMap map({
      "######",  //
      "#.#  #",  //
      "#...##",  //
      "######",  //
  });
  FrontierMap frontiers;
  frontiers.update(map.view(), cells_of(map.geometry));
  ASSERT_EQ(frontiers.frontiers().size(), 1u);
  EXPECT_EQ(frontiers.frontiers()[0].cells.size(), 1u);
  EXPECT_EQ(frontiers.frontiers()[0].cells[0], (CellIndex{3, 1}));
}

TEST(FrontierMapTest, BeyondTheBorderEverythingIsUnknown) {
  const DrawnMap map({"...", "...", "..."});
  FrontierMap frontiers;
  frontiers.update(map.view(), cells_of(map.geometry));
  ASSERT_EQ(frontiers.frontiers().size(), 1u);
  EXPECT_EQ(frontiers.frontiers()[0].cells.size(), 8u);
}

TEST(FrontierMapTest, KnowsNoneInAMapWithoutCells) {
  FrontierMap frontiers;
  frontiers.update({}, {});
  EXPECT_TRUE(frontiers.frontiers().empty());
}

// Scribbles in a growing map as a mapper would, and hands out what changed.
class Scribbler {
 public:
  explicit Scribbler(std::uint64_t seed) : random_(seed) {}

  CellRect scribble() {
    const Point2 center{random_.uniform(-reach_, reach_), random_.uniform(-reach_, reach_)};
    reach_ = std::min(reach_ + 0.05, 8.0);
    const double radius = random_.uniform(0.01, 0.8);
    map.cover(center, radius);
    const CellRect changed = cells_around(map.view().geometry, center, radius);
    const std::uint32_t kind = random_.below(4);
    for (std::int32_t y = changed.low.y; y < changed.high.y; ++y) {
      for (std::int32_t x = changed.low.x; x < changed.high.x; ++x) {
        LogOdds& cell = map.view()[{x, y}];
        const std::uint32_t draw = random_.below(100);
        if (kind == 0) cell = -50;
        if (kind == 1 && draw < 30) cell = static_cast<LogOdds>(-40 + static_cast<int>(random_.below(70)));
        if (kind == 2 && draw < 60) cell = 50;
        if (kind == 3) cell = 0;
      }
    }
    return changed;
  }

  GrowingMap map{0.05};

 private:
  Random random_;
  double reach_ = 0.5;
};

TEST(FrontierMapTest, IsTheSameAsOneBuiltFromNothingHoweverTheMapWasEdited) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Scribbler scribbler(seed);
    FrontierMap kept;
    for (int edit = 0; edit < 100; ++edit) {
      const CellRect changed = scribbler.scribble();
      const GridView<const LogOdds> map = scribbler.map.view();
      kept.update(map, changed);
      if (edit % 5 != 0 && edit < 95) continue;
      FrontierMap fresh;
      fresh.update(map, cells_of(map.geometry));
      const std::set<Cells> expected = frontiers_by_definition(map);
      ASSERT_EQ(frontiers_as_sets(fresh, map.geometry), expected) << "seed " << seed << ", edit " << edit;
      ASSERT_EQ(frontiers_as_sets(kept, map.geometry), expected) << "seed " << seed << ", edit " << edit;
    }
  }
}

TEST(FrontierMapTest, KeepsIdsOfWhatDidNotChangeAndGivesNoneTwice) {
  std::map<std::uint32_t, Cells> seen;
  Scribbler scribbler(7);
  FrontierMap frontiers;
  std::map<Cells, std::uint32_t> before;
  for (int edit = 0; edit < 300; ++edit) {
    const CellRect changed = scribbler.scribble();
    frontiers.update(scribbler.map.view(), changed);
    std::map<Cells, std::uint32_t> now;
    for (const Frontier& frontier : frontiers.frontiers()) {
      const Cells cells = cells_of_frontier(frontier, scribbler.map.view().geometry);
      const auto [known, is_new] = seen.insert({frontier.id, cells});
      ASSERT_TRUE(is_new || known->second == cells) << "edit " << edit << ", id " << frontier.id;
      const auto same = before.find(cells);
      if (same != before.end()) {
        ASSERT_EQ(same->second, frontier.id) << "edit " << edit;
      }
      now[cells] = frontier.id;
    }
    before = now;
  }
}

TEST(FrontierMapTest, BoundsAndCentroidsMoveWithAMapThatGrows) {
  GrowingMap map(0.05);
  map.cover({0.5, 0.5}, 0.5);
  map.view()[{5, 5}] = -50;
  FrontierMap frontiers;
  frontiers.update(map.view(), cells_of(map.view().geometry));
  ASSERT_EQ(frontiers.frontiers().size(), 1u);
  const Point2 centroid = frontiers.frontiers()[0].centroid;
  map.cover({-3.0, -2.0}, 0.5);
  frontiers.update(map.view(), {});
  ASSERT_EQ(frontiers.frontiers().size(), 1u);
  const Frontier& moved = frontiers.frontiers()[0];
  EXPECT_EQ(moved.cells[0], map.view().geometry.cell_at(centroid));
  EXPECT_EQ(moved.bounds.low, moved.cells[0]);
  EXPECT_EQ(trinary(map.view()[moved.cells[0]]), kFree);
  EXPECT_EQ(moved.centroid, centroid);
}

TEST(FrontierMapTest, StartsOverWithAnotherMap) {
  FrontierMap frontiers;
  const DrawnMap large({".....", ".....", "....."});
  frontiers.update(large.view(), cells_of(large.geometry));
  const DrawnMap small({"###", "#. ", "###"});
  frontiers.update(small.view(), {});
  ASSERT_EQ(frontiers.frontiers().size(), 1u);
  EXPECT_EQ(frontiers.frontiers()[0].cells, (std::vector<CellIndex>{{1, 1}}));
}

}  // namespace
}  // namespace scrubjay
