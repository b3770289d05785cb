#include "interrupt.hpp"

#include <csignal>

namespace scrubjay::apps {
namespace {

sigset_t stop_signals() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  sigaddset(&set, SIGTERM);
  // Whoever has it ignored wants the run to outlive the terminal, as nohup does.
  struct sigaction hang_up {};
  sigaction(SIGHUP, nullptr, &hang_up);
  if (hang_up.sa_handler != SIG_IGN) sigaddset(&set, SIGHUP);
  return set;
}

}  // namespace

Interrupt::Interrupt() {
  const sigset_t set = stop_signals();
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
  waiter_ = std::jthread([this](const std::stop_token& end) {
    const sigset_t awaited = stop_signals();
    while (true) {
      const int signal = sigwaitinfo(&awaited, nullptr);
      if (end.stop_requested()) return;  // woken by the destructor
      if (signal <= 0) continue;
      // A window that closes may say so twice: the shell passes on what the kernel has sent already.
      if (stop_.stop_requested() && signal != SIGHUP) {
        // Asked twice: whoever asks doesn't want to wait for the files.
        std::signal(signal, SIG_DFL);
        pthread_sigmask(SIG_UNBLOCK, &awaited, nullptr);
        std::raise(signal);
      }
      stop_.request_stop();
    }
  });
}

Interrupt::~Interrupt() {
  waiter_.request_stop();
  pthread_kill(waiter_.native_handle(), SIGTERM);
  waiter_.join();
  const sigset_t set = stop_signals();
  pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
}

}  // namespace scrubjay::apps
