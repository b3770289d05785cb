/// \file
/// The floor of a map, without the small things that stand on it.
#pragma once

#include <cstdint>
#include <scrubjay/grid/cell_rect.hpp>
#include <scrubjay/grid/log_odds.hpp>
#include <vector>

namespace scrubjay {

inline bool is_free(LogOdds cell) {
  return cell <= kFreeLogOdds;
}

/// A part of a map that holds all of its free cells, and around them a ring of cells that aren't.
struct Floor {
  GridGeometry geometry{};            ///< of the part, in the map's frame
  CellIndex corner{};                 ///< where its cell (0, 0) is in the map, which it may be outside of
  std::vector<std::uint8_t> cells{};  ///< 1 for floor, else 0

  GridView<const std::uint8_t> view() const { return {geometry, cells.data()}; }
};

/// The map's free cells; none if it has none.
Floor free_floor(GridView<const LogOdds> map);

/// Makes floor of what stands free on it, of unknown cells and of what is no larger than `largest` cells either way.
/// What has less than `gap` cells of floor between it, along both axes, is one thing: walls are often seen with holes.
void clear_things(Floor& floor, std::int32_t largest, std::int32_t gap);

}  // namespace scrubjay
