/// \file
/// Wide floor, flooded until it meets in doors.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "clearance.hpp"

namespace scrubjay {

/// Number of a basin, from 1 on; 0 for what is no floor.
using BasinLabel = std::uint32_t;

/// The basins of a grid whose outermost cells have no clearance, row-major: connected, and together all that has any.
/// They are numbered by the order of their first cells.
///
/// Floor is flooded from where it is widest to where it is narrowest (L. Vincent and P. Soille, *Watersheds in Digital
/// Spaces*, IEEE PAMI 13(6), 1991, upside down). Where two basins meet, at their widest saddle, they become one unless
/// both have cells with as much clearance as `least_peaks` asks of a saddle with this clearance. Saddles for which it
/// has nothing part no basins.
std::vector<BasinLabel> flood_basins(GridView<const SquaredClearance> clearance,
                                     std::span<const SquaredClearance> least_peaks);

}  // namespace scrubjay
