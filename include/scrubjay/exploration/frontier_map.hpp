/// \file
/// Frontiers: where known free floor ends and unknown floor begins.
#pragma once

#include <cstdint>
#include <memory>
#include <scrubjay/grid/cell_rect.hpp>
#include <scrubjay/grid/log_odds.hpp>
#include <span>
#include <vector>

namespace scrubjay {

/// Free cells, connected over edges and corners, each of which has an unknown cell beside it (over an edge). Beyond the
/// map's border everything is unknown. Yamauchi, *A Frontier-Based Approach for Autonomous Exploration*, 1997.
struct Frontier {
  std::uint32_t id = 0;          ///< the same as long as none of its cells change; never used again
  std::vector<CellIndex> cells;  ///< of the map as it is now; at least one
  CellRect bounds;
  Point2 centroid{0.0, 0.0};  ///< mean of its cells' centres [m]
};

/// Finds frontiers where the map changed, and keeps the others: the work is by the size of the change, whatever the
/// map's. (Quin, Nguyen, Vu, Alempijevic, Paul, *Approaches for Efficiently Detecting Frontier Cells in Robotics
/// Exploration*, 2021: naive active area; here with connected components kept up, too.)
class FrontierMap {
 public:
  /// Outside of `changed`, `map` holds what it held at the last update (moved, if it grew). The first update, and one
  /// with a map that lost cells or has another resolution, looks at all of it.
  void update(GridView<const LogOdds> map, const CellRect& changed);
  /// In an order that depends on nothing but the updates so far; valid until the next update.
  std::span<const Frontier> frontiers() const { return frontiers_; }
  /// True if the cell is of a frontier; false for cells outside of the map.
  bool contains(CellIndex cell) const;

 private:
  void resize(const GridGeometry& geometry);
  void start_over(const GridGeometry& geometry);
  bool move_to(const GridGeometry& geometry);
  std::size_t slot(CellIndex cell) const;
  void set(CellIndex cell, bool frontier);
  void compare(GridView<const LogOdds> map, const CellRect& area);
  void dissolve(std::uint32_t index);
  void dissolve_around(CellIndex cell);
  void regrow();
  void grow(Frontier& frontier, std::uint32_t index, CellIndex seed);
  void close_gaps();

  GridGeometry geometry_;
  std::vector<Frontier> frontiers_;
  std::uint32_t next_id_ = 1;
  // One bit a cell: is it of a frontier? Rows begin with a word.
  std::size_t words_per_row_ = 0;
  std::vector<std::uint64_t> bits_;
  // For cells whose bit is set: the place of their frontier in frontiers_. Elsewhere never written nor read, and laid
  // out in square tiles, so memory is touched along frontiers only (frontier_bench).
  std::unique_ptr<std::uint32_t[]> index_;
  // Of the update at work; kept for their memory.
  std::vector<std::uint8_t> row_;
  std::vector<CellIndex> appeared_, vanished_, loose_;
  std::vector<std::uint32_t> gaps_;  // places in frontiers_ whose frontier was dissolved
};

}  // namespace scrubjay
