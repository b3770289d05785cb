/// \file
/// Ctrl-C, SIGTERM and a terminal that goes away as a stop token.
#pragma once

#include <array>
#include <csignal>
#include <cstdint>
#include <mutex>
#include <stop_token>
#include <thread>

namespace scrubjay::apps {

/// While it lives, SIGINT, SIGTERM and SIGHUP request a stop instead of ending the process; a second one ends it at
/// once, but for SIGHUP, which a closing window may send twice. To be made before any other thread, which then leaves
/// the signals to this one.
///
/// A robot on a wire would drive on without the process. While one may move, a second signal waits until it stands,
/// SIGQUIT requests a stop as the others do, and what would suspend the process (SIGTSTP, which is Ctrl-Z, SIGTTIN and
/// SIGTTOU) or end it over a lost reader (SIGPIPE) is ignored. SIGKILL and SIGSTOP nobody can hold off.
class Interrupt {
 public:
  /// What goes on when the process doesn't.
  enum class Stake : std::uint8_t { Nothing, RobotOnAWire };

  explicit Interrupt(Stake stake = Stake::Nothing);
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;
  ~Interrupt();
  std::stop_token token() const { return stop_.get_token(); }

  /// The robot on the wire was told to stop, and moves no more: ends the process here if it was asked for twice
  /// meanwhile; from now on, a second signal ends it at once.
  void robot_stands();

 private:
  static constexpr std::array kHeldOff{SIGTSTP, SIGTTIN, SIGTTOU, SIGPIPE};

  void wait(const std::stop_token& end);
  void ask_again(int signal);

  std::stop_source stop_;
  sigset_t awaited_{};
  std::array<struct sigaction, kHeldOff.size()> before_{};  // what they did
  std::mutex mutex_;                                        // guards what follows
  bool robot_moves_;
  int second_ = 0;  // the signal that asked again while the robot moved
  std::jthread waiter_;
};

}  // namespace scrubjay::apps
