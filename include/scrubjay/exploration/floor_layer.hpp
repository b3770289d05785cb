/// \file
/// A layer of one's own over a map that grows.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <scrubjay/grid/cell_rect.hpp>
#include <vector>

namespace scrubjay {

/// Keeps a value for every cell of a map, and moves along when the map grows by whole cells.
template <typename Value>
class FloorLayer {
 public:
  /// `nothing` is what cells hold that were never written, and those outside of the map.
  explicit FloorLayer(Value nothing = Value{}) : nothing_(nothing) {}

  void follow(const GridGeometry& map) {
    if (map == geometry_) return;
    const GridGeometry old = geometry_;
    const std::vector<Value> old_cells = std::move(cells_);
    geometry_ = map;
    cells_.assign(map.size(), nothing_);
    if (old_cells.empty()) return;
    const Point2 move = (old.origin - map.origin) / map.resolution;
    const CellIndex corner{static_cast<std::int32_t>(std::lround(move.x())),
                           static_cast<std::int32_t>(std::lround(move.y()))};
    const CellRect kept = intersection({corner, {corner.x + old.width, corner.y + old.height}}, cells_of(map));
    for (std::int32_t y = kept.low.y; y < kept.high.y && !kept.empty(); ++y) {
      const auto from = static_cast<std::ptrdiff_t>(old.index({kept.low.x - corner.x, y - corner.y}));
      const auto to = static_cast<std::ptrdiff_t>(map.index({kept.low.x, y}));
      std::copy_n(old_cells.begin() + from, kept.high.x - kept.low.x, cells_.begin() + to);
    }
  }

  const GridGeometry& geometry() const { return geometry_; }
  bool contains(CellIndex cell) const { return geometry_.contains(cell); }
  Value operator[](CellIndex cell) const { return contains(cell) ? cells_[geometry_.index(cell)] : nothing_; }
  /// Of a cell within the map.
  Value& at(CellIndex cell) { return cells_[geometry_.index(cell)]; }
  GridView<const Value> view() const { return {geometry_, cells_.data()}; }

 private:
  Value nothing_;
  GridGeometry geometry_;
  std::vector<Value> cells_;
};

}  // namespace scrubjay
