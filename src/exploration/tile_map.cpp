#include <cmath>
#include <cstdlib>
#include <scrubjay/error.hpp>
#include <scrubjay/exploration/tile_map.hpp>
#include <utility>

namespace scrubjay {
namespace {

std::int32_t floor_divide(std::int32_t value, std::int32_t divisor) {
  return value / divisor - (value % divisor < 0);
}

}  // namespace

TileMap::TileMap(const TileParams& params) : params_(params), wall_from_(log_odds(params.wall)) {
  if (params.side < 1 || params.side > 200) {
    throw Error("TileParams.side is " + std::to_string(params.side) + "; want 1 to 200 cells");
  }
}

void TileMap::update(GridView<const LogOdds> map, const CellRect& changed) {
  follow(map.geometry);
  const CellRect cells = intersection(changed, cells_of(map.geometry));
  if (cells.empty()) return;
  const auto tile_of = [&](CellIndex cell) {
    return CellIndex{(cell.x - first_.x) / params_.side, (cell.y - first_.y) / params_.side};
  };
  const CellIndex low = tile_of(cells.low);
  const CellIndex last = tile_of({cells.high.x - 1, cells.high.y - 1});
  for (std::int32_t y = low.y; y <= last.y; ++y) {
    for (std::int32_t x = low.x; x <= last.x; ++x) tiles_[geometry_.index({x, y})] = count(map, {x, y});
  }
}

/// Lays tiles over a map that may have grown. Cells beyond its old borders were as unknown as they are now, so that
/// counts only move.
void TileMap::follow(const GridGeometry& map) {
  const CellIndex cell{static_cast<std::int32_t>(std::lround(map.origin.x() / map.resolution)),
                       static_cast<std::int32_t>(std::lround(map.origin.y() / map.resolution))};
  // One tile more on every side: floor may be known up to the map's border, and what is unknown begins beyond it.
  const CellIndex corner{floor_divide(cell.x, params_.side) - 1, floor_divide(cell.y, params_.side) - 1};
  first_ = {corner.x * params_.side - cell.x, corner.y * params_.side - cell.y};
  GridGeometry grown;
  grown.resolution = params_.side * map.resolution;
  grown.origin = map.origin + map.resolution * Point2(first_.x, first_.y);
  grown.width = (map.width - first_.x + params_.side - 1) / params_.side + 1;
  grown.height = (map.height - first_.y + params_.side - 1) / params_.side + 1;
  if (corner == corner_ && grown.width == geometry_.width && grown.height == geometry_.height) return;

  std::vector<Tile> tiles(grown.size());
  for (std::int32_t y = 0; y < geometry_.height; ++y) {
    for (std::int32_t x = 0; x < geometry_.width; ++x) {
      const CellIndex moved{x + corner_.x - corner.x, y + corner_.y - corner.y};
      if (grown.contains(moved)) tiles[grown.index(moved)] = tiles_[geometry_.index({x, y})];
    }
  }
  geometry_ = grown;
  corner_ = corner;
  tiles_ = std::move(tiles);
}

TileMap::Tile TileMap::count(GridView<const LogOdds> map, CellIndex tile) const {
  const CellIndex low{first_.x + tile.x * params_.side, first_.y + tile.y * params_.side};
  const CellRect cells = intersection({low, {low.x + params_.side, low.y + params_.side}}, cells_of(map.geometry));
  Tile counted;
  for (std::int32_t y = cells.low.y; y < cells.high.y; ++y) {
    for (std::int32_t x = cells.low.x; x < cells.high.x; ++x) {
      const LogOdds cell = map[{x, y}];
      if (cell <= kFreeLogOdds) ++counted.free;
      if (cell >= kOccupiedLogOdds) ++counted.occupied;
      if (cell >= wall_from_) counted.wall = true;
    }
  }
  return counted;
}

int TileMap::undecided(CellIndex tile) const {
  const Tile t = tile_at(tile);
  return params_.side * params_.side - t.free - t.occupied;
}

bool TileMap::open(CellIndex tile) const {
  const Tile t = tile_at(tile);
  return !t.wall && 2 * t.free > params_.side * params_.side;
}

double TileMap::undecided_share(CellIndex tile) const {
  return static_cast<double>(undecided(tile)) / (params_.side * params_.side);
}

int TileMap::undecided_around(CellIndex tile) const {
  int sum = 0;
  for (std::int32_t y = tile.y - 1; y <= tile.y + 1; ++y) {
    for (std::int32_t x = tile.x - 1; x <= tile.x + 1; ++x) sum += undecided({x, y});
  }
  return sum;
}

bool TileMap::frontier(CellIndex tile) const {
  const Tile t = tile_at(tile);
  if (t.wall || undecided_share(tile) < params_.frontier_share) return false;
  return t.free >= params_.known_share * params_.side * params_.side || open({tile.x - 1, tile.y}) ||
         open({tile.x + 1, tile.y}) || open({tile.x, tile.y - 1}) || open({tile.x, tile.y + 1});
}

std::vector<CellIndex> TileMap::frontiers() const {
  std::vector<CellIndex> found;
  for (std::int32_t y = 0; y < geometry_.height; ++y) {
    for (std::int32_t x = 0; x < geometry_.width; ++x) {
      if (frontier({x, y})) found.push_back({x, y});
    }
  }
  return found;
}

bool TileMap::sees(CellIndex from, CellIndex to) const {
  // The line between the same two tiles is the same one, whoever looks.
  if (std::pair(to.y, to.x) < std::pair(from.y, from.x)) std::swap(from, to);
  const std::int32_t dx = std::abs(to.x - from.x);
  const std::int32_t dy = -std::abs(to.y - from.y);
  const std::int32_t step_x = from.x < to.x ? 1 : -1;
  const std::int32_t step_y = from.y < to.y ? 1 : -1;
  std::int32_t error = dx + dy;
  for (CellIndex tile = from; tile != to;) {
    const CellIndex before = tile;
    const std::int32_t twice = 2 * error;
    if (twice >= dy) {
      error += dy;
      tile.x += step_x;
    }
    if (twice <= dx) {
      error += dx;
      tile.y += step_y;
    }
    if (tile != to && wall(tile)) return false;
    const bool diagonal = tile.x != before.x && tile.y != before.y;
    if (diagonal && wall({tile.x, before.y}) && wall({before.x, tile.y})) return false;
  }
  return true;
}

}  // namespace scrubjay
