/// \file
/// A robot at the other end of a pseudo-terminal, in real time, that can be told to misbehave.
#pragma once

#include <asm/termbits.h>
#include <sys/ioctl.h>

#include <scrubjay/io/pseudo_terminal.hpp>
#include <scrubjay/oi/opcode.hpp>
#include <scrubjay/simulation/firmware.hpp>
#include <scrubjay/simulation/roomba_body.hpp>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace scrubjay {

/// Firmware over wheels that turn as they are told at once, ticking by the clock.
class FakeRobot {
 public:
  struct Traits {
    oi::Model protocol = oi::Model::Create2;
    std::optional<unsigned> rate = {};  ///< what a client must set to be understood; none: any
    std::string chatter = {};           ///< sent all the time instead of anything else
    sim::FirmwareOptions firmware = {};
  };

  explicit FakeRobot(std::filesystem::path link) : FakeRobot(std::move(link), Traits()) {}
  FakeRobot(std::filesystem::path link, const Traits& traits)
      : link_(std::move(link)),
        traits_(traits),
        terminal_(std::make_unique<PseudoTerminal>(link_)),
        thread_([this](const std::stop_token& end) { live(end); }) {
    start_anew();
  }

  /// Neither hears nor speaks, and goes on as it was told.
  void fall_silent() { silent_ = true; }
  void speak_again() { silent_ = false; }
  /// Speaks, but hears nothing.
  void turn_deaf(bool deaf) { deaf_ = deaf; }
  /// Hears a Power command, which nobody meant.
  void hear_power() {
    const std::scoped_lock lock(mutex_);
    firmware_->receive(encode(oi::Power{}));
  }
  /// Hears what another client says.
  void hear(const oi::Command& command) {
    const std::scoped_lock lock(mutex_);
    firmware_->receive(encode(command));
  }
  void pulse_brc() {
    const std::scoped_lock lock(mutex_);
    firmware_->pulse_brc();
  }
  /// The device is unplugged, and plugged in again.
  void go_away() {
    const std::scoped_lock lock(mutex_);
    terminal_.reset();
  }
  void come_back() {
    const std::scoped_lock lock(mutex_);
    terminal_ = std::make_unique<PseudoTerminal>(link_);
  }
  /// As a robot whose battery was taken out: Off, without a stream, its counters at the beginning.
  void start_anew() {
    const std::scoped_lock lock(mutex_);
    sim::RobotSpec spec;
    spec.model.protocol = traits_.protocol;
    firmware_.emplace(spec, traits_.firmware);
    senses_ = {};
  }

  bool stands() const {
    const std::scoped_lock lock(mutex_);
    return firmware_->wanted().left == 0.0 && firmware_->wanted().right == 0.0;
  }
  oi::OiMode mode() const {
    const std::scoped_lock lock(mutex_);
    return firmware_->mode();
  }
  /// Rolled by the left wheel since it was started [m].
  double rolled() const {
    const std::scoped_lock lock(mutex_);
    return senses_.left_rolled;
  }
  /// Bytes that came by the wire.
  std::uint64_t heard() const {
    const std::scoped_lock lock(mutex_);
    return heard_;
  }
  std::uint64_t frames_sent() const {
    const std::scoped_lock lock(mutex_);
    return frames_sent_;
  }

 private:
  using Clock = std::chrono::steady_clock;

  void live(const std::stop_token& end) {
    auto due = Clock::now();
    while (!end.stop_requested()) {
      due += std::chrono::milliseconds(15);
      std::this_thread::sleep_until(due);
      const std::scoped_lock lock(mutex_);
      if (firmware_) tick();
    }
  }

  void tick() {
    std::array<std::uint8_t, 4096> heard;
    const std::size_t count = terminal_ ? terminal_->read(heard).count : 0;
    heard_ += count;
    const bool understood = !silent_ && right_rate();
    if (understood && !deaf_ && traits_.chatter.empty()) firmware_->receive(std::span(heard).first(count));
    const sim::WheelSpeeds wanted = firmware_->wanted();
    senses_.left_rolled += wanted.left * sim::kTick;
    senses_.right_rolled += wanted.right * sim::kTick;
    std::vector<std::uint8_t> said;
    firmware_->tick(senses_, said);
    if (!traits_.chatter.empty()) said.assign(traits_.chatter.begin(), traits_.chatter.end());
    if (!understood || !terminal_ || said.empty()) return;
    ++frames_sent_;
    terminal_->write(said);
  }

  bool right_rate() const {
    if (!traits_.rate || !terminal_) return true;
    termios2 settings{};
    return ::ioctl(terminal_->descriptor(), TCGETS2, &settings) == 0 && settings.c_ospeed == *traits_.rate;
  }

  std::filesystem::path link_;
  Traits traits_;
  std::atomic<bool> silent_ = false;
  std::atomic<bool> deaf_ = false;
  mutable std::mutex mutex_;
  std::unique_ptr<PseudoTerminal> terminal_;
  std::optional<sim::Firmware> firmware_;
  sim::BodySenses senses_;
  std::uint64_t heard_ = 0;
  std::uint64_t frames_sent_ = 0;
  std::jthread thread_;
};

/// Whether `condition` comes true within ten seconds, which a loaded machine may take.
template <typename Condition>
bool soon(Condition condition) {
  for (int i = 0; i < 1000; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

}  // namespace scrubjay
