#include <algorithm>
#include <cmath>
#include <scrubjay/robot/frame_tally.hpp>

namespace scrubjay {
namespace {

// Of a frame's lateness: what moves the phase, and what moves the period. Low enough that a USB port's latency of 16 ms
// averages out, high enough to follow a clock that is off by 5 % within a second.
constexpr double kPhaseGain = 0.05;
constexpr double kPeriodGain = 0.0005;
constexpr double kPeriodRange = 0.05;  // share by which a robot's tick may differ from the nominal one

}  // namespace

void FrameTally::arrive(double stamp) {
  if (arrived_++ == 0) {
    due_ = stamp;
    return;
  }
  const double steps = std::floor((stamp - due_) / period_ + 0.5);
  ticks_ += static_cast<std::int64_t>(steps);
  due_ += steps * period_;
  const double late = stamp - due_;
  due_ += kPhaseGain * late;
  period_ = std::clamp(period_ + kPeriodGain * late, (1.0 - kPeriodRange) * kTick, (1.0 + kPeriodRange) * kTick);
}

std::uint64_t FrameTally::lost() const {
  const std::int64_t missing = ticks_ + 1 - static_cast<std::int64_t>(arrived_);
  return arrived_ == 0 || missing < 0 ? 0 : static_cast<std::uint64_t>(missing);
}

}  // namespace scrubjay
