#include <gtest/gtest.h>

#include <array>
#include <scrubjay/grid/grid_view.hpp>
#include <set>

namespace scrubjay {
namespace {

const GridGeometry kViewGrid{.resolution = 0.25, .origin = {-1.0, 2.0}, .width = 4, .height = 3};

TEST(GridGeometryTest, ACellHoldsItsLowerLeftCornerAndNotItsUpperRightOne) {
  EXPECT_EQ(kViewGrid.cell_at({-1.0, 2.0}), (CellIndex{0, 0}));
  EXPECT_EQ(kViewGrid.cell_at({-0.75, 2.25}), (CellIndex{1, 1}));
  EXPECT_EQ(kViewGrid.cell_at({-0.76, 2.24}), (CellIndex{0, 0}));
}

TEST(GridGeometryTest, CellsBelowTheOriginAreNegative) {
  EXPECT_EQ(kViewGrid.cell_at({-1.01, 1.99}), (CellIndex{-1, -1}));
  EXPECT_EQ(kViewGrid.cell_at({-1.25, 1.74}), (CellIndex{-1, -2}));
}

TEST(GridGeometryTest, CentresLieInTheirCells) {
  EXPECT_EQ(kViewGrid.center({0, 0}), (Point2{-0.875, 2.125}));
  for (std::int32_t y = -3; y < 6; ++y) {
    for (std::int32_t x = -3; x < 6; ++x) EXPECT_EQ(kViewGrid.cell_at(kViewGrid.center({x, y})), (CellIndex{x, y}));
  }
}

TEST(GridGeometryTest, HoldsWidthTimesHeightCellsEachAtAPlaceOfItsOwn) {
  std::set<std::size_t> places;
  for (std::int32_t y = -1; y <= kViewGrid.height; ++y) {
    for (std::int32_t x = -1; x <= kViewGrid.width; ++x) {
      const bool inside = x >= 0 && x < 4 && y >= 0 && y < 3;
      EXPECT_EQ(kViewGrid.contains({x, y}), inside);
      if (inside) places.insert(kViewGrid.index({x, y}));
    }
  }
  EXPECT_EQ(places.size(), kViewGrid.size());
  EXPECT_EQ(*places.rbegin(), kViewGrid.size() - 1);
}

TEST(GridGeometryTest, RowsRunAlongXFromTheOriginUpwards) {
  EXPECT_EQ(kViewGrid.index({1, 0}), 1u);
  EXPECT_EQ(kViewGrid.index({0, 1}), 4u);
}

TEST(GridViewTest, WritesTheCallersCells) {
  std::array<int, 12> cells{};
  const GridView<int> view{kViewGrid, cells.data()};
  view[{2, 1}] = 7;
  EXPECT_EQ(cells[6], 7);
  const GridView<const int> read_only = view;
  EXPECT_EQ((read_only[{2, 1}]), 7);
  EXPECT_TRUE(read_only.contains({3, 2}));
  EXPECT_FALSE(read_only.contains({4, 2}));
}

}  // namespace
}  // namespace scrubjay
