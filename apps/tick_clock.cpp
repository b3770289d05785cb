#include "tick_clock.hpp"

#include <algorithm>
#include <thread>

namespace scrubjay::apps {

TickClock::TickClock(double tick, double speed) : seconds_per_tick_(tick / speed) {}

TickClock::Clock::time_point TickClock::due() const {
  const std::chrono::duration<double> since(seconds_per_tick_ * static_cast<double>(ticks_));
  return begin_ + std::chrono::duration_cast<Clock::duration>(since);
}

bool TickClock::wait(const std::stop_token& stop) {
  constexpr std::chrono::milliseconds kStopSeenWithin{50};
  ++ticks_;
  gave_up_ = 0.0;
  const Clock::time_point until = due();
  Clock::time_point now = Clock::now();
  if (now - until > kPatience) {
    gave_up_ = std::chrono::duration<double>(now - until).count();
    begin_ += now - until;
  }
  for (; now < until && !stop.stop_requested(); now = Clock::now()) {
    std::this_thread::sleep_until(std::min(until, now + kStopSeenWithin));
  }
  return !stop.stop_requested();
}

}  // namespace scrubjay::apps
