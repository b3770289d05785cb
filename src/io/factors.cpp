#include "factors.hpp"

namespace scrubjay {

Calibration read_factors(const YamlField& field) {
  const NumberRange range{0.5, 2.0, false, "a factor from 0.5 to 2"};
  return {field.at("left").number(range), field.at("right").number(range), field.at("axle").number(range)};
}

}  // namespace scrubjay
