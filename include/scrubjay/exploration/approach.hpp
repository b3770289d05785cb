/// \file
/// How near a robot can come to a piece of floor that it may not fit on.
#pragma once

#include <cstdint>
#include <optional>
#include <scrubjay/grid/log_odds.hpp>
#include <scrubjay/planning/path_search.hpp>
#include <vector>

namespace scrubjay {

/// Follows the free floor, not the straight line: what is behind a wall is not near. Keeps its memory.
class Approach {
 public:
  /// Of the cells that the last spread of `ways` got to, the one from which free cells lead to `target`, over edges,
  /// in the fewest steps. None if no such floor connects them. Of equal ones, always the same. Cells with something
  /// occupied within `disc` [m] of their centres are no floor.
  std::optional<CellIndex> nearest_reached(GridView<const LogOdds> map, const PathSearch& ways, CellIndex target,
                                           double disc = 0.0);

 private:
  std::vector<std::uint32_t> round_of_;  // by cell: the last search that came by
  std::uint32_t round_ = 0;
  std::vector<CellIndex> found_;
};

}  // namespace scrubjay
