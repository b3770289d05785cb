#include "serial_line.hpp"

#include <asm/termbits.h>
#include <linux/serial.h>
#include <sys/ioctl.h>

#include <optional>

namespace scrubjay {

struct SerialLine::Settings {
  std::optional<termios2> line;
  std::optional<serial_struct> driver;  ///< once low latency was set
};

SerialLine::SerialLine(int file) : file_(file), before_(std::make_unique<Settings>()) {
  termios2 line{};
  if (::ioctl(file_, TCGETS2, &line) == 0) before_->line = line;
}

SerialLine::~SerialLine() {
  if (before_->line) ::ioctl(file_, TCSETSW2, &*before_->line);
  if (before_->driver) ::ioctl(file_, TIOCSSERIAL, &*before_->driver);
}

int SerialLine::set_raw(int baud) {
  termios2 line = before_->line.value_or(termios2{});
  line.c_iflag = IGNBRK;  // a pulled plug sends no zeros
  line.c_oflag = 0;
  line.c_lflag = 0;
  line.c_cflag = CS8 | CREAD | CLOCAL | BOTHER;  // BOTHER: the rate is given as a number
  line.c_ispeed = line.c_ospeed = static_cast<speed_t>(baud);
  line.c_cc[VMIN] = 1;  // poll() tells of the first byte
  line.c_cc[VTIME] = 0;
  if (::ioctl(file_, TCSETSW2, &line) != 0 || ::ioctl(file_, TCGETS2, &line) != 0) return 0;
  return static_cast<int>(line.c_ospeed);
}

bool SerialLine::set_low_latency() {
  serial_struct driver{};
  if (::ioctl(file_, TIOCGSERIAL, &driver) != 0) return false;
  const serial_struct before = driver;
  driver.flags = static_cast<int>(static_cast<unsigned>(driver.flags) | ASYNC_LOW_LATENCY);
  if (driver.flags == before.flags) return true;
  if (::ioctl(file_, TIOCSSERIAL, &driver) != 0) return false;
  before_->driver = before;
  return true;
}

}  // namespace scrubjay
