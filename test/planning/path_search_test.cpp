#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <scrubjay/error.hpp>
#include <scrubjay/geometry/random.hpp>
#include <scrubjay/planning/path_search.hpp>

#include "planning/map_drawing.hpp"

namespace scrubjay {
namespace {

using test::MapDrawing;

struct Costs {
  GridGeometry grid;
  std::vector<TravelCost> cells;
  GridView<const TravelCost> view() const { return {grid, cells.data()}; }
};

/// Cells that cost this and that, and walls.
Costs random_costs(Random& random, std::int32_t width, std::int32_t height, std::uint32_t walls_in_100) {
  Costs costs{{0.05, {0.0, 0.0}, width, height}, {}};
  for (std::size_t i = 0; i < costs.grid.size(); ++i) {
    const bool wall = random.below(100) < walls_in_100;
    costs.cells.push_back(wall ? kNoWay : static_cast<TravelCost>(random.below(3) == 0 ? random.below(255) : 0));
  }
  return costs;
}

CellIndex random_cell(const Costs& costs, Random& random) {
  for (;;) {
    const CellIndex cell{static_cast<std::int32_t>(random.below(static_cast<std::uint32_t>(costs.grid.width))),
                         static_cast<std::int32_t>(random.below(static_cast<std::uint32_t>(costs.grid.height)))};
    if (costs.view()[cell] != kNoWay) return cell;
  }
}

double factor(TravelCost cost) {
  return 1.0 + cost / kCostUnit;
}

/// A step's cost by the definition [m]; infinity if it can't be made.
double step_cost(const Costs& costs, CellIndex a, CellIndex b) {
  const auto free = [&](CellIndex c) { return costs.grid.contains(c) && costs.view()[c] != kNoWay; };
  if (!free(a) || !free(b) || !free({a.x, b.y}) || !free({b.x, a.y})) return PathSearch::kNever;
  const double length = a.x != b.x && a.y != b.y ? 17.0 / 12.0 : 1.0;
  return costs.grid.resolution * length * 0.5 * (factor(costs.view()[a]) + factor(costs.view()[b]));
}

double path_cost(const Costs& costs, const std::vector<CellIndex>& path) {
  double sum = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    EXPECT_LE(std::max(std::abs(path[i].x - path[i - 1].x), std::abs(path[i].y - path[i - 1].y)), 1);
    sum += step_cost(costs, path[i - 1], path[i]);
  }
  return sum;
}

/// Dijkstra's algorithm as he wrote it: looks through all cells for the next one.
std::vector<double> plain_dijkstra(const Costs& costs, CellIndex from) {
  std::vector<double> cost(costs.grid.size(), PathSearch::kNever);
  std::vector<bool> settled(costs.grid.size());
  cost[costs.grid.index(from)] = 0.0;
  for (;;) {
    std::size_t next = costs.grid.size();
    for (std::size_t i = 0; i < cost.size(); ++i) {
      if (!settled[i] && cost[i] < PathSearch::kNever && (next == cost.size() || cost[i] < cost[next])) next = i;
    }
    if (next == costs.grid.size()) return cost;
    settled[next] = true;
    const auto width = static_cast<std::size_t>(costs.grid.width);
    const CellIndex cell{static_cast<std::int32_t>(next % width), static_cast<std::int32_t>(next / width)};
    for (std::int32_t dy = -1; dy <= 1; ++dy) {
      for (std::int32_t dx = -1; dx <= 1; ++dx) {
        const CellIndex other{cell.x + dx, cell.y + dy};
        const double step = step_cost(costs, cell, other);
        if (step == PathSearch::kNever) continue;
        double& known = cost[costs.grid.index(other)];
        known = std::min(known, cost[next] + step);
      }
    }
  }
}

TEST(PathSearchTest, FindsTheCheapestPath) {
  Random random(1);
  PathSearch search;
  int found = 0;
  for (int round = 0; round < 150; ++round) {
    const Costs costs = random_costs(random, 2 + static_cast<std::int32_t>(random.below(24)),
                                     2 + static_cast<std::int32_t>(random.below(24)), random.below(35));
    const CellIndex from = random_cell(costs, random);
    const std::vector<double> truth = plain_dijkstra(costs, from);
    for (int goal = 0; goal < 4; ++goal) {
      const CellIndex to = random_cell(costs, random);
      const std::vector<CellIndex> path = search.find(costs.view(), from, to);
      const double expected = truth[costs.grid.index(to)];
      ASSERT_EQ(path.empty(), expected == PathSearch::kNever);
      if (path.empty()) continue;
      ++found;
      ASSERT_EQ(path.front(), from);
      ASSERT_EQ(path.back(), to);
      ASSERT_NEAR(path_cost(costs, path), expected, 1e-9);
    }
  }
  EXPECT_GT(found, 200);
}

/// Plains of equal cost, hills and walls among them: what makes shortcuts in a search tempting.
Costs plains(Random& random, std::int32_t width, std::int32_t height) {
  Costs costs{{0.05, {0.0, 0.0}, width, height}, {}};
  costs.cells.assign(costs.grid.size(), 0);
  for (int patch = 0; patch < 8; ++patch) {
    const std::uint32_t kind = random.below(4);
    const auto cost = static_cast<TravelCost>(kind == 0 ? kNoWay : kind == 1 ? random.below(40) : kind * 80);
    const auto x = static_cast<std::int32_t>(random.below(static_cast<std::uint32_t>(width)));
    const auto y = static_cast<std::int32_t>(random.below(static_cast<std::uint32_t>(height)));
    const CellRect patch_cells = intersection(
        {{x, y},
         {x + 1 + static_cast<std::int32_t>(random.below(14)), y + 1 + static_cast<std::int32_t>(random.below(9))}},
        cells_of(costs.grid));
    for (std::int32_t row = patch_cells.low.y; row < patch_cells.high.y; ++row) {
      for (std::int32_t column = patch_cells.low.x; column < patch_cells.high.x; ++column) {
        costs.cells[costs.grid.index({column, row})] = cost;
      }
    }
  }
  return costs;
}

TEST(PathSearchTest, FindsTheCheapestPathOverPlainsAndHills) {
  Random random(4);
  PathSearch search;
  for (int round = 0; round < 60; ++round) {
    const Costs costs = plains(random, 45, 30);
    const CellIndex from = random_cell(costs, random);
    const std::vector<double> truth = plain_dijkstra(costs, from);
    for (int goal = 0; goal < 10; ++goal) {
      const CellIndex to = random_cell(costs, random);
      const std::vector<CellIndex> path = search.find(costs.view(), from, to);
      const double expected = truth[costs.grid.index(to)];
      ASSERT_EQ(path.empty(), expected == PathSearch::kNever);
      if (path.empty()) continue;
      ASSERT_NEAR(path_cost(costs, path), expected, 1e-9);
    }
    search.spread(costs.view(), from);
    for (std::int32_t y = 0; y < costs.grid.height; ++y) {
      for (std::int32_t x = 0; x < costs.grid.width; ++x) {
        const double expected = truth[costs.grid.index({x, y})];
        const double cost = search.cost_to({x, y});
        ASSERT_TRUE(cost == expected || std::fabs(cost - expected) < 1e-9);
      }
    }
  }
}

TEST(PathSearchTest, FindsTheWayThatSpreadingFinds) {
  Random random(5);
  PathSearch search;
  for (int round = 0; round < 4; ++round) {
    const Costs costs = plains(random, 600, 400);
    const CellIndex from = random_cell(costs, random);
    search.spread(costs.view(), from);
    for (int goal = 0; goal < 10; ++goal) {
      const CellIndex to = random_cell(costs, random);
      const double expected = search.cost_to(to);
      PathSearch other;
      ASSERT_NEAR(path_cost(costs, other.find(costs.view(), from, to)), expected, 1e-9);
      ASSERT_NEAR(path_cost(costs, search.path_to(to)), expected, 1e-9);
    }
  }
}

TEST(PathSearchTest, SpreadsOverAllThatCanBeReached) {
  Random random(2);
  PathSearch search;
  for (int round = 0; round < 60; ++round) {
    const Costs costs = random_costs(random, 25, 20, random.below(40));
    const CellIndex from = random_cell(costs, random);
    const std::vector<double> truth = plain_dijkstra(costs, from);
    const double most = round % 2 == 0 ? PathSearch::kNever : 1.51234;
    search.spread(costs.view(), from, most);
    for (std::int32_t y = 0; y < costs.grid.height; ++y) {
      for (std::int32_t x = 0; x < costs.grid.width; ++x) {
        const double expected = truth[costs.grid.index({x, y})];
        const double cost = search.cost_to({x, y});
        if (expected > most) {
          ASSERT_EQ(cost, PathSearch::kNever);
          ASSERT_TRUE(search.path_to({x, y}).empty());
          continue;
        }
        if (expected == PathSearch::kNever) {
          ASSERT_EQ(cost, PathSearch::kNever);
          continue;
        }
        ASSERT_NEAR(cost, expected, 1e-9);
        ASSERT_NEAR(path_cost(costs, search.path_to({x, y})), expected, 1e-9);
      }
    }
  }
}

TEST(PathSearchTest, GivesTheSamePathWhateverItSearchedBefore) {
  Random random(3);
  PathSearch used;
  for (int round = 0; round < 40; ++round) {
    const Costs costs = random_costs(random, 40, 40, 20);
    const CellIndex from = random_cell(costs, random);
    const CellIndex to = random_cell(costs, random);
    EXPECT_EQ(used.find(costs.view(), from, to), PathSearch().find(costs.view(), from, to));
    used.spread(costs.view(), to);
    if (used.cost_to(from) == PathSearch::kNever) continue;
    PathSearch fresh;
    fresh.spread(costs.view(), to);
    EXPECT_EQ(used.path_to(from), fresh.path_to(from));
  }
}

TEST(PathSearchTest, CutsNoCorners) {
  const MapDrawing map({"...b",  //
                        ".##.",  //
                        "a..."});
  CostMapParams params;
  params.radius = params.margin = 0.02;
  params.comfort = 0.0;
  params.through_unknown = true;
  CostMap costs(params);
  costs.update(map.view(), map.all());
  // Around the block in straight steps: a diagonal one would touch it.
  EXPECT_EQ(PathSearch().find(costs.view(), map.cell('a'), map.cell('b')).size(), 6u);
}

TEST(PathSearchTest, NoPathLeadsIntoAWallNorOutOfTheMap) {
  const MapDrawing map({"a.#.b"}, 0.05, 20);
  CostMap costs{{}};
  costs.update(map.view(), map.all());
  PathSearch search;
  EXPECT_TRUE(search.find(costs.view(), map.cell('a'), map.cell('b')).empty());
  EXPECT_TRUE(search.find(costs.view(), map.cell('a'), {45, 10}).empty());
  EXPECT_TRUE(search.find(costs.view(), map.cell('a'), {-1, 3}).empty());
  EXPECT_TRUE(search.find(costs.view(), {500, 3}, map.cell('b')).empty());
  EXPECT_EQ(search.find(costs.view(), map.cell('a'), map.cell('a')).size(), 1u);
  search.spread(costs.view(), {500, 3});
  EXPECT_EQ(search.cost_to(map.cell('a')), PathSearch::kNever);
  EXPECT_EQ(search.cost_to({-1, 0}), PathSearch::kNever);
}

/// A room that a wall cuts in two, with a door far away; the disc stands at 'a', too near to the wall.
MapDrawing cut_room() {
  MapDrawing map({std::string(40, '.')}, 0.05, 40);
  map.set({{0, 20}, {1500, 21}}, '#');
  return map;
}

TEST(PathSearchTest, LetsTheDiscOutOnItsOwnSideOfTheWall) {
  const MapDrawing map = cut_room();
  CostMap costs{{}};
  costs.update(map.view(), map.all());
  const CellIndex from{100, 18};
  const CellIndex to{100, 30};
  ASSERT_FALSE(costs.passable(from));
  PathSearch search(0.21);
  const std::vector<CellIndex> path = search.find(costs.view(), from, to);
  ASSERT_FALSE(path.empty());
  EXPECT_EQ(path.front(), from);
  EXPECT_EQ(path.back(), to);
  EXPECT_GT(path.size(), 2800u);  // all the way to the door and back, and not through the wall
  for (std::size_t i = 3; i < path.size(); ++i) EXPECT_TRUE(costs.passable(path[i]));

  search.spread(costs.view(), from);
  EXPECT_EQ(search.path_to(to), path);
  EXPECT_LT(search.cost_to({100, 10}), 2.0);  // to be let out is free
  EXPECT_GT(search.cost_to(to), 140.0);
}

TEST(PathSearchTest, RefusesAMapThatIsTooWideForIt) {
  const Costs costs{{0.05, {0.0, 0.0}, 20000, 1}, std::vector<TravelCost>(20000)};
  EXPECT_THROW(PathSearch().find(costs.view(), {0, 0}, {5, 0}), Error);
}

TEST(PathSearchTest, LetsTheDiscOutForNothing) {
  const MapDrawing map = cut_room();
  CostMap costs{{}};
  costs.update(map.view(), map.all());
  PathSearch search(0.21);
  search.spread(costs.view(), {100, 18}, 0.5);  // it costs more to be let out
  EXPECT_LT(search.cost_to({100, 14}), 0.5);
  EXPECT_EQ(search.cost_to({100, 5}), PathSearch::kNever);
}

TEST(PathSearchTest, DoesNotLetTheDiscOutThroughAWall) {
  MapDrawing map = cut_room();
  map.set({{0, 20}, {1600, 21}}, '#');
  CostMap costs{{}};
  costs.update(map.view(), map.all());
  PathSearch search;
  EXPECT_TRUE(search.find(costs.view(), {100, 18}, {100, 30}).empty());
  search.spread(costs.view(), {100, 18});
  EXPECT_EQ(search.cost_to({100, 30}), PathSearch::kNever);
}

TEST(PathSearchTest, LetsTheDiscOutOfAnIsland) {
  // One passable cell nearest by, that leads nowhere; open floor behind.
  Costs costs{{0.05, {0.0, 0.0}, 40, 40}, std::vector<TravelCost>(1600, kNoWay)};
  for (std::int32_t y = 0; y < 40; ++y) {
    for (std::int32_t x = 24; x < 40; ++x) costs.cells[costs.grid.index({x, y})] = 0;
  }
  costs.cells[costs.grid.index({18, 20})] = 0;
  const std::vector<CellIndex> path = PathSearch(0.3).find(costs.view(), {20, 20}, {35, 20});
  ASSERT_FALSE(path.empty());
  EXPECT_EQ(path.size(), 16u);
  EXPECT_TRUE(PathSearch(0.15).find(costs.view(), {20, 20}, {35, 20}).empty());
}

}  // namespace
}  // namespace scrubjay
