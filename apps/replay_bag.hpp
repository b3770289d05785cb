/// \file
/// `scrubjay replay` of a bag.
#pragma once

#include "replay_carmen.hpp"

namespace scrubjay::apps {

/// Maps from the bag, ours or anybody's, and writes and prints the results.
void replay_bag(const ReplayFlags& flags);

}  // namespace scrubjay::apps
