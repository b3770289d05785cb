#include "watchdog.hpp"

namespace scrubjay {
namespace {

constexpr int kRepeats = 8;  // an order may get lost on the way
constexpr std::chrono::milliseconds kRepeatInterval{40};

}  // namespace

Watchdog::Watchdog(double renewal, std::function<void()> halt)
    : renewal_(std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(renewal))),
      halt_(std::move(halt)),
      thread_([this](const std::stop_token& end) { watch(end); }) {}

void Watchdog::watch(const std::stop_token& end) {
  std::unique_lock lock(mutex_);
  while (!end.stop_requested()) {
    if (!deadline_) {
      changed_.wait(lock, end, [this] { return deadline_.has_value(); });
      continue;
    }
    const Clock::time_point awaited = *deadline_;
    changed_.wait_until(lock, end, awaited, [this] { return !deadline_; });
    if (!deadline_ || Clock::now() < *deadline_ || end.stop_requested()) continue;
    if (!stopped_) {
      stopped_ = true;
      ++stops_;
      repeats_ = 0;
    }
    halt_();
    deadline_.reset();
    if (++repeats_ < kRepeats) deadline_ = Clock::now() + kRepeatInterval;
  }
}

void Watchdog::rest() {
  const std::scoped_lock lock(mutex_);
  deadline_.reset();
  changed_.notify_one();
}

std::uint64_t Watchdog::stops() const {
  const std::scoped_lock lock(mutex_);
  return stops_;
}

}  // namespace scrubjay
