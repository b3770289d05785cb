/// \file
/// The wake line that pseudo-terminals haven't got.
#pragma once

#include <functional>
#include <mutex>

namespace scrubjay {

/// While one lives, every serial port of this process has RTS and DTR: this program's ioctl() takes them instead of the
/// kernel's, which knows of none at a pseudo-terminal. One at a time.
class ModemLines {
 public:
  /// `pulled` is called, in the thread that writes the lines, when they pull a robot's BRC pin low.
  explicit ModemLines(std::function<void()> pulled);
  ModemLines(const ModemLines&) = delete;
  ModemLines& operator=(const ModemLines&) = delete;
  ~ModemLines();

  /// Times that the pin was pulled low.
  int pulses() const;

  /// Asserts RTS and DTR, or takes them back: what a port's ioctl does.
  void set(bool asserted);

 private:
  std::function<void()> pulled_;
  mutable std::mutex mutex_;
  bool asserted_ = true;  // as Linux opens a port
  int pulses_ = 0;
};

}  // namespace scrubjay
