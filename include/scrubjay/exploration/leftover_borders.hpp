/// \file
/// Where known floor ends in unknown floor that a disc won't sweep, and why.
#pragma once

#include <scrubjay/behavior/behavior.hpp>
#include <scrubjay/exploration/sweep_gain.hpp>
#include <scrubjay/planning/cost_map.hpp>
#include <scrubjay/planning/path_search.hpp>
#include <vector>

namespace scrubjay {

/// Unknown cells beside free ones, connected and left for one reason, if there are `least` [m] of them in a row: "out
/// of bounds", "given up", "too narrow for the robot", "no way there". What lies within `ways`, a spread from the robot
/// over all that it can reach, isn't listed: that could be swept, and isn't worth the way.
std::vector<Leftover> borders_left(const SweepGain& gain, GridView<const TravelCost> costs, const PathSearch& ways,
                                   double least);

}  // namespace scrubjay
