/// \file
/// Wheel encoders that wrap around.
#pragma once

#include <cstdint>
#include <optional>

namespace scrubjay {

/// Counts a 16-bit rolling encoder (OI packets 43 and 44) without losing its way at the wrap, in either direction.
class Encoder {
 public:
  /// Counts since the reading before; 0 for the first one, and for one that a wheel can't have made: more than
  /// `max_step` counts either way, as when the robot's power was cycled and its counter started anew.
  int advance(std::uint16_t reading, int max_step) {
    const int step = last_ ? static_cast<std::int16_t>(static_cast<std::uint16_t>(reading - *last_)) : 0;
    last_ = reading;
    return step <= max_step && step >= -max_step ? step : 0;
  }

 private:
  std::optional<std::uint16_t> last_;
};

}  // namespace scrubjay
