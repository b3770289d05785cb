#include "interrupt.hpp"

namespace scrubjay::apps {
namespace {

sigset_t stop_signals(Interrupt::Stake stake) {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  sigaddset(&set, SIGTERM);
  if (stake == Interrupt::Stake::RobotOnAWire) sigaddset(&set, SIGQUIT);
  // Whoever has it ignored wants the run to outlive the terminal, as nohup does.
  struct sigaction hang_up {};
  sigaction(SIGHUP, nullptr, &hang_up);
  if (hang_up.sa_handler != SIG_IGN) sigaddset(&set, SIGHUP);
  return set;
}

/// Ends the process as if nobody had awaited the signal.
void end_by(int signal) {
  std::signal(signal, SIG_DFL);
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, signal);
  pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
  std::raise(signal);
}

}  // namespace

Interrupt::Interrupt(Stake stake) : awaited_(stop_signals(stake)), robot_moves_(stake == Stake::RobotOnAWire) {
  pthread_sigmask(SIG_BLOCK, &awaited_, nullptr);
  if (robot_moves_) {
    struct sigaction ignore {};
    ignore.sa_handler = SIG_IGN;
    for (std::size_t i = 0; i < kHeldOff.size(); ++i) sigaction(kHeldOff[i], &ignore, &before_[i]);
  }
  waiter_ = std::jthread([this](const std::stop_token& end) { wait(end); });
}

void Interrupt::wait(const std::stop_token& end) {
  while (true) {
    const int signal = sigwaitinfo(&awaited_, nullptr);
    if (end.stop_requested()) return;  // woken by the destructor
    if (signal <= 0) continue;
    // A window that closes may say so twice: the shell passes on what the kernel has sent already.
    if (stop_.stop_requested() && signal != SIGHUP) ask_again(signal);
    stop_.request_stop();
  }
}

/// Asked twice: whoever asks doesn't want to wait for the files. But a robot is stopped before.
void Interrupt::ask_again(int signal) {
  const std::scoped_lock lock(mutex_);
  if (!robot_moves_) end_by(signal);
  second_ = signal;
}

void Interrupt::robot_stands() {
  const std::scoped_lock lock(mutex_);
  if (!robot_moves_) return;
  robot_moves_ = false;
  for (std::size_t i = 0; i < kHeldOff.size(); ++i) sigaction(kHeldOff[i], &before_[i], nullptr);
  if (second_ != 0) end_by(second_);
}

Interrupt::~Interrupt() {
  waiter_.request_stop();
  pthread_kill(waiter_.native_handle(), SIGTERM);
  waiter_.join();
  robot_stands();
  pthread_sigmask(SIG_UNBLOCK, &awaited_, nullptr);
}

}  // namespace scrubjay::apps
