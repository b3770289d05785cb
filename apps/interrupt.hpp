/// \file
/// Ctrl-C, SIGTERM and a terminal that goes away as a stop token.
#pragma once

#include <stop_token>
#include <thread>

namespace scrubjay::apps {

/// While it lives, SIGINT, SIGTERM and SIGHUP request a stop instead of ending the process; a second one ends it at
/// once, but for SIGHUP, which a closing window may send twice. To be made before any other thread, which then leaves
/// the signals to this one.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  std::stop_token token() const { return stop_.get_token(); }

 private:
  std::stop_source stop_;
  std::jthread waiter_;
};

}  // namespace scrubjay::apps
