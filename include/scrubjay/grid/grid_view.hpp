/// \file
/// Grids over somebody else's cells.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <scrubjay/geometry/pose2.hpp>

namespace scrubjay {

/// Column and row of a cell; (0, 0) is the lowest left one.
struct CellIndex {
  std::int32_t x = 0;
  std::int32_t y = 0;

  bool operator==(const CellIndex&) const = default;
};

/// Where a grid's cells lie. Rows run along x, from the origin upwards, as in nav_msgs/OccupancyGrid.
struct GridGeometry {
  double resolution = 0.05;  ///< side of a cell [m]
  Point2 origin{0.0, 0.0};   ///< lower left corner of cell (0, 0) [m]
  std::int32_t width = 0;    ///< [cells]
  std::int32_t height = 0;   ///< [cells]

  bool contains(CellIndex c) const { return c.x >= 0 && c.y >= 0 && c.x < width && c.y < height; }
  std::size_t size() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
  /// Place of a contained cell in row-major storage.
  std::size_t index(CellIndex c) const {
    return static_cast<std::size_t>(c.y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(c.x);
  }
  /// The cell that holds the point, which may lie outside of the grid.
  CellIndex cell_at(const Point2& p) const {
    return {static_cast<std::int32_t>(std::floor((p.x() - origin.x()) / resolution)),
            static_cast<std::int32_t>(std::floor((p.y() - origin.y()) / resolution))};
  }
  Point2 center(CellIndex c) const {
    return {origin.x() + (c.x + 0.5) * resolution, origin.y() + (c.y + 0.5) * resolution};
  }
  bool operator==(const GridGeometry&) const = default;
};

/// A grid over the caller's `geometry.size()` cells, row-major.
template <typename Cell>
struct GridView {
  GridGeometry geometry;
  Cell* cells = nullptr;

  Cell& operator[](CellIndex c) const { return cells[geometry.index(c)]; }
  bool contains(CellIndex c) const { return geometry.contains(c); }
  operator GridView<const Cell>() const { return {geometry, cells}; }
};

/// Occupancy as in nav_msgs: -1 unknown, 0 free ... 100 occupied.
using Occupancy = std::int8_t;
inline constexpr Occupancy kUnknown = -1;
inline constexpr Occupancy kFree = 0;
inline constexpr Occupancy kOccupied = 100;

}  // namespace scrubjay
