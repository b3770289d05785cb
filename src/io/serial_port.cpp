#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <scrubjay/error.hpp>
#include <scrubjay/io/serial_port.hpp>
#include <thread>

#include "serial_line.hpp"
#include "serial_trouble.hpp"

namespace scrubjay {
namespace {

using Clock = std::chrono::steady_clock;

/// Opened, and nobody else's.
int open_device(const std::filesystem::path& path) {
  // Without O_NONBLOCK it would wait for a carrier.
  const int file = ::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (file < 0) throw serial_open_error(path, errno);
  if (::isatty(file) == 0) {
    const int reason = errno;  // EIO: a port without hardware behind it
    ::close(file);
    throw serial_open_error(path, reason);
  }
  // The lock holds off programs of any user; exclusive mode those that know of no locks, but not root's.
  if (::flock(file, LOCK_EX | LOCK_NB) != 0) {
    ::close(file);
    throw serial_in_use_error(path);
  }
  ::ioctl(file, TIOCEXCL);
  return file;
}

/// Waits until `file` can do what `events` says; false if it can't within the time, or a signal came.
bool wait_for(int file, short events, std::chrono::milliseconds limit) {
  pollfd waiting{.fd = file, .events = events, .revents = 0};
  return ::poll(&waiting, 1, static_cast<int>(limit.count())) > 0;
}

}  // namespace

std::vector<int> rates_to_try(const SerialAddress& address) {
  std::vector<int> rates{address.baud};
  for (const int rate : {115200, 57600, 19200}) {
    if (rate != address.baud) rates.push_back(rate);
  }
  return rates;
}

/// What is open: closed in the order that leaves it as it was found.
class SerialPort::Device {
 public:
  explicit Device(const std::filesystem::path& path)
      : file_(open_device(path)), line_(std::make_unique<SerialLine>(file_)) {}
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;
  ~Device() {
    line_.reset();
    ::ioctl(file_, TIOCNXCL);
    ::close(file_);
  }

  int file() const { return file_; }
  SerialLine& line() { return *line_; }

 private:
  int file_;
  std::unique_ptr<SerialLine> line_;
};

SerialPort::SerialPort(const SerialAddress& address)
    : device_(std::make_unique<Device>(address.path)), name_(address.path.string()) {
  set_baud(address.baud);
  low_latency_ = device_->line().set_low_latency();
  discard();
}

SerialPort::~SerialPort() = default;

ByteRead SerialPort::read(std::span<std::uint8_t> buffer) {
  const int file = device_->file();
  if (!wait_for(file, POLLIN, kWait)) return {.count = 0, .stamp = now(), .open = true};
  const ssize_t count = ::read(file, buffer.data(), buffer.size());
  const int reason = errno;
  const double stamp = now();
  if (count > 0) return {.count = static_cast<std::size_t>(count), .stamp = stamp, .open = true};
  // There was something to read, and yet there is nothing: the line was hung up.
  const bool open = count < 0 && (reason == EAGAIN || reason == EINTR);
  return {.count = 0, .stamp = stamp, .open = open};
}

bool SerialPort::write(std::span<const std::uint8_t> bytes) {
  const Clock::time_point limit = Clock::now() + kWriteLimit;
  while (!bytes.empty()) {
    const ssize_t written = ::write(device_->file(), bytes.data(), bytes.size());
    if (written > 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(written));
      continue;
    }
    if (written < 0 && errno != EAGAIN && errno != EINTR) return false;
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(limit - Clock::now());
    if (left.count() <= 0) return false;
    wait_for(device_->file(), POLLOUT, left);
  }
  return true;
}

void SerialPort::discard() {
  ::tcflush(device_->file(), TCIFLUSH);
}

void SerialPort::set_baud(int baud) {
  if (baud <= 0) throw Error(fmt::format("{}: {} baud is no rate; want 115200, say", name_, baud));
  const int given = device_->line().set_raw(baud);
  if (std::abs(given - baud) <= 0.03 * baud) {
    baud_ = baud;
    return;
  }
  if (given == 0) throw Error(fmt::format("{}: the port is gone; plug it in again", name_), Error::Kind::Failure);
  if (baud_ > 0) device_->line().set_raw(baud_);
  throw Error(fmt::format("{}: the port can't do {} baud (it would do {}); want 115200, 57600 or 19200, say", name_,
                          baud, given));
}

bool SerialPort::pulse_wake(std::chrono::milliseconds low) {
  const int lines = TIOCM_RTS | TIOCM_DTR;
  const int file = device_->file();
  if (::ioctl(file, TIOCMBIC, &lines) != 0) return false;
  std::this_thread::sleep_for(kPulse);
  if (::ioctl(file, TIOCMBIS, &lines) != 0) return false;
  std::this_thread::sleep_for(low);
  return ::ioctl(file, TIOCMBIC, &lines) == 0;
}

int SerialPort::descriptor() const {
  return device_->file();
}

double SerialPort::now() const {
  return std::chrono::duration<double>(Clock::now() - opened_).count();
}

}  // namespace scrubjay
