#include <algorithm>
#include <bit>
#include <functional>
#include <scrubjay/exploration/frontier_map.hpp>

namespace scrubjay {
namespace {

constexpr std::size_t kTile = 32;             // cells a side: a tile of indices is a page of memory
constexpr std::uint32_t kLoose = 0xFFFFFFFF;  // of a frontier that is yet to be grown

std::uint8_t is_unknown(LogOdds cell) {
  constexpr int kClasses = kOccupiedLogOdds - kFreeLogOdds - 1;
  return static_cast<std::uint8_t>(static_cast<std::uint8_t>(cell - kFreeLogOdds - 1) < kClasses);
}

std::uint8_t is_free(LogOdds cell) {
  return static_cast<std::uint8_t>(cell <= kFreeLogOdds);
}

// 1 for frontier cells, 0 for others, for `count` cells of a row between its first and its last: rows are given from
// the first of these cells on. Bytes and no branches, which compilers turn into 16 cells an instruction or more
// (frontier_bench).
void mark_cells(const LogOdds* row, const LogOdds* below, const LogOdds* above, std::int32_t count,
                std::uint8_t* marks) {
  for (std::int32_t x = 0; x < count; ++x) {
    const auto beside = static_cast<std::uint8_t>(is_unknown(row[x - 1]) | is_unknown(row[x + 1]));
    const auto across = static_cast<std::uint8_t>(is_unknown(below[x]) | is_unknown(above[x]));
    marks[x] = static_cast<std::uint8_t>(is_free(row[x]) & (beside | across));
  }
}

// The same for cells from `first` up to `last` of any row of the map.
void mark_row(GridView<const LogOdds> map, std::int32_t y, std::int32_t first, std::int32_t last, std::uint8_t* marks) {
  const std::int32_t width = map.geometry.width;
  const LogOdds* row = &map[{0, y}];
  if (y == 0 || y == map.geometry.height - 1) {  // unknown beyond
    for (std::int32_t x = first; x < last; ++x) marks[x] = is_free(row[x]);
    return;
  }
  const std::int32_t inner_first = std::max(first, 1);
  const std::int32_t inner_last = std::min(last, width - 1);
  mark_cells(row + inner_first, row + inner_first - width, row + inner_first + width, inner_last - inner_first,
             marks + inner_first);
  if (first == 0) marks[0] = is_free(row[0]);
  if (last == width) marks[width - 1] = is_free(row[width - 1]);
}

// 64 marks as bits, the first one lowest.
std::uint64_t gather(const std::uint8_t* marks) {
  std::uint64_t bits = 0;
  for (int group = 0; group < 8; ++group) {
    std::uint64_t bytes = 0;
    for (int i = 0; i < 8; ++i) bytes |= static_cast<std::uint64_t>(marks[8 * group + i]) << (8 * i);
    // Moves bit 8 i to bit 56 + i; nothing carries.
    bits |= (bytes * 0x0102040810204080u >> 56) << (8 * group);
  }
  return bits;
}

Point2 mean(const GridGeometry& geometry, const std::vector<CellIndex>& cells) {
  std::int64_t x = 0, y = 0;
  for (const CellIndex c : cells) {
    x += c.x;
    y += c.y;
  }
  const auto count = static_cast<double>(cells.size());
  const Point2 cell{static_cast<double>(x) / count + 0.5, static_cast<double>(y) / count + 0.5};
  return geometry.origin + geometry.resolution * cell;
}

}  // namespace

bool FrontierMap::contains(CellIndex cell) const {
  if (!geometry_.contains(cell)) return false;
  const auto x = static_cast<std::size_t>(cell.x);
  return (bits_[static_cast<std::size_t>(cell.y) * words_per_row_ + x / 64] >> (x % 64) & 1) != 0;
}

std::size_t FrontierMap::slot(CellIndex cell) const {
  const auto x = static_cast<std::size_t>(cell.x);
  const auto y = static_cast<std::size_t>(cell.y);
  const std::size_t tiles_per_row = words_per_row_ * 64 / kTile;
  return (y / kTile * tiles_per_row + x / kTile) * kTile * kTile + y % kTile * kTile + x % kTile;
}

void FrontierMap::set(CellIndex cell, bool frontier) {
  const auto x = static_cast<std::size_t>(cell.x);
  std::uint64_t& word = bits_[static_cast<std::size_t>(cell.y) * words_per_row_ + x / 64];
  const std::uint64_t bit = std::uint64_t{1} << (x % 64);
  word = frontier ? word | bit : word & ~bit;
}

void FrontierMap::update(GridView<const LogOdds> map, const CellRect& changed) {
  const bool kept = map.geometry == geometry_ || move_to(map.geometry);
  if (kept && changed.empty()) return;
  if (!kept) start_over(map.geometry);
  compare(map, kept ? intersection(grown(changed, 1), cells_of(geometry_)) : cells_of(geometry_));
  for (const CellIndex cell : vanished_) dissolve(index_[slot(cell)]);
  if (!frontiers_.empty()) {
    for (const CellIndex cell : appeared_) dissolve_around(cell);
  }
  for (const CellIndex cell : vanished_) set(cell, false);
  for (const CellIndex cell : appeared_) set(cell, true);
  regrow();
  close_gaps();
}

void FrontierMap::resize(const GridGeometry& geometry) {
  geometry_ = geometry;
  words_per_row_ = (static_cast<std::size_t>(geometry.width) + 63) / 64;
  bits_.assign(words_per_row_ * static_cast<std::size_t>(geometry.height), 0);
  const std::size_t tile_rows = (static_cast<std::size_t>(geometry.height) + kTile - 1) / kTile;
  index_ = std::make_unique_for_overwrite<std::uint32_t[]>(tile_rows * kTile * words_per_row_ * 64);
  row_.assign(64 * words_per_row_, 0);
}

void FrontierMap::start_over(const GridGeometry& geometry) {
  frontiers_.clear();
  resize(geometry);
}

// Follows a map that grew; false if it didn't only grow.
bool FrontierMap::move_to(const GridGeometry& geometry) {
  if (geometry.resolution != geometry_.resolution || geometry_.size() == 0) return false;
  const Point2 moved = (geometry_.origin - geometry.origin) / geometry.resolution;
  const CellIndex by{static_cast<std::int32_t>(std::lround(moved.x())),
                     static_cast<std::int32_t>(std::lround(moved.y()))};
  if (by.x < 0 || by.y < 0 || by.x + geometry_.width > geometry.width || by.y + geometry_.height > geometry.height) {
    return false;
  }
  resize(geometry);
  for (std::uint32_t index = 0; index < frontiers_.size(); ++index) {
    Frontier& frontier = frontiers_[index];
    for (CellIndex* corner : {&frontier.bounds.low, &frontier.bounds.high})
      *corner = {corner->x + by.x, corner->y + by.y};
    for (CellIndex& cell : frontier.cells) {
      cell = {cell.x + by.x, cell.y + by.y};
      set(cell, true);
      index_[slot(cell)] = index;
    }
  }
  return true;
}

// Lists the cells of the area that have become frontier cells, or are none any more.
void FrontierMap::compare(GridView<const LogOdds> map, const CellRect& area) {
  appeared_.clear();
  vanished_.clear();
  if (area.empty()) return;
  const std::int32_t first = area.low.x / 64 * 64;  // whole words are compared; outside of the area they don't differ
  const std::int32_t last = std::min((area.high.x + 63) / 64 * 64, geometry_.width);
  for (std::int32_t y = area.low.y; y < area.high.y; ++y) {
    mark_row(map, y, first, last, row_.data());
    std::uint64_t* const words = &bits_[static_cast<std::size_t>(y) * words_per_row_];
    for (std::int32_t x = first; x < last; x += 64) {
      const std::uint64_t now = gather(&row_[static_cast<std::size_t>(x)]);
      std::uint64_t differ = now ^ words[x / 64];
      for (; differ != 0; differ &= differ - 1) {
        const int bit = std::countr_zero(differ);
        ((now >> bit & 1) != 0 ? appeared_ : vanished_).push_back({x + bit, y});
      }
    }
  }
}

// Takes a frontier apart; its place becomes a gap, its cells lose.
void FrontierMap::dissolve(std::uint32_t index) {
  std::vector<CellIndex>& cells = frontiers_[index].cells;
  if (cells.empty()) return;
  loose_.insert(loose_.end(), cells.begin(), cells.end());
  cells.clear();
  gaps_.push_back(index);
}

void FrontierMap::dissolve_around(CellIndex cell) {
  for (std::int32_t y = cell.y - 1; y <= cell.y + 1; ++y) {
    for (std::int32_t x = cell.x - 1; x <= cell.x + 1; ++x) {
      if (contains({x, y})) dissolve(index_[slot({x, y})]);
    }
  }
}

// Makes frontiers of all cells that belong to none: those that lost theirs, and new ones.
void FrontierMap::regrow() {
  loose_.insert(loose_.end(), appeared_.begin(), appeared_.end());
  std::erase_if(loose_, [&](CellIndex cell) { return !contains(cell); });
  for (const CellIndex cell : loose_) index_[slot(cell)] = kLoose;
  std::sort(gaps_.begin(), gaps_.end(), std::greater<>());  // the lowest is filled first
  for (const CellIndex cell : loose_) {
    if (index_[slot(cell)] != kLoose) continue;
    auto index = static_cast<std::uint32_t>(frontiers_.size());
    if (gaps_.empty()) {
      frontiers_.emplace_back();
    } else {
      index = gaps_.back();
      gaps_.pop_back();
    }
    grow(frontiers_[index], index, cell);
  }
  loose_.clear();
}

void FrontierMap::grow(Frontier& frontier, std::uint32_t index, CellIndex seed) {
  frontier.id = next_id_++;
  frontier.bounds = {};
  frontier.cells.assign(1, seed);
  index_[slot(seed)] = index;
  for (std::size_t next = 0; next < frontier.cells.size(); ++next) {
    const CellIndex cell = frontier.cells[next];
    frontier.bounds = bounding(frontier.bounds, {cell, {cell.x + 1, cell.y + 1}});
    for (std::int32_t y = cell.y - 1; y <= cell.y + 1; ++y) {
      for (std::int32_t x = cell.x - 1; x <= cell.x + 1; ++x) {
        if (!contains({x, y}) || index_[slot({x, y})] != kLoose) continue;
        index_[slot({x, y})] = index;
        frontier.cells.push_back({x, y});
      }
    }
  }
  frontier.centroid = mean(geometry_, frontier.cells);
}

// Fills the gaps that are left with the last frontiers.
void FrontierMap::close_gaps() {
  for (; !gaps_.empty(); gaps_.erase(gaps_.begin())) {  // from the highest on
    const std::uint32_t gap = gaps_.front();
    if (gap + 1 < frontiers_.size()) {
      std::swap(frontiers_[gap], frontiers_.back());
      for (const CellIndex cell : frontiers_[gap].cells) index_[slot(cell)] = gap;
    }
    frontiers_.pop_back();
  }
}

}  // namespace scrubjay
