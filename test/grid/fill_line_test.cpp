#include <gtest/gtest.h>

#include <algorithm>
#include <scrubjay/geometry/random.hpp>
#include <scrubjay/grid/fill_line.hpp>
#include <scrubjay/grid/traversal.hpp>
#include <vector>

namespace scrubjay {
namespace {

/// A grid with a quarter of a metre a cell, so that borders and points on them have no rounding.
const GridGeometry kLineGrid{.resolution = 0.25, .origin = {0.0, 0.0}, .width = 60, .height = 40};

Point2 in_cells(const Point2& p) {
  return p / kLineGrid.resolution;
}

std::vector<int> filled(const Point2& from, const Point2& to) {
  std::vector<int> cells(kLineGrid.size());
  fill_line(line_walk(kLineGrid.width, in_cells(from), in_cells(to)), cells.data(), 7);
  return cells;
}

std::vector<int> visited(const Point2& from, const Point2& to) {
  std::vector<int> cells(kLineGrid.size());
  visit_line(kLineGrid, from, to, [&](CellIndex c) { cells[kLineGrid.index(c)] = 7; });
  return cells;
}

Point2 point_within(Random& random) {
  return {random.uniform(0.0, 15.0), random.uniform(0.0, 10.0)};
}

std::size_t place_of(const Point2& p) {
  return kLineGrid.index(kLineGrid.cell_at(p));
}

TEST(FillLineTest, FillsExactlyTheCellsThatTheLinePasses) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Random random(seed);
    for (int run = 0; run < 500; ++run) {
      const Point2 from = point_within(random);
      // Some are short, so that all directions and both ends within a cell or two are tried, too.
      Point2 to = point_within(random);
      if (run % 2 == 0) to = (from + 0.05 * (to - from)).eval();
      ASSERT_EQ(filled(from, to), visited(from, to)) << from.transpose() << " to " << to.transpose();
    }
  }
}

TEST(FillLineTest, FillsLinesAlongTheAxes) {
  Random random(1);
  for (int run = 0; run < 2000; ++run) {
    const Point2 from = point_within(random);
    Point2 to = point_within(random);
    to[run % 2] = from[run % 2];
    ASSERT_EQ(filled(from, to), visited(from, to)) << from.transpose() << " to " << to.transpose();
  }
}

/// Whether the line touches the cell, corners included.
bool touches(const Point2& from, const Point2& to, CellIndex c) {
  double enter = 0.0;
  double leave = 1.0;
  for (int axis = 0; axis < 2; ++axis) {
    const double half = 0.5 * kLineGrid.resolution + 1e-9;
    const double center = kLineGrid.center(c)[axis] - from[axis];
    const double way = to[axis] - from[axis];
    if (way == 0.0 && std::fabs(center) > half) return false;
    if (way == 0.0) continue;
    enter = std::max(enter, std::min((center - half) / way, (center + half) / way));
    leave = std::min(leave, std::max((center - half) / way, (center + half) / way));
  }
  return enter <= leave;
}

TEST(FillLineTest, GoesThroughCornersByOneOfTheNeighbours) {
  Random random(2);
  const auto snapped = [](Point2 p, std::uint32_t axes) {
    if ((axes & 1U) != 0) p.x() = std::floor(p.x() / 0.25) * 0.25;
    if ((axes & 2U) != 0) p.y() = std::floor(p.y() / 0.25) * 0.25;
    return p;
  };
  for (int run = 0; run < 4000; ++run) {
    const Point2 from = snapped(point_within(random), random.below(4));
    Point2 to = snapped(point_within(random), random.below(4));
    if (run % 4 == 0) to = from + std::floor(random.uniform(0.0, 20.0)) * Point2(0.25, 0.25);  // diagonal
    if (!kLineGrid.contains(kLineGrid.cell_at(to))) continue;
    const std::vector<int> cells = filled(from, to);
    const CellIndex first = kLineGrid.cell_at(from);
    const CellIndex last = kLineGrid.cell_at(to);
    ASSERT_EQ(std::count(cells.begin(), cells.end(), 7), std::abs(last.x - first.x) + std::abs(last.y - first.y) + 1)
        << from.transpose() << " to " << to.transpose();
    ASSERT_EQ(cells[kLineGrid.index(first)], 7);
    ASSERT_EQ(cells[kLineGrid.index(last)], 7);
    for (std::int32_t y = 0; y < kLineGrid.height; ++y) {
      for (std::int32_t x = 0; x < kLineGrid.width; ++x) {
        ASSERT_TRUE(cells[kLineGrid.index({x, y})] == 0 || touches(from, to, {x, y}))
            << from.transpose() << " to " << to.transpose() << " sets " << x << ", " << y;
      }
    }
  }
}

TEST(FillLineTest, IsOneCellWhereItHasNoLength) {
  for (const Point2& p : {Point2{1.1, 2.3}, Point2{1.0, 2.25}, Point2{0.0, 0.0}}) {
    const std::vector<int> cells = filled(p, p);
    EXPECT_EQ(cells[place_of(p)], 7);
    EXPECT_EQ(std::count(cells.begin(), cells.end(), 7), 1);
  }
}

TEST(FillLineTest, EndsWhereTheWalkSaysThatItEnds) {
  Random random(3);
  for (int run = 0; run < 1000; ++run) {
    const Point2 from = point_within(random);
    const Point2 to = point_within(random);
    const LineWalk walk = line_walk(kLineGrid.width, in_cells(from), in_cells(to));
    EXPECT_EQ(static_cast<std::size_t>(walk.start), place_of(from));
    EXPECT_EQ(static_cast<std::size_t>(walk.end()), place_of(to));
  }
}

TEST(FillLineTest, KeepsToItsCellsInTheWidestGrid) {
  // As long and as flat as a line can be: an error in the slope would show at its end.
  constexpr std::int32_t kWidth = 1 << 15;
  const GridGeometry wide{.resolution = 1.0, .origin = {0.0, 0.0}, .width = kWidth, .height = 4};
  std::vector<std::uint8_t> cells(wide.size());
  std::vector<std::uint8_t> expected(wide.size());
  const Point2 from{0.3, 0.2};
  const Point2 to{kWidth - 0.4, 3.7};
  fill_line<std::uint8_t>(line_walk(wide.width, from, to), cells.data(), 1);
  visit_line(wide, from, to, [&](CellIndex c) { expected[wide.index(c)] = 1; });
  EXPECT_EQ(cells, expected);
}

}  // namespace
}  // namespace scrubjay
