/// \file
/// The settings of a terminal's line.
#pragma once

#include <memory>

namespace scrubjay {

/// Puts a terminal's line into raw mode, 8N1, without flow control or modem control, and its old settings back at the
/// end. All of it by Linux's own calls, since termios knows no rates but the standard ones.
class SerialLine {
 public:
  /// `file` must stay open for longer.
  explicit SerialLine(int file);
  SerialLine(const SerialLine&) = delete;
  SerialLine& operator=(const SerialLine&) = delete;
  ~SerialLine();

  /// Sets raw mode at this rate, once all that was written is out; the rate that the driver took [baud], 0 if none.
  int set_raw(int baud);
  /// Asks the driver not to gather bytes; false if it refuses or knows no such thing.
  bool set_low_latency();

 private:
  struct Settings;
  int file_;
  std::unique_ptr<Settings> before_;
};

}  // namespace scrubjay
