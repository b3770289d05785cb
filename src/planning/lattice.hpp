/// \file
/// The lattice that paths are searched on: cells, eight directions, and what steps cost, in whole numbers.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <scrubjay/planning/cost_map.hpp>

namespace scrubjay::lattice {

// Straight and diagonal steps, times the two cells' (32 + cost): a step over open floor is 12 * 64.
constexpr std::uint32_t kStraight = 12;
constexpr std::uint32_t kDiagonal = 17;
constexpr std::uint32_t kTwoCells = static_cast<std::uint32_t>(2.0 * kCostUnit);
constexpr double kLabelsPerCell = kStraight * kTwoCells;
// Of one search: a way is at most 1.4 million cells of open floor long. Some are kept for the way out to its start.
constexpr std::uint32_t kMaxLabels = 1U << 30;
constexpr std::uint32_t kLongestWay = kMaxLabels - (1U << 24);
constexpr std::uint32_t kMaxStep = kDiagonal * (kTwoCells + 2 * kNoWay);

// A place: 14 bits of column, 14 of row, 4 of the direction in which the cell was entered.
constexpr std::uint32_t kRow = 1U << 14;
constexpr std::int32_t kMaxSide = kRow;
constexpr std::uint32_t kCoordinate = kRow - 1;
constexpr std::uint32_t kCell = (1U << 28) - 1;
constexpr std::uint32_t kNowhere = 0xFFFFFFFF;

constexpr std::uint32_t place_of(CellIndex cell) {
  return static_cast<std::uint32_t>(cell.x) + kRow * static_cast<std::uint32_t>(cell.y);
}
constexpr std::uint32_t column(std::uint32_t place) {
  return place & kCoordinate;
}
constexpr std::uint32_t row(std::uint32_t place) {
  return place >> 14 & kCoordinate;
}
constexpr std::uint32_t heading(std::uint32_t place, std::uint32_t direction) {
  return (place & kCell) | direction % 8 << 28;
}
/// The neighbour in that direction, entered so.
constexpr std::uint32_t enter(std::uint32_t place, std::uint32_t direction) {
  // Counter-clockwise from the east.
  constexpr std::uint32_t kMove[8] = {1, kRow + 1, kRow, kRow - 1, 0U - 1, 0U - kRow - 1, 0U - kRow, 1U - kRow};
  return heading(place + kMove[direction], direction);
}

constexpr std::uint32_t kFromNowhere = 8;

struct Direction {
  std::int32_t x, y;
};
// Counter-clockwise; the odd ones are diagonal.
constexpr Direction kDirections[8] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};

constexpr std::uint32_t step_length(std::uint32_t direction) {
  return direction % 2 == 0 ? kStraight : kDiagonal;
}
inline CellIndex neighbour(CellIndex cell, int direction) {
  return {cell.x + kDirections[direction].x, cell.y + kDirections[direction].y};
}

inline TravelCost cost_of(GridView<const TravelCost> costs, CellIndex cell) {
  return costs.contains(cell) ? costs[cell] : kNoWay;
}

/// A step of the disc; 0 if it can't be made.
inline std::uint32_t step_cost(GridView<const TravelCost> costs, CellIndex from, int direction) {
  const CellIndex to = neighbour(from, direction);
  const TravelCost a = cost_of(costs, from);
  const TravelCost b = cost_of(costs, to);
  if (a == kNoWay || b == kNoWay) return 0;
  if (direction % 2 != 0 && (cost_of(costs, {from.x, to.y}) == kNoWay || cost_of(costs, {to.x, from.y}) == kNoWay)) {
    return 0;
  }
  return step_length(static_cast<std::uint32_t>(direction)) * (kTwoCells + a + b);
}

/// True in columns 1 ... width - 3 and rows 1 ... height - 2: all neighbours are there, and a byte to spare.
inline bool is_inside(std::uint32_t place, const GridGeometry& grid) {
  return column(place) - 1 < static_cast<std::uint32_t>(std::max(0, grid.width - 3)) &&
         row(place) - 1 < static_cast<std::uint32_t>(std::max(0, grid.height - 2));
}

/// A step on the way out of where the disc can't be.
constexpr std::uint32_t way_out_cost(int direction) {
  return step_length(static_cast<std::uint32_t>(direction)) * (kTwoCells + 2 * kNoWay);
}

/// What is left of the way, at least: it leads over open floor. Labels with that added go to buckets of 2^kBucketBits;
/// cells that are to be kAhead buckets later may be done at once.
struct OctileDistance {
  static constexpr int kBucketBits = 8;
  static constexpr std::uint32_t kAhead = 16;  // this and the bits: measured, FindAcross
  CellIndex to;

  std::uint32_t operator()(std::uint32_t x, std::uint32_t y) const {
    const auto dx = static_cast<std::uint32_t>(std::abs(static_cast<std::int32_t>(x) - to.x));
    const auto dy = static_cast<std::uint32_t>(std::abs(static_cast<std::int32_t>(y) - to.y));
    return kTwoCells * (kStraight * std::max(dx, dy) + (kDiagonal - kStraight) * std::min(dx, dy));
  }
};

struct NoEstimate {
  // No wider than the cheapest step: what the first bucket holds is final, in any order (Dinic, 1978).
  static constexpr int kBucketBits = 9;
  static constexpr std::uint32_t kAhead = 32;
  std::uint32_t operator()(std::uint32_t, std::uint32_t) const { return 0; }
};

}  // namespace scrubjay::lattice
