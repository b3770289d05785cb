/// \file
/// What the figures of an examination mean: what isn't healthy, and what to try.
#pragma once

#include <scrubjay/finding.hpp>
#include <scrubjay/io/examination.hpp>
#include <scrubjay/io/hand_check.hpp>
#include <vector>

namespace scrubjay {

/// Where healthy ends. Own choices, where no source is named.
struct HealthLimits {
  double missing_frames = 0.02;  ///< share of all frames; clocks differ by less
  double frame_gap = 0.1;        ///< OiRobot takes a robot for silent after it [s]
  double reply_p95 = 0.025;      ///< a tick, and what an adapter should take at most [s]
  double answered = 0.98;        ///< share of all questions
  double low_charge = 0.15;      ///< share of the capacity, below which a Roomba looks for its dock
  double low_voltage = 12.5;     ///< of the pack of 12 cells, nearly empty [V]
  double hot = 50.0;             ///< [deg C]
  double worn_capacity = 1.0;    ///< a new pack has 2.7 to 3 Ah (OI specification) [Ah]
  std::int32_t dark_cliff = 50;  ///< signal of a window that sees no floor, although the flag says that it does
};

/// All that isn't as it should be, the worst first. `hands`: what the user's hands found out, if they were asked.
std::vector<Finding> diagnose(const DoctorReport& report, const HandCheck* hands = nullptr,
                              const HealthLimits& limits = {});

}  // namespace scrubjay
