#include <algorithm>
#include <cmath>
#include <scrubjay/error.hpp>
#include <scrubjay/world/score.hpp>
#include <string>

namespace scrubjay {
namespace {

bool known_free(Occupancy value) {
  return value >= kFree && value <= kFreeUpTo;
}
bool occupied(Occupancy value) {
  return value >= kOccupiedFrom;
}

/// Yes out of all.
struct Ratio {
  std::size_t yes = 0;
  std::size_t all = 0;

  void count(bool is) {
    yes += is ? 1 : 0;
    ++all;
  }
  double value() const { return all == 0 ? 1.0 : static_cast<double>(yes) / static_cast<double>(all); }
};

/// Calls `visit` for every cell of the grid, row by row.
template <typename Visit>
void visit_all(const GridGeometry& grid, const Visit& visit) {
  for (std::int32_t y = 0; y < grid.height; ++y) {
    for (std::int32_t x = 0; x < grid.width; ++x) visit(CellIndex{x, y});
  }
}

/// Whether `is` holds for the cell or one of its eight neighbours in the grid.
template <typename Is>
bool any_within_one(const GridGeometry& grid, CellIndex cell, const Is& is) {
  for (std::int32_t y = cell.y - 1; y <= cell.y + 1; ++y) {
    for (std::int32_t x = cell.x - 1; x <= cell.x + 1; ++x) {
      if (grid.contains({x, y}) && is(CellIndex{x, y})) return true;
    }
  }
  return false;
}

class Scorer {
 public:
  Scorer(GridView<const Occupancy> map, const GroundTruth& truth, const std::vector<std::uint16_t>& followed)
      : map_(map), truth_(truth), followed_(truth.boundary_count + std::size_t{1}, followed.empty()) {
    // A wall that can't be touched belongs to no boundary, and is nobody's mistake.
    followed_[0] = true;
    for (const std::uint16_t boundary : followed) {
      if (boundary < followed_.size()) followed_[boundary] = true;
    }
  }

  MapScore score() {
    visit_all(truth_.geometry, [&](CellIndex cell) { count_truth(cell); });
    visit_all(map_.geometry, [&](CellIndex cell) { count_map(cell); });
    return {coverage_.value(),          iou_.value(), recall_.value(), precision_.value(), followed_recall_.value(),
            followed_precision_.value()};
  }

 private:
  const GroundTruth::Cell& true_cell(CellIndex cell) const { return truth_.cells[truth_.geometry.index(cell)]; }

  void count_truth(CellIndex cell) {
    const GroundTruth::Cell& is = true_cell(cell);
    if (!is.reachable && !is.facing) return;
    const CellIndex at = map_.geometry.cell_at(truth_.geometry.center(cell));
    if (is.reachable) {
      const bool known = map_.contains(at) && known_free(map_[at]);
      coverage_.count(known);
      iou_.count(known);
    }
    if (is.facing) {
      const bool found = any_within_one(map_.geometry, at, [&](CellIndex near) { return occupied(map_[near]); });
      recall_.count(found);
      if (followed_[is.boundary]) followed_recall_.count(found);
    }
  }

  void count_map(CellIndex cell) {
    const CellIndex at = truth_.geometry.cell_at(map_.geometry.center(cell));
    if (known_free(map_[cell])) {
      // Reachable ones were counted from the other side.
      if (!truth_.geometry.contains(at) || !true_cell(at).reachable) iou_.count(false);
    } else if (occupied(map_[cell])) {
      const bool wall = any_within_one(truth_.geometry, at, [&](CellIndex near) { return true_cell(near).wall; });
      const bool followed_wall = any_within_one(truth_.geometry, at, [&](CellIndex near) {
        return true_cell(near).wall && followed_[true_cell(near).boundary];
      });
      precision_.count(wall);
      if (!wall || followed_wall) followed_precision_.count(followed_wall);
    }
  }

  GridView<const Occupancy> map_;
  const GroundTruth& truth_;
  std::vector<bool> followed_;  ///< by number of boundary
  Ratio coverage_, iou_, recall_, precision_, followed_recall_, followed_precision_;
};

}  // namespace

MapScore score_map(GridView<const Occupancy> map, const GroundTruth& truth,
                   const std::vector<std::uint16_t>& followed) {
  if (!(std::fabs(map.geometry.resolution - truth.geometry.resolution) <= 1e-6 * truth.geometry.resolution)) {
    throw Error("the map's resolution is " + std::to_string(map.geometry.resolution) + "; want the truth's, " +
                std::to_string(truth.geometry.resolution) + " m");
  }
  return Scorer(map, truth, followed).score();
}

}  // namespace scrubjay
