/// \file
/// Cells on a line, in a disc, on an arc.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <scrubjay/grid/grid_view.hpp>

namespace scrubjay {

/// Calls `visit(CellIndex)` for every cell that the line from `from` to `to` passes, in order, both ends included.
/// Amanatides and Woo, *A Fast Voxel Traversal Algorithm for Ray Tracing*, 1987. Cells may lie outside of the grid.
template <typename Visit>
void visit_line(const GridGeometry& grid, const Point2& from, const Point2& to, Visit&& visit) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  CellIndex cell = grid.cell_at(from);
  const CellIndex last = grid.cell_at(to);
  const Point2 way = to - from;
  const int step_x = way.x() > 0.0 ? 1 : -1;
  const int step_y = way.y() > 0.0 ? 1 : -1;
  // Shares of the way at which the line leaves the cell, and that it takes to cross one.
  const double per_x = way.x() != 0.0 ? grid.resolution / std::fabs(way.x()) : kNever;
  const double per_y = way.y() != 0.0 ? grid.resolution / std::fabs(way.y()) : kNever;
  const double edge_x = grid.origin.x() + (cell.x + (step_x > 0 ? 1 : 0)) * grid.resolution;
  const double edge_y = grid.origin.y() + (cell.y + (step_y > 0 ? 1 : 0)) * grid.resolution;
  double next_x = way.x() != 0.0 ? (edge_x - from.x()) / way.x() : kNever;
  double next_y = way.y() != 0.0 ? (edge_y - from.y()) / way.y() : kNever;

  // The number of steps is known beforehand, so rounding can't make the walk miss its end.
  for (int steps = std::abs(last.x - cell.x) + std::abs(last.y - cell.y);; --steps) {
    visit(cell);
    if (steps == 0) return;
    const bool along_x = cell.y == last.y || (cell.x != last.x && next_x < next_y);
    if (along_x) {
      cell.x += step_x;
      next_x += per_x;
    } else {
      cell.y += step_y;
      next_y += per_y;
    }
  }
}

/// Calls `visit(CellIndex)` for every cell of the grid whose centre lies within `radius` of `center`, row by row.
template <typename Visit>
void visit_disc(const GridGeometry& grid, const Point2& center, double radius, Visit&& visit) {
  const double cx = (center.x() - grid.origin.x()) / grid.resolution - 0.5;  // in cells, from centre (0, 0)
  const double cy = (center.y() - grid.origin.y()) / grid.resolution - 0.5;
  const double r = radius / grid.resolution;
  const int first_row = std::max(0, static_cast<int>(std::ceil(cy - r)));
  const int last_row = std::min<int>(grid.height - 1, static_cast<int>(std::floor(cy + r)));
  for (int y = first_row; y <= last_row; ++y) {
    const double half = std::sqrt(std::max(0.0, r * r - (y - cy) * (y - cy)));
    const int first = std::max(0, static_cast<int>(std::ceil(cx - half)));
    const int last = std::min<int>(grid.width - 1, static_cast<int>(std::floor(cx + half)));
    for (int x = first; x <= last; ++x) visit(CellIndex{x, y});
  }
}

/// Calls `visit(CellIndex)` once for every cell that holds one of the points, at most half a cell apart, on the arc of
/// `radius` around `center` between two bearings [rad], counter-clockwise and at most 3/4 of a turn apart. The radius
/// must be two cells or more. Cells may lie outside of the grid.
template <typename Visit>
void visit_arc(const GridGeometry& grid, const Point2& center, double radius, double from, double to, Visit&& visit) {
  const int steps = std::max(1, static_cast<int>(std::ceil((to - from) * radius / (0.5 * grid.resolution))));
  // An arc that grazes a cell's border may leave the cell and come back: hence two cells are remembered, not one.
  CellIndex before{std::numeric_limits<std::int32_t>::min(), 0};
  CellIndex earlier = before;
  for (int i = 0; i <= steps; ++i) {
    const CellIndex cell = grid.cell_at(center + radius * direction(from + (to - from) * i / steps));
    if (cell == before) continue;
    if (cell != earlier) visit(cell);
    earlier = before;
    before = cell;
  }
}

}  // namespace scrubjay
