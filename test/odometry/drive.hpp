/// \file
/// The robot whose wheels the tests of this room turn.
#pragma once

#include <scrubjay/odometry/arc.hpp>

namespace scrubjay {

inline const DifferentialDrive kDrive;

}  // namespace scrubjay
