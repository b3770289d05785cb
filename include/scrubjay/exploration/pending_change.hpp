/// \file
/// What changed in a map that grows, since one looked.
#pragma once

#include <cmath>
#include <scrubjay/grid/cell_rect.hpp>

namespace scrubjay {

/// For those who look at a map now and then: gathers what changes between two looks.
class PendingChange {
 public:
  /// `changed` are cells of `map`, which is as it was or has grown by whole cells. Before the first look, all is new.
  void add(const GridGeometry& map, const CellRect& changed) {
    if (map_.size() == 0) {
      changed_ = cells_of(map);
    } else if (!(map_ == map) && !changed_.empty()) {
      const Point2 move = (map_.origin - map.origin) / map.resolution;
      const auto dx = static_cast<std::int32_t>(std::lround(move.x()));
      const auto dy = static_cast<std::int32_t>(std::lround(move.y()));
      changed_ = {{changed_.low.x + dx, changed_.low.y + dy}, {changed_.high.x + dx, changed_.high.y + dy}};
    }
    map_ = map;
    changed_ = bounding(changed_, changed);
  }

  /// The smallest rectangle around it all, in the map as it is now; from here on, nothing has changed.
  CellRect take() {
    const CellRect changed = changed_;
    changed_ = {};
    return changed;
  }

 private:
  GridGeometry map_;
  CellRect changed_;
};

}  // namespace scrubjay
