/// \file
/// Whether a robot can stand where it is to start.
#pragma once

#include <scrubjay/world/segment_index.hpp>
#include <scrubjay/world/world.hpp>

namespace scrubjay {

/// Throws Error if the disc of `radius` [m] touches something at `start`, stands within furniture, over a cliff or
/// outside the box around all that is solid.
void expect_room(const World& world, const SegmentIndex& index, const Pose2& start, double radius);

}  // namespace scrubjay
