/// \file
/// One line on the terminal that tells how a run gets on.
#pragma once

#include <chrono>
#include <scrubjay/mission/observer.hpp>
#include <scrubjay/world/score.hpp>

namespace scrubjay::apps {

/// Whether there is a terminal to show progress on.
bool progress_wanted(bool quiet);

/// Simulated time, speed, cells known, coverage and what the robot does, on stderr, a few times a second. It watches
/// the clock, not the run: nothing of it gets into results.
class Progress final : public Observer {
 public:
  /// `truth` must outlive it; nothing if nobody knows it, and the share that is covered.
  explicit Progress(const GroundTruth* truth) : truth_(truth) {}
  ~Progress() override;

  void notify(const Snapshot& now) override;

 private:
  using Clock = std::chrono::steady_clock;

  void show(const Snapshot& now, Clock::time_point clock);

  const GroundTruth* truth_;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point shown_ = begin_;
  int ticks_ = 0;
  bool any_ = false;
};

}  // namespace scrubjay::apps
