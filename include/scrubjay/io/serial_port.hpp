/// \file
/// A serial port as a byte channel.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <scrubjay/robot/byte_channel.hpp>
#include <span>
#include <string>
#include <vector>

namespace scrubjay {

/// Which port, and how fast.
struct SerialAddress {
  std::filesystem::path path;
  int baud = 115200;  ///< bits per second. Create 2 and Roomba 600: 115200; older ones: 57600
};

/// The rates at which to look for a robot, the address's first: 115200 baud (Create 2 and Roomba 600), 57600 (older
/// ones) and 19200 (any of them whose CLEAN button was held down while it started).
std::vector<int> rates_to_try(const SerialAddress& address);

/// The serial ports on USB, sorted by name: `ttyUSB*` and `ttyACM*` in `devices`.
std::vector<std::filesystem::path> serial_ports(const std::filesystem::path& devices = "/dev");
/// What tells a port's adapter from others, as `serial/by-id` names it (`usb-FTDI_TTL232R_FTE5QX-if00-port0`); empty if
/// it has no name there.
std::string adapter_name(const std::filesystem::path& port, const std::filesystem::path& devices = "/dev");

/// A port in raw mode, 8N1, without flow control, for this process alone, with as little latency as the driver allows.
///
/// Works on a pseudo-terminal, too. What was set is put back when it is closed, once all that was written is on the
/// wire. One thread may write while another one reads.
class SerialPort final : public ByteChannel {
 public:
  /// For bytes, at most: a tick of 15 ms and its jitter, or every other frame would cost a call more.
  static constexpr std::chrono::milliseconds kWait{20};
  static constexpr std::chrono::milliseconds kWriteLimit{100};  ///< for a write to get through, in all
  static constexpr std::chrono::milliseconds kPulse{100};       ///< of the BRC pin

  /// What came before it was opened is dropped. Throws Error: no such port (and which ones there are), no permission
  /// (and which group to join), no terminal, in use, no such rate.
  explicit SerialPort(const SerialAddress& address);
  SerialPort(const SerialPort&) = delete;
  SerialPort& operator=(const SerialPort&) = delete;
  ~SerialPort() override;

  /// All that is there in one system call, after another one that waited for it: kWait at most, and shorter if a signal
  /// came. The stamp is now() when they were read. Not open any more once the device is gone, or the other end of a
  /// pseudo-terminal.
  ByteRead read(std::span<std::uint8_t> buffer) override;
  /// False if the device is gone, or didn't take all of `bytes` within kWriteLimit; a part may have gone out then.
  bool write(std::span<const std::uint8_t> bytes) override;

  /// Drops what came and wasn't read.
  void discard();
  /// Changes the rate once all that was written is on the wire. Linux lets drivers choose any rate, so that only the
  /// driver limits it. Throws Error, and keeps the rate, if what it would give is off by more than 3 %; throws Error
  /// (Kind::Failure) if the device is gone.
  void set_baud(int baud);

  /// Pulls the robot's BRC pin (device detect on the oldest) low for so long by RTS and DTR, which wakes it; false, at
  /// once, if the port has no such lines. Takes kPulse longer than that, and leaves the pin high.
  ///
  /// An asserted line is low on cables of logic level; on one that inverts, the pin is low for kPulse before. Three
  /// pulses of 50 ms to 500 ms set a Create 2 to 19200 baud (OI specification, "Serial Port Settings"): leave it at one
  /// when it was just switched on. A Roomba 400 may want 500 ms (SCI specification, "Device Detect").
  bool pulse_wake(std::chrono::milliseconds low = kPulse);

  /// False where the driver refused; reads may come late by 16 ms then (FTDI).
  bool low_latency() const { return low_latency_; }
  /// To wait on with poll().
  int descriptor() const;
  /// Seconds since the port was opened, by the monotonic clock.
  double now() const;

 private:
  class Device;
  std::unique_ptr<Device> device_;
  bool low_latency_ = false;
  int baud_ = 0;  ///< the last one that worked
  std::string name_;
  std::chrono::steady_clock::time_point opened_ = std::chrono::steady_clock::now();
};

}  // namespace scrubjay
