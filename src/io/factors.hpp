/// \file
/// A calibration's factors in YAML.
#pragma once

#include <scrubjay/odometry/calibration.hpp>

#include "yaml_field.hpp"

namespace scrubjay {

/// The fields left, right and axle, of which a calibration has all: factors between 0.5 and 2. Throws Error.
Calibration read_factors(const YamlField& field);

}  // namespace scrubjay
