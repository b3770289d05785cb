/// \file
/// Maps made of rectangles, in metres.
#pragma once

#include <cmath>
#include <scrubjay/grid/cell_rect.hpp>
#include <scrubjay/grid/log_odds.hpp>
#include <vector>

namespace scrubjay::test {

/// Solid to begin with; floor is carved out of it, and things are put onto that. Metres count from the lower left
/// corner; sides should lie on cells' borders.
class FloorPlan {
 public:
  static constexpr LogOdds kFloor = -60;
  static constexpr LogOdds kSolid = 80;

  FloorPlan(double width, double height, double resolution = 0.05) {
    geometry_ = {resolution, {0.0, 0.0}, cells(width, resolution), cells(height, resolution)};
    cells_.assign(geometry_.size(), kSolid);
  }

  FloorPlan& carve(double left, double bottom, double right, double top) {
    return fill(left, bottom, right, top, kFloor);
  }
  FloorPlan& block(double left, double bottom, double right, double top) {
    return fill(left, bottom, right, top, kSolid);
  }
  FloorPlan& forget(double left, double bottom, double right, double top) { return fill(left, bottom, right, top, 0); }

  GridView<LogOdds> view() { return {geometry_, cells_.data()}; }
  GridView<const LogOdds> view() const { return {geometry_, cells_.data()}; }

 private:
  static std::int32_t cells(double length, double resolution) {
    return static_cast<std::int32_t>(std::lround(length / resolution));
  }
  FloorPlan& fill(double left, double bottom, double right, double top, LogOdds value) {
    const double side = geometry_.resolution;
    const CellRect rect = intersection(
        {{cells(left, side), cells(bottom, side)}, {cells(right, side), cells(top, side)}}, cells_of(geometry_));
    for (std::int32_t y = rect.low.y; y < rect.high.y; ++y) {
      for (std::int32_t x = rect.low.x; x < rect.high.x; ++x) view()[{x, y}] = value;
    }
    return *this;
  }

  GridGeometry geometry_;
  std::vector<LogOdds> cells_;
};

}  // namespace scrubjay::test
