/// \file
/// A rectangle of cells.
#pragma once

#include <algorithm>
#include <cmath>
#include <scrubjay/grid/grid_view.hpp>

namespace scrubjay {

/// Cells from `low` up to, and without, `high`.
struct CellRect {
  CellIndex low{0, 0};
  CellIndex high{0, 0};

  bool empty() const { return low.x >= high.x || low.y >= high.y; }
  bool contains(CellIndex c) const { return c.x >= low.x && c.y >= low.y && c.x < high.x && c.y < high.y; }
  bool operator==(const CellRect&) const = default;
};

/// All cells of a grid.
inline CellRect cells_of(const GridGeometry& grid) {
  return {{0, 0}, {grid.width, grid.height}};
}

/// What lies in both.
inline CellRect intersection(const CellRect& a, const CellRect& b) {
  return {{std::max(a.low.x, b.low.x), std::max(a.low.y, b.low.y)},
          {std::min(a.high.x, b.high.x), std::min(a.high.y, b.high.y)}};
}

/// The smallest rectangle that holds both; an empty one adds nothing.
inline CellRect bounding(const CellRect& a, const CellRect& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
          {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)}};
}

/// Where it is when every cell's index has become larger by `by`.
inline CellRect moved(const CellRect& rect, CellIndex by) {
  return {{rect.low.x + by.x, rect.low.y + by.y}, {rect.high.x + by.x, rect.high.y + by.y}};
}

/// What makes a cell's index in `from` its index in `to`: two grids of one frame, of the same resolution and a whole
/// number of cells apart, as those of a growing map are.
inline CellIndex shift_between(const GridGeometry& from, const GridGeometry& to) {
  const Point2 shift = (from.origin - to.origin) / to.resolution;
  return {static_cast<std::int32_t>(std::lround(shift.x())), static_cast<std::int32_t>(std::lround(shift.y()))};
}

/// Wider by `margin` cells on every side.
inline CellRect grown(const CellRect& rect, std::int32_t margin) {
  return {{rect.low.x - margin, rect.low.y - margin}, {rect.high.x + margin, rect.high.y + margin}};
}

/// The cells of the grid, cut to it, that lie within `radius` [m] of `center` along either axis.
inline CellRect cells_around(const GridGeometry& grid, const Point2& center, double radius) {
  const CellIndex low = grid.cell_at(center - Point2(radius, radius));
  const CellIndex high = grid.cell_at(center + Point2(radius, radius));
  return intersection({low, {high.x + 1, high.y + 1}}, cells_of(grid));
}

}  // namespace scrubjay
