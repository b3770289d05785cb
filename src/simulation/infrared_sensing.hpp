/// \file
/// Infrared characters from virtual walls and the dock.
#pragma once

#include <scrubjay/simulation/body_senses.hpp>
#include <scrubjay/simulation/robot_spec.hpp>
#include <scrubjay/world/segment_index.hpp>

namespace scrubjay::sim {

/// Fills the infrared characters, `virtual_wall` and `docked`.
void sense_infrared(const World& world, const SegmentIndex& index, const InfraredSpec& spec, const Pose2& robot,
                    BodySenses& senses);

}  // namespace scrubjay::sim
