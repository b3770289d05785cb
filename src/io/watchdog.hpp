/// \file
/// Stops a motion that isn't renewed.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace scrubjay {

/// A thread of its own, which sleeps while the robot stands and while its motion is renewed in time.
class Watchdog {
 public:
  /// `halt` tells the robot to stand, by a channel that several threads may write to. `renewal` [s].
  Watchdog(double renewal, std::function<void()> halt);

  /// Has `tell` tell the robot a motion, which lasts for a renewal; never while the watchdog tells it to stand. `tell`
  /// learns whether the motion before it was stopped.
  template <typename Tell>
  void renew(Tell tell) {
    const std::scoped_lock lock(mutex_);
    tell(std::exchange(stopped_, false));
    const bool slept = !deadline_;
    deadline_ = Clock::now() + renewal_;
    if (slept) changed_.notify_one();
  }
  /// The robot stands, or somebody else sees to it.
  void rest();
  /// Motions that it stopped.
  std::uint64_t stops() const;

 private:
  using Clock = std::chrono::steady_clock;

  void watch(const std::stop_token& end);

  Clock::duration renewal_;
  std::function<void()> halt_;
  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  std::optional<Clock::time_point> deadline_;  // none: nothing to watch
  bool stopped_ = false;                       // the motion, by us
  int repeats_ = 0;                            // of the order to stand
  std::uint64_t stops_ = 0;
  std::jthread thread_;  // the last member: it uses all others
};

}  // namespace scrubjay
