/// \file
/// What urdfdom says of a robot's body.
#pragma once

#include <filesystem>
#include <scrubjay/simulation/robot_spec.hpp>

namespace scrubjay {

/// Takes over the shape, the wheels and the sensors' places. Throws Error.
void read_urdf_body(const std::filesystem::path& urdf, sim::RobotSpec& spec);

}  // namespace scrubjay
