#include <algorithm>
#include <cmath>
#include <limits>
#include <scrubjay/error.hpp>
#include <scrubjay/mapping/growing_map.hpp>

namespace scrubjay {

GrowingMap::GrowingMap(double resolution) {
  geometry_.resolution = resolution;
}

void GrowingMap::cover(const Point2& center, double radius) {
  const double r = geometry_.resolution;
  const double limit = kReach * r;
  if (!(std::fabs(center.x()) < limit && std::fabs(center.y()) < limit)) {
    throw Error("the map can't grow to (" + std::to_string(center.x()) + ", " + std::to_string(center.y()) +
                    "): the pose estimate has gone astray",
                Error::Kind::Failure);
  }
  const CellIndex low{static_cast<std::int32_t>(std::floor((center.x() - radius) / r)),
                      static_cast<std::int32_t>(std::floor((center.y() - radius) / r))};
  const CellIndex high{static_cast<std::int32_t>(std::floor((center.x() + radius) / r)) + 1,
                       static_cast<std::int32_t>(std::floor((center.y() + radius) / r)) + 1};
  cover(CellRect{low, high});
}

void GrowingMap::cover(const CellRect& cells) {
  const bool inside = !cells_.empty() && cells.low.x >= corner_.x && cells.low.y >= corner_.y &&
                      cells.high.x <= corner_.x + geometry_.width && cells.high.y <= corner_.y + geometry_.height;
  if (!inside) grow_to(cells.low, cells.high);
}

void GrowingMap::grow_to(CellIndex low, CellIndex high) {
  const GridGeometry old = geometry_;
  const CellIndex old_corner = corner_;
  std::vector<LogOdds> old_cells = std::move(cells_);
  if (!old_cells.empty()) {
    // Each side that must move, moves by at least half the width there is.
    const std::int32_t spare_x = geometry_.width / 2;
    const std::int32_t spare_y = geometry_.height / 2;
    low.x = low.x < corner_.x ? std::min(low.x, corner_.x - spare_x) : corner_.x;
    low.y = low.y < corner_.y ? std::min(low.y, corner_.y - spare_y) : corner_.y;
    const std::int32_t old_right = corner_.x + geometry_.width;
    const std::int32_t old_top = corner_.y + geometry_.height;
    high.x = high.x > old_right ? std::max(high.x, old_right + spare_x) : old_right;
    high.y = high.y > old_top ? std::max(high.y, old_top + spare_y) : old_top;
  }
  corner_ = low;
  geometry_.width = high.x - low.x;
  geometry_.height = high.y - low.y;
  geometry_.origin = {low.x * geometry_.resolution, low.y * geometry_.resolution};
  cells_.assign(geometry_.size(), LogOdds{0});
  for (std::int32_t y = 0; y < (old_cells.empty() ? 0 : old.height); ++y) {
    const auto row = old_cells.begin() + static_cast<std::ptrdiff_t>(old.index({0, y}));
    const CellIndex to{old_corner.x - low.x, old_corner.y - low.y + y};
    std::copy_n(row, old.width, cells_.begin() + static_cast<std::ptrdiff_t>(geometry_.index(to)));
  }
}

OccupancyGrid GrowingMap::occupancy() const {
  CellIndex low{std::numeric_limits<std::int32_t>::max(), std::numeric_limits<std::int32_t>::max()};
  CellIndex high{-1, -1};
  for (std::int32_t y = 0; y < geometry_.height; ++y) {
    for (std::int32_t x = 0; x < geometry_.width; ++x) {
      if (view()[{x, y}] == 0) continue;
      low = {std::min(low.x, x), std::min(low.y, y)};
      high = {std::max(high.x, x), std::max(high.y, y)};
    }
  }
  if (high.x < 0) low = high = {0, 0};

  OccupancyGrid out;
  out.geometry.resolution = geometry_.resolution;
  out.geometry.origin = {(corner_.x + low.x) * geometry_.resolution, (corner_.y + low.y) * geometry_.resolution};
  out.geometry.width = high.x - low.x + 1;
  out.geometry.height = high.y - low.y + 1;
  out.cells.reserve(out.geometry.size());
  for (std::int32_t y = low.y; y <= high.y; ++y) {
    for (std::int32_t x = low.x; x <= high.x; ++x) {
      out.cells.push_back(cells_.empty() ? kUnknown : trinary(view()[{x, y}]));
    }
  }
  return out;
}

}  // namespace scrubjay
