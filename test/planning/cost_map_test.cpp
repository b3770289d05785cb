#include <gtest/gtest.h>

#include <cmath>
#include <scrubjay/error.hpp>
#include <scrubjay/geometry/random.hpp>
#include <scrubjay/planning/cost_map.hpp>

#include "planning/map_drawing.hpp"

namespace scrubjay {
namespace {

using test::MapDrawing;

CostMapParams burger() {
  return {};
}

CostMapParams roomba(bool through_unknown = false) {
  CostMapParams params;
  params.radius = 0.1735;
  params.through_unknown = through_unknown;
  return params;
}

std::vector<TravelCost> cells(const CostMap& map) {
  const auto view = map.view();
  return {view.cells, view.cells + view.geometry.size()};
}

CostMap built(GridView<const LogOdds> map, const CostMapParams& params) {
  CostMap costs(params);
  costs.update(map, cells_of(map.geometry));
  return costs;
}

/// Distance to the nearest obstacle's centre [m], the plain way. Obstacles lie outside, too, where unknown ones count.
double plain_distance(GridView<const LogOdds> map, CellIndex cell, const CostMapParams& params) {
  const auto reach =
      static_cast<std::int32_t>(std::ceil((params.radius + params.margin + params.comfort) / map.geometry.resolution));
  double nearest = 1e9;
  for (std::int32_t dy = -reach; dy <= reach; ++dy) {
    for (std::int32_t dx = -reach; dx <= reach; ++dx) {
      const CellIndex other{cell.x + dx, cell.y + dy};
      const Occupancy value = map.contains(other) ? trinary(map[other]) : kUnknown;
      const bool obstacle = value == kOccupied || (value == kUnknown && !params.through_unknown);
      if (obstacle) nearest = std::min(nearest, std::sqrt(dx * dx + dy * dy) * map.geometry.resolution);
    }
  }
  return nearest;
}

LogOdds random_cell(Random& random) {
  const std::uint32_t kind = random.below(40);
  return kind == 0 ? LogOdds{50} : kind == 1 ? LogOdds{0} : LogOdds{-50};
}

TEST(CostMapTest, FollowsTheDistanceToTheNearestObstacle) {
  Random random(1);
  for (const CostMapParams& params : {burger(), roomba(), roomba(true)}) {
    const GridGeometry grid{0.05, {-1.0, 0.5}, 37, 90};
    std::vector<LogOdds> map(grid.size());
    for (LogOdds& cell : map) cell = random.below(8) == 0 ? random_cell(random) : LogOdds{-50};
    const GridView<const LogOdds> view{grid, map.data()};
    const CostMap costs = built(view, params);
    for (std::int32_t y = 0; y < grid.height; ++y) {
      for (std::int32_t x = 0; x < grid.width; ++x) {
        const double beyond = plain_distance(view, {x, y}, params) - params.radius - params.margin;
        const double left = std::max(0.0, 1.0 - beyond / params.comfort);
        const double expected = beyond < 0.0 ? kNoWay : (params.dearness - 1.0) * kCostUnit * left * left;
        ASSERT_NEAR(costs.view()[(CellIndex{x, y})], expected, 0.5001) << x << " " << y;
        ASSERT_EQ(costs.passable({x, y}), beyond >= 0.0);
      }
    }
  }
}

TEST(CostMapTest, IsTheSameHoweverItCameToBe) {
  for (const CostMapParams& params : {burger(), roomba(), roomba(true)}) {
    Random random(2);
    GridGeometry grid{0.05, {0.0, 0.0}, 40, 30};
    std::vector<LogOdds> map(grid.size(), LogOdds{-50});
    CostMap costs(params);
    for (int round = 0; round < 60; ++round) {
      if (round % 10 == 9) {  // grow on all sides, by whole cells
        const CellIndex shift{static_cast<std::int32_t>(random.below(30)), static_cast<std::int32_t>(random.below(30))};
        GridGeometry larger = grid;
        larger.origin -= grid.resolution * Point2(shift.x, shift.y);
        larger.width += shift.x + static_cast<std::int32_t>(random.below(30));
        larger.height += shift.y + static_cast<std::int32_t>(random.below(30));
        std::vector<LogOdds> moved(larger.size(), LogOdds{0});
        for (std::int32_t y = 0; y < grid.height; ++y) {
          for (std::int32_t x = 0; x < grid.width; ++x) {
            moved[larger.index({x + shift.x, y + shift.y})] = map[grid.index({x, y})];
          }
        }
        grid = larger;
        map = moved;
      }
      const CellIndex low{static_cast<std::int32_t>(random.below(static_cast<std::uint32_t>(grid.width))),
                          static_cast<std::int32_t>(random.below(static_cast<std::uint32_t>(grid.height)))};
      const CellRect changed = intersection({low,
                                             {low.x + 1 + static_cast<std::int32_t>(random.below(20)),
                                              low.y + 1 + static_cast<std::int32_t>(random.below(20))}},
                                            cells_of(grid));
      for (std::int32_t y = changed.low.y; y < changed.high.y; ++y) {
        for (std::int32_t x = changed.low.x; x < changed.high.x; ++x) {
          if (random.below(4) == 0) map[grid.index({x, y})] = random_cell(random);
        }
      }
      const GridView<const LogOdds> view{grid, map.data()};
      costs.update(view, changed);
      ASSERT_EQ(cells(costs), cells(built(view, params))) << "round " << round;
    }
  }
}

TEST(CostMapTest, SaysWhereCostsMayHaveChanged) {
  Random random(3);
  MapDrawing map(std::vector<std::string>(60, std::string(80, '.')));
  CostMap costs = built(map.view(), roomba());
  for (int round = 0; round < 50; ++round) {
    const std::vector<TravelCost> before = cells(costs);
    const CellIndex at{static_cast<std::int32_t>(random.below(80)), static_cast<std::int32_t>(random.below(60))};
    map.view()[at] = random_cell(random);
    const CellRect changed = costs.update(map.view(), map.all());
    for (std::int32_t y = 0; y < 60; ++y) {
      for (std::int32_t x = 0; x < 80; ++x) {
        const std::size_t i = costs.view().geometry.index({x, y});
        ASSERT_TRUE(before[i] == costs.view().cells[i] || changed.contains({x, y}));
      }
    }
  }
}

TEST(CostMapTest, ChangesNothingWhereOnlyCertaintyGrew) {
  MapDrawing map({"#######", "#.....#", "#.....#", "#######"}, 0.05, 10);
  CostMap costs = built(map.view(), burger());
  for (std::size_t i = 0; i < map.view().geometry.size(); ++i) {
    LogOdds& cell = map.view().cells[i];
    cell = static_cast<LogOdds>(cell > 0 ? cell + 5 : cell - 5);
  }
  EXPECT_TRUE(costs.update(map.view(), map.all()).empty());
  map.view()[{30, 20}] = 60;
  const CellRect changed = costs.update(map.view(), map.all());
  EXPECT_TRUE(changed.contains({30, 20}));
  EXPECT_LE(changed.high.x - changed.low.x, 17);  // the cell itself, and 8 cells of reach on both sides
}

TEST(CostMapTest, UnknownFloorIsAnObstacleUnlessTheWayMayLeadThroughIt) {
  const MapDrawing map({"...?...", "...?...", "...?..."}, 0.05, 10);
  EXPECT_FALSE(built(map.view(), burger()).passable({35, 15}));
  CostMapParams bold = burger();
  bold.through_unknown = true;
  EXPECT_TRUE(built(map.view(), bold).passable({35, 15}));
}

TEST(CostMapTest, NarrowestGapsThatAreDocumented) {
  const auto passes = [](const CostMapParams& params, std::int32_t gap) {
    MapDrawing map(std::vector<std::string>(41, std::string(60, '.')));
    map.set({{0, 20}, {60, 21}}, '#');
    map.set({{30, 20}, {30 + gap, 21}}, '.');
    const CostMap costs = built(map.view(), params);
    return costs.passable({30 + gap / 2, 20});
  };
  EXPECT_TRUE(passes(roomba(), 7));
  EXPECT_FALSE(passes(roomba(), 6));
  EXPECT_TRUE(passes(burger(), 5));
  EXPECT_FALSE(passes(burger(), 4));
  EXPECT_TRUE(passes(roomba(), 13));  // a door of 0.75 m, with a cell lost on either side
}

TEST(CostMapTest, ThereIsNoWayOutOfBounds) {
  for (CostMapParams params : {burger(), roomba(true)}) {
    const MapDrawing map({"......", "......", "......", "......", "......"}, 0.05);
    const CostMap open = built(map.view(), params);
    params.within = Bounds2{{0.1, 0.05}, {0.2, 0.2}};
    const CostMap fenced = built(map.view(), params);
    for (std::int32_t y = 0; y < 5; ++y) {
      for (std::int32_t x = 0; x < 6; ++x) {
        const bool inside = x >= 2 && x < 4 && y >= 1 && y < 4;
        EXPECT_EQ((fenced.view()[{x, y}]), (inside ? open.view()[{x, y}] : kNoWay)) << x << ", " << y;
      }
    }
  }
}

TEST(CostMapTest, TakesAnEmptyMapAndOneThatBegins) {
  CostMap costs(burger());
  EXPECT_TRUE(costs.update({{0.05, {0.0, 0.0}, 0, 0}, nullptr}, {}).empty());
  EXPECT_FALSE(costs.passable({0, 0}));
  const MapDrawing map({"."}, 0.05, 31);
  // Whatever is said to have changed: nothing was known.
  EXPECT_EQ(costs.update(map.view(), {}), map.all());
  EXPECT_TRUE(costs.passable({15, 15}));
}

TEST(CostMapTest, RefusesAReachOfMoreCellsThanItCounts) {
  CostMapParams params;
  params.comfort = 30.0;
  CostMap costs(params);
  const MapDrawing map({"..."});
  EXPECT_THROW(costs.update(map.view(), map.all()), Error);
}

}  // namespace
}  // namespace scrubjay
