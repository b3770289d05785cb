/// \file
/// A map split in square tiles: what is known of each, which are walls and frontiers, and which see each other.
#pragma once

#include <cstdint>
#include <scrubjay/grid/cell_rect.hpp>
#include <scrubjay/grid/log_odds.hpp>
#include <vector>

namespace scrubjay {

/// Figures of a student project on a TurtleBot3 (Bologna, 2023/24), which this method is from.
struct TileParams {
  int side = 5;        ///< of a tile [cells]
  double wall = 0.70;  ///< a tile with any cell more likely occupied than this is a wall
  /// From this share F of undecided cells on, a tile is a frontier (in the original, 0.40 to 0.50).
  double frontier_share = 0.45;
  /// A tile borders on known floor by itself from this share of free cells on. Our own choice: less is what the errors
  /// of readings leave behind walls.
  double known_share = 0.12;
};

/// Counts free and undecided cells by tile, where the map changed, whatever the map's size. Tiles are told by column
/// and row in geometry(), which grows with the map; they stay where they are in the map's frame.
///
/// A cell is undecided if it is neither free nor occupied (nav2's thresholds). In the original's map, whose values
/// settle slowly, cells at the rim of what the robot saw stay partly known (15 to 60 of 100), and a tile full of them
/// is a frontier. Log-odds cells are settled by a few scans, so that their rim is a cell or two wide and gone as soon
/// as the robot stands. What it tells is still there: floor begins to be unknown. Hence here a tile is a frontier if it
/// isn't a wall, its share F of undecided cells is large enough, and it borders on known floor: it holds some of that
/// itself or shares an edge with a tile that is open.
class TileMap {
 public:
  explicit TileMap(const TileParams& params = {});

  /// Outside of `changed`, `map` holds what it held at the last update (moved, if it grew).
  void update(GridView<const LogOdds> map, const CellRect& changed);

  /// Tiles as the cells of a grid.
  const GridGeometry& geometry() const { return geometry_; }
  bool wall(CellIndex tile) const { return tile_at(tile).wall; }
  /// More than half of it is free, and it is no wall.
  bool open(CellIndex tile) const;
  /// F: the share of cells that are neither free nor occupied.
  double undecided_share(CellIndex tile) const;
  /// The number of undecided cells in a tile and the eight around it.
  int undecided_around(CellIndex tile) const;
  bool frontier(CellIndex tile) const;
  /// Row by row.
  std::vector<CellIndex> frontiers() const;
  /// True if no wall stands on the straight line between two tiles (Bresenham, *Algorithm for Computer Control of a
  /// Digital Plotter*, 1965), themselves aside; nor does it slip between two walls that touch at a corner. Works both
  /// ways round.
  bool sees(CellIndex from, CellIndex to) const;

 private:
  struct Tile {
    std::uint16_t free = 0;
    std::uint16_t occupied = 0;
    bool wall = false;
  };

  Tile tile_at(CellIndex tile) const { return geometry_.contains(tile) ? tiles_[geometry_.index(tile)] : Tile{}; }
  int undecided(CellIndex tile) const;
  void follow(const GridGeometry& map);
  Tile count(GridView<const LogOdds> map, CellIndex tile) const;

  TileParams params_;
  LogOdds wall_from_;
  GridGeometry geometry_;
  CellIndex corner_;       // of tile (0, 0), counted in tiles from the map frame's origin
  CellIndex first_{0, 0};  // cell of tile (0, 0), counted from the map's cell (0, 0); not above it
  std::vector<Tile> tiles_;
};

}  // namespace scrubjay
