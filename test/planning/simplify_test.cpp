#include <gtest/gtest.h>

#include <cmath>
#include <scrubjay/geometry/random.hpp>
#include <scrubjay/planning/path_search.hpp>

#include "planning/map_drawing.hpp"

namespace scrubjay {
namespace {

using test::MapDrawing;

CostMap costs_of(const MapDrawing& map, double radius = 0.105) {
  CostMapParams params;
  params.radius = radius;
  CostMap costs(params);
  costs.update(map.view(), map.all());
  return costs;
}

/// What it costs to drive along a line, finely summed up [m of open floor].
double line_cost(const CostMap& costs, const Point2& from, const Point2& to) {
  constexpr int kPieces = 1000;
  double sum = 0.0;
  for (int i = 0; i < kPieces; ++i) {
    const CellIndex cell = costs.view().geometry.cell_at(from + (to - from) * ((i + 0.5) / kPieces));
    sum += 1.0 + costs.view()[cell] / kCostUnit;
  }
  return sum / kPieces * (to - from).norm();
}

double cost_of(const CostMap& costs, const std::vector<Point2>& path) {
  double sum = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) sum += line_cost(costs, path[i - 1], path[i]);
  return sum;
}

TEST(SimplifyTest, StaysPassableAndCostsNoMoreThanItsAllowance) {
  Random random(1);
  int compared = 0;
  for (int round = 0; round < 40; ++round) {
    MapDrawing map(std::vector<std::string>(90, std::string(90, '.')));
    for (int block = 0; block < 25; ++block) {
      const auto x = static_cast<std::int32_t>(random.below(80));
      const auto y = static_cast<std::int32_t>(random.below(80));
      map.set(
          {{x, y},
           {x + 1 + static_cast<std::int32_t>(random.below(9)), y + 1 + static_cast<std::int32_t>(random.below(9))}},
          '#');
    }
    const CostMap costs = costs_of(map, round % 2 == 0 ? 0.105 : 0.1735);
    const auto cell = [&random] {
      return CellIndex{static_cast<std::int32_t>(random.below(90)), static_cast<std::int32_t>(random.below(90))};
    };
    const CellIndex from = cell();
    const CellIndex to = cell();
    if (!costs.passable(from) || !costs.passable(to)) continue;
    const std::vector<CellIndex> path = PathSearch().find(costs.view(), from, to);
    if (path.empty()) continue;
    ++compared;
    std::vector<Point2> cells;
    for (const CellIndex& c : path) cells.push_back(costs.view().geometry.center(c));
    const std::vector<Point2> corners = simplify(costs.view(), path);
    EXPECT_EQ(corners.front(), cells.front());
    EXPECT_EQ(corners.back(), cells.back());
    for (std::size_t i = 1; i < corners.size(); ++i) {
      EXPECT_TRUE(line_is_passable(costs.view(), corners[i - 1], corners[i]));
    }
    EXPECT_LE(cost_of(costs, corners), 1.04 * cost_of(costs, cells) + 0.02 * static_cast<double>(corners.size()));
  }
  EXPECT_GT(compared, 10);
}

TEST(SimplifyTest, MakesOneLineOfAnOpenRoom) {
  const MapDrawing map({"..........", ".a........", "..........", "........b.", ".........."}, 0.05, 20);
  const CostMap costs = costs_of(map);
  const std::vector<CellIndex> path = PathSearch().find(costs.view(), map.cell('a'), map.cell('b'));
  EXPECT_EQ(simplify(costs.view(), path), (std::vector<Point2>{map.point('a'), map.point('b')}));
}

TEST(SimplifyTest, TakesTheCornersOfARoomWithAWallInIt) {
  const MapDrawing map({"..........", "....##....", ".a..##..b.", "....##....", "....##...."}, 0.05, 20);
  const CostMap costs = costs_of(map);
  const std::vector<CellIndex> path = PathSearch().find(costs.view(), map.cell('a'), map.cell('b'));
  const std::vector<Point2> corners = simplify(costs.view(), path);
  EXPECT_GE(corners.size(), 3u);
  EXPECT_LE(corners.size(), 8u);
}

TEST(SimplifyTest, NothingComesOfNothing) {
  const MapDrawing map({"..."}, 0.05, 20);
  const CostMap costs = costs_of(map);
  EXPECT_TRUE(simplify(costs.view(), {}).empty());
  EXPECT_EQ(simplify(costs.view(), {{3, 4}}).size(), 1u);
}

TEST(SimplifyTest, ALineIsPassableIfAllItsCellsAre) {
  const MapDrawing map({".....", ".....", "..#..", ".....", "....."}, 0.05, 20);
  const CostMap costs = costs_of(map);
  EXPECT_TRUE(line_is_passable(costs.view(), {0.5, 0.5}, {4.5, 0.5}));
  EXPECT_FALSE(line_is_passable(costs.view(), {0.5, 2.5}, {4.5, 2.5}));
  EXPECT_FALSE(line_is_passable(costs.view(), {0.5, 0.5}, {7.0, 0.5}));  // out of the map
}

}  // namespace
}  // namespace scrubjay
