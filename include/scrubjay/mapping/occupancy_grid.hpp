/// \file
/// An occupancy map that owns its cells.
#pragma once

#include <scrubjay/grid/grid_view.hpp>
#include <vector>

namespace scrubjay {

/// What is known of each cell, as in nav_msgs/OccupancyGrid: row-major from the lowest left cell.
struct OccupancyGrid {
  GridGeometry geometry;
  std::vector<Occupancy> cells;  ///< geometry.size() of them

  GridView<const Occupancy> view() const { return {geometry, cells.data()}; }
};

}  // namespace scrubjay
