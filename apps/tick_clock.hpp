/// \file
/// Ticks of a simulation at the pace of the wall clock.
#pragma once

#include <chrono>
#include <cstdint>
#include <stop_token>

namespace scrubjay::apps {

/// Every tick has its time, counted from the first one: what comes late now and then adds up to nothing. Whoever is
/// more than kPatience behind goes on from there.
class TickClock {
 public:
  static constexpr std::chrono::seconds kPatience{1};

  /// `tick`: of the simulation [s]; `speed`: times real time, > 0.
  TickClock(double tick, double speed);

  /// Waits until the next tick is due; returns earlier, false, when a stop is asked for.
  bool wait(const std::stop_token& stop);
  /// What the last wait() gave up to catch up with; 0 if it didn't [s].
  double gave_up() const { return gave_up_; }

 private:
  using Clock = std::chrono::steady_clock;

  Clock::time_point due() const;

  double seconds_per_tick_;
  Clock::time_point begin_ = Clock::now();
  std::uint64_t ticks_ = 0;
  double gave_up_ = 0.0;
};

}  // namespace scrubjay::apps
