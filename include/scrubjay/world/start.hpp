/// \file
/// Whether a robot can stand where it is to start.
#pragma once

#include <scrubjay/world/segment_index.hpp>
#include <scrubjay/world/world.hpp>
#include <vector>

namespace scrubjay {

/// Throws Error if the disc of `radius` [m] touches something at `start`, stands within furniture, over a cliff or
/// outside the box around all that is solid.
void expect_room(const World& world, const SegmentIndex& index, const Pose2& start, double radius);

/// Places for `count` >= 1 robots of `radius` [m]: `first`, and others near it to which one can drive from there, their
/// middles at least three radii apart. All face the same way. Throws Error if there is no room for so many.
std::vector<Pose2> starting_poses(const World& world, const SegmentIndex& index, const Pose2& first, double radius,
                                  std::size_t count);

}  // namespace scrubjay
