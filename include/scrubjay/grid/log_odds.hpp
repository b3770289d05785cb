/// \file
/// Occupancy as clamped log-odds in one byte a cell.
#pragma once

#include <algorithm>
#include <cstdint>
#include <scrubjay/geometry/elementary.hpp>
#include <scrubjay/grid/grid_view.hpp>

namespace scrubjay {

/// log(p / (1 - p)) of a cell's occupancy p, in steps of 1/20; 0 says nothing.
/// Thrun, Burgard, Fox, *Probabilistic Robotics*, sec. 9.2.
using LogOdds = std::int8_t;

inline constexpr double kLogOddsPerUnit = 1.0 / 20.0;
/// Beyond this no evidence is counted (p = 0.0067 and 0.9933), so that a cell can always change its mind.
inline constexpr LogOdds kMaxLogOdds = 100;
/// nav2's thresholds, 0.65 and 0.196, in our steps: occupied at this or above, free at this or below.
inline constexpr LogOdds kOccupiedLogOdds = 13;
inline constexpr LogOdds kFreeLogOdds = -29;

/// Evidence of a reading that leaves a cell occupied with probability `p` where nothing was known.
inline LogOdds log_odds(double p) {
  const double steps = log(p / (1.0 - p)) / kLogOddsPerUnit;
  const double limit = kMaxLogOdds;
  return static_cast<LogOdds>(std::clamp(steps + (steps < 0 ? -0.5 : 0.5), -limit, limit));
}

/// Bayes' rule: evidence adds.
inline void update_cell(LogOdds& cell, LogOdds evidence) {
  cell = static_cast<LogOdds>(std::clamp<int>(cell + evidence, -kMaxLogOdds, kMaxLogOdds));
}

/// nav2's trinary value of a cell.
inline Occupancy trinary(LogOdds cell) {
  if (cell >= kOccupiedLogOdds) return kOccupied;
  if (cell <= kFreeLogOdds) return kFree;
  return kUnknown;
}

}  // namespace scrubjay
