/// \file
/// Frontiers in pieces that a robot can set out for.
#pragma once

#include <scrubjay/exploration/frontier_map.hpp>
#include <vector>

namespace scrubjay {

/// A stretch of a frontier. A frontier may run around a whole hall: its middle says nothing of where it is.
struct FrontierPiece {
  std::vector<CellIndex> cells;
  CellIndex middle;  ///< the one of its cells that is nearest to their mean

  /// About how long it is [m].
  double length(double resolution) const { return static_cast<double>(cells.size()) * resolution; }
};

/// Cuts a frontier into pieces whose cells lie within `reach` [cells] of a first one.
std::vector<FrontierPiece> cut(const Frontier& frontier, std::int32_t reach);

/// True if the unknown cells behind the piece, connected over edges, are `enough` at least: fewer are an obstacle's
/// inside, or a reading's noise.
bool borders_on_unknown(GridView<const LogOdds> map, const FrontierPiece& piece, std::size_t enough);

}  // namespace scrubjay
