#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <scrubjay/geometry/random.hpp>
#include <scrubjay/grid/traversal.hpp>
#include <set>
#include <vector>

namespace scrubjay {
namespace {

using testing::ElementsAre;
using Cells = std::vector<CellIndex>;
using CellSet = std::set<std::pair<int, int>>;

const GridGeometry kGrid{.resolution = 0.05, .origin = {-0.3, -0.2}, .width = 30, .height = 20};

Cells line(const GridGeometry& grid, const Point2& from, const Point2& to) {
  Cells cells;
  visit_line(grid, from, to, [&](CellIndex c) { cells.push_back(c); });
  return cells;
}

CellSet as_set(const Cells& cells) {
  CellSet set;
  for (const CellIndex c : cells) set.insert({c.x, c.y});
  return set;
}

Point2 point_around(Random& random) {
  return {random.uniform(-0.6, 1.6), random.uniform(-0.6, 1.2)};
}

/// Whether the segment passes the cell, grown on all sides by `margin` (slab test).
bool passes(const Point2& from, const Point2& to, CellIndex c, double margin) {
  double enter = 0.0;
  double leave = 1.0;
  for (int axis = 0; axis < 2; ++axis) {
    const double half = 0.5 * kGrid.resolution + margin;
    const double center = kGrid.center(c)[axis];
    const double way = to[axis] - from[axis];
    const double a = (center - half - from[axis]) / way;
    const double b = (center + half - from[axis]) / way;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave;
}

TEST(VisitLineTest, PassesExactlyTheCellsThatTheLinePasses) {
  Random random(1);
  for (int run = 0; run < 1000; ++run) {
    const Point2 from = point_around(random);
    const Point2 to = point_around(random);
    const CellSet visited = as_set(line(kGrid, from, to));
    for (std::int32_t y = -10; y < 30; ++y) {
      for (std::int32_t x = -10; x < 45; ++x) {
        const bool was_visited = visited.contains({x, y});
        if (passes(from, to, {x, y}, -1e-9)) {
          ASSERT_TRUE(was_visited) << "cell " << x << ", " << y << " left out";
        }
        if (!passes(from, to, {x, y}, 1e-9)) {
          ASSERT_FALSE(was_visited) << "cell " << x << ", " << y << " too many";
        }
      }
    }
  }
}

TEST(VisitLineTest, GoesFromEndToEndThroughSidesAndNeverTwice) {
  Random random(2);
  for (int run = 0; run < 2000; ++run) {
    Point2 from = point_around(random);
    Point2 to = point_around(random);
    if (run % 4 == 1) to.x() = from.x();
    if (run % 4 == 2) to.y() = from.y();
    const Cells cells = line(kGrid, from, to);
    EXPECT_EQ(cells.front(), kGrid.cell_at(from));
    EXPECT_EQ(cells.back(), kGrid.cell_at(to));
    EXPECT_EQ(as_set(cells).size(), cells.size());
    for (std::size_t i = 1; i < cells.size(); ++i) {
      ASSERT_EQ(std::abs(cells[i].x - cells[i - 1].x) + std::abs(cells[i].y - cells[i - 1].y), 1);
    }
  }
}

TEST(VisitLineTest, PassesTheSameCellsBackwards) {
  Random random(3);
  for (int run = 0; run < 2000; ++run) {
    const Point2 from = point_around(random);
    const Point2 to = point_around(random);
    Cells back = line(kGrid, to, from);
    std::reverse(back.begin(), back.end());
    ASSERT_EQ(line(kGrid, from, to), back);
  }
}

TEST(VisitLineTest, StartsAndEndsOnBorders) {
  const GridGeometry grid{
      .resolution = 0.25, .origin = {0.0, 0.0}, .width = 8, .height = 8};  // borders without rounding
  EXPECT_THAT(line(grid, {0.5, 0.1}, {0.0, 0.1}), ElementsAre(CellIndex{2, 0}, CellIndex{1, 0}, CellIndex{0, 0}));
  EXPECT_THAT(line(grid, {0.5, 0.1}, {1.0, 0.1}), ElementsAre(CellIndex{2, 0}, CellIndex{3, 0}, CellIndex{4, 0}));
  EXPECT_THAT(line(grid, {0.1, 0.5}, {0.1, 0.25}), ElementsAre(CellIndex{0, 2}, CellIndex{0, 1}));
  for (const Point2& way : {Point2{1.0, 1.0}, Point2{-1.0, 1.0}, Point2{1.0, -1.0}, Point2{-1.0, -1.0}}) {
    const Point2 corner{1.0, 1.0};
    const Cells cells = line(grid, corner, corner + way);  // through corners all the way
    EXPECT_EQ(cells.front(), grid.cell_at(corner));
    EXPECT_EQ(cells.back(), grid.cell_at(corner + way));
    EXPECT_EQ(cells.size(), 9u);
  }
}

TEST(VisitLineTest, IsOneCellWhereItHasNoLength) {
  EXPECT_THAT(line(kGrid, {0.1, 0.1}, {0.1, 0.1}), ElementsAre(kGrid.cell_at({0.1, 0.1})));
}

TEST(VisitDiscTest, VisitsExactlyTheCellsWhoseCentreLiesWithin) {
  Random random(4);
  for (int run = 0; run < 500; ++run) {
    const Point2 center = point_around(random);
    const double radius = random.uniform(0.0, 0.7);
    Cells visited;
    visit_disc(kGrid, center, radius, [&](CellIndex c) { visited.push_back(c); });
    const CellSet set = as_set(visited);
    ASSERT_EQ(set.size(), visited.size()) << "a cell was visited twice";
    for (std::int32_t y = -5; y < kGrid.height + 5; ++y) {
      for (std::int32_t x = -5; x < kGrid.width + 5; ++x) {
        const double beyond = (kGrid.center({x, y}) - center).norm() - radius;
        if (std::fabs(beyond) < 1e-9) continue;  // rounding decides
        ASSERT_EQ(set.contains({x, y}), beyond < 0.0 && kGrid.contains({x, y}));
      }
    }
  }
}

TEST(VisitDiscTest, VisitsNothingOutsideOfTheGrid) {
  for (const Point2& center : {Point2{50.0, 0.0}, Point2{-50.0, 0.0}, Point2{0.0, 50.0}, Point2{0.0, -50.0}}) {
    visit_disc(kGrid, center, 0.5, [](CellIndex) { FAIL(); });
  }
  visit_disc({}, {0.0, 0.0}, 0.5, [](CellIndex) { FAIL(); });
}

TEST(VisitArcTest, VisitsCellsOnTheArcInOrderAndNoneTwice) {
  Random random(5);
  for (int run = 0; run < 20000; ++run) {
    const Point2 center = point_around(random);
    const double radius = random.uniform(0.1, 0.5);
    const double from = random.uniform(-kPi, kPi);
    const double to = from + random.uniform(0.0, 1.5 * kPi);
    Cells visited;
    visit_arc(kGrid, center, radius, from, to, [&](CellIndex c) { visited.push_back(c); });
    ASSERT_EQ(as_set(visited).size(), visited.size()) << "a cell was visited twice, run " << run;
    ASSERT_EQ(visited.front(), kGrid.cell_at(center + radius * direction(from)));
    for (const CellIndex c : visited) {
      ASSERT_LE(std::fabs((kGrid.center(c) - center).norm() - radius), 0.7072 * kGrid.resolution);
    }
    for (std::size_t i = 1; i < visited.size(); ++i) {
      ASSERT_LE(std::abs(visited[i].x - visited[i - 1].x), 1);
      ASSERT_LE(std::abs(visited[i].y - visited[i - 1].y), 1);
    }
  }
}

TEST(VisitArcTest, LeavesOutOnlyCellsThatTheArcGrazes) {
  Random random(6);
  for (int run = 0; run < 500; ++run) {
    const Point2 center = point_around(random);
    const double from = random.uniform(-kPi, kPi);
    const double to = from + random.uniform(0.1, 3.0);
    CellSet visited;
    visit_arc(kGrid, center, 0.186, from, to, [&](CellIndex c) { visited.insert({c.x, c.y}); });
    std::map<std::pair<int, int>, double> way;  // of the arc in each cell
    constexpr int kSteps = 2000;
    for (int i = 0; i < kSteps; ++i) {
      const CellIndex c = kGrid.cell_at(center + 0.186 * direction(from + (to - from) * (i + 0.5) / kSteps));
      way[{c.x, c.y}] += 0.186 * (to - from) / kSteps;
    }
    for (const auto& [cell, length] : way) {
      if (length > 0.51 * kGrid.resolution) {
        EXPECT_TRUE(visited.contains(cell));
      }
    }
  }
}

}  // namespace
}  // namespace scrubjay
