#include "disc_lattice.hpp"

#include <algorithm>
#include <array>
#include <scrubjay/error.hpp>
#include <span>
#include <string>

namespace scrubjay {

DiscLattice::DiscLattice(const GridGeometry& nodes) : geometry(nodes) {
  if (geometry.size() > kMostNodes) {
    throw Error("a world of " + std::to_string(static_cast<long>(geometry.width * geometry.resolution)) + " x " +
                std::to_string(static_cast<long>(geometry.height * geometry.resolution)) +
                " m is too large for this resolution; want larger cells");
  }
  labels.assign(geometry.size(), kFree);
  for (std::int32_t x = 0; x < geometry.width; ++x) (*this)[{x, 0}] = (*this)[{x, geometry.height - 1}] = kBlocked;
  for (std::int32_t y = 0; y < geometry.height; ++y) (*this)[{0, y}] = (*this)[{geometry.width - 1, y}] = kBlocked;
}

bool DiscLattice::on_rim(CellIndex node, std::uint32_t label) const {
  const std::uint32_t* at = &labels[geometry.index(node)];
  return *at == label &&
         (at[-1] != label || at[1] != label || at[-geometry.width] != label || at[geometry.width] != label);
}

void block_near(DiscLattice& lattice, const Segment2& segment, double radius) {
  const GridGeometry& grid = lattice.geometry;
  const Point2& low = segment.a.y() <= segment.b.y() ? segment.a : segment.b;
  const Point2& high = segment.a.y() <= segment.b.y() ? segment.b : segment.a;
  const double rise = high.y() - low.y();
  const auto clamped = [](std::int32_t value, std::int32_t count) { return std::clamp(value, 1, count - 2); };
  const std::int32_t last_row = clamped(grid.cell_at({0.0, high.y() + radius}).y, grid.height);
  for (std::int32_t y = clamped(grid.cell_at({0.0, low.y() - radius}).y, grid.height); y <= last_row; ++y) {
    // Only the part of the segment within `radius` of the row can come near its nodes.
    const double row = grid.center({0, y}).y();
    const double from = rise > 0.0 ? std::clamp((row - radius - low.y()) / rise, 0.0, 1.0) : 0.0;
    const double to = rise > 0.0 ? std::clamp((row + radius - low.y()) / rise, 0.0, 1.0) : 1.0;
    const double x0 = low.x() + from * (high.x() - low.x());
    const double x1 = low.x() + to * (high.x() - low.x());
    const std::int32_t last = clamped(grid.cell_at({std::max(x0, x1) + radius, row}).x, grid.width);
    for (std::int32_t x = clamped(grid.cell_at({std::min(x0, x1) - radius, row}).x, grid.width); x <= last; ++x) {
      if (squared_distance(segment, grid.center({x, y})) < radius * radius) lattice[{x, y}] = DiscLattice::kBlocked;
    }
  }
}

void block_inside(DiscLattice& lattice, const Polygon& polygon) {
  if (polygon.empty()) return;
  Point2 low = polygon.front();
  Point2 high = low;
  for (const Point2& corner : polygon) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  const CellIndex first = lattice.geometry.cell_at(low);
  const CellIndex last = lattice.geometry.cell_at(high);
  for (std::int32_t y = first.y; y <= last.y; ++y) {
    for (std::int32_t x = first.x; x <= last.x; ++x) {
      if (!lattice.geometry.contains({x, y})) continue;
      if (contains(polygon, lattice.geometry.center({x, y}))) lattice[{x, y}] = DiscLattice::kBlocked;
    }
  }
}

std::size_t flood(DiscLattice& lattice, CellIndex seed, std::uint32_t to, Neighbours neighbours) {
  const std::ptrdiff_t row = lattice.geometry.width;
  const std::array<std::ptrdiff_t, 8> steps{1, -1, row, -row, row + 1, row - 1, -row + 1, -row - 1};
  const std::span<const std::ptrdiff_t> around(steps.data(), neighbours == Neighbours::Four ? 4 : 8);
  const std::uint32_t from = lattice[seed];
  lattice[seed] = to;
  std::vector<std::size_t> open{lattice.geometry.index(seed)};
  std::size_t count = 0;
  while (!open.empty()) {
    const std::size_t node = open.back();
    open.pop_back();
    ++count;
    for (const std::ptrdiff_t step : around) {
      const std::size_t next = node + static_cast<std::size_t>(step);
      if (next >= lattice.labels.size() || lattice.labels[next] != from) continue;
      lattice.labels[next] = to;
      open.push_back(next);
    }
  }
  return count;
}

}  // namespace scrubjay
