/// \file
/// How far floor is from what isn't.
#pragma once

#include <cstdint>
#include <scrubjay/grid/grid_view.hpp>
#include <vector>

namespace scrubjay {

/// Squared distance [cells^2]; 0 for what is no floor.
using SquaredClearance = std::uint16_t;

/// Distances are cut here [cells], so that two squared ones add up to less than a SquaredClearance holds.
inline constexpr std::int32_t kMaxClearance = 180;

/// From each floor cell (one that isn't 0) to the nearest cell that is none, centre to centre, cut at `reach` cells
/// (at most kMaxClearance). What lies outside of the grid counts as far.
///
/// Exact, in two passes: along columns, then along rows (Felzenszwalb and Huttenlocher, *Distance Transforms of Sampled
/// Functions*, 2012). The second one tries all of the reach instead of their lower envelope, which compilers make
/// vectors of.
std::vector<SquaredClearance> squared_clearance(GridView<const std::uint8_t> floor, std::int32_t reach);

}  // namespace scrubjay
