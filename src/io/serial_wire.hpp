/// \file
/// A serial port that may go away and come back, written to by more than one thread.
#pragma once

#include <chrono>
#include <memory>
#include <mutex>
#include <scrubjay/io/recording.hpp>
#include <scrubjay/io/serial_port.hpp>
#include <span>

namespace scrubjay {

/// Stamps go on over a port that was opened anew. One thread reads and reopens; any may write.
class SerialWire final : public ByteChannel {
 public:
  /// Opens the port. Throws Error as SerialPort does.
  explicit SerialWire(const SerialAddress& address);

  ByteRead read(std::span<std::uint8_t> buffer) override;
  bool write(std::span<const std::uint8_t> bytes) override;
  /// Closes the port if it is open, and opens it again; false if that can't be done now.
  bool reopen();

  /// Wakes the robot as SerialPort does, in the reading thread; false if there is no port now, or it has no such lines.
  bool pulse_wake() { return port_ && port_->pulse_wake(); }

  /// The port, which must be there: for the time in which nobody else uses the wire.
  SerialPort& port() { return *port_; }
  /// The rate at which it is opened again.
  void set_baud(int baud) { address_.baud = baud; }
  /// Records all bytes from now on.
  void record(std::unique_ptr<RecordingWriter> writer);
  /// Throws Error as RecordingWriter::close() does.
  void close_recording();
  /// Time by the clock of the stamps [s].
  double now() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }

 private:
  using Clock = std::chrono::steady_clock;

  SerialAddress address_;
  Clock::time_point begin_ = Clock::now();
  std::mutex mutex_;  // guards what follows, but that the reading thread may look at the port
  std::unique_ptr<SerialPort> port_;
  double opened_ = 0.0;  // by our clock when the port's was 0 [s]
  std::unique_ptr<RecordingWriter> writer_;
  double last_stamp_ = 0.0;  // of what was read last [s]
};

}  // namespace scrubjay
