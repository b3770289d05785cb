/// \file
/// A log-odds map that grows where it is written.
#pragma once

#include <scrubjay/grid/cell_rect.hpp>
#include <scrubjay/grid/grid_view.hpp>
#include <scrubjay/grid/log_odds.hpp>
#include <scrubjay/mapping/occupancy_grid.hpp>
#include <vector>

namespace scrubjay {

/// Starts empty; cell corners stay at multiples of the resolution however it grows.
class GrowingMap {
 public:
  /// Nothing farther from the origin along either axis than this is mapped [cells]; 800 m at 5 cm: past it, a pose has
  /// gone astray.
  static constexpr std::int32_t kReach = 16384;

  /// `resolution` > 0 [m].
  explicit GrowingMap(double resolution);

  /// Makes sure that every cell within `radius` [m] of `center` is there. Grows by doubling, so that growing costs
  /// constant time a cell in the long run.
  /// Throws Error for a center beyond kReach.
  void cover(const Point2& center, double radius);
  /// The same for cells counted from the map frame's origin, whatever their reach.
  void cover(const CellRect& cells);

  /// Cell (0, 0), counted in cells from the map frame's origin; a cell's place among all those that ever may be there
  /// is its index plus this, however the map grows.
  CellIndex corner() const { return corner_; }
  GridView<LogOdds> view() { return {geometry_, cells_.data()}; }
  GridView<const LogOdds> view() const { return {geometry_, cells_.data()}; }
  /// nav2's trinary values, cut to the cells that hold any evidence (one unknown cell if there are none).
  OccupancyGrid occupancy() const;

 private:
  void grow_to(CellIndex low, CellIndex high);

  GridGeometry geometry_;
  CellIndex corner_;
  std::vector<LogOdds> cells_;
};

}  // namespace scrubjay
