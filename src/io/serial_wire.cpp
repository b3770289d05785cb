#include "serial_wire.hpp"

#include <scrubjay/error.hpp>

namespace scrubjay {

SerialWire::SerialWire(const SerialAddress& address)
    : address_(address), port_(std::make_unique<SerialPort>(address)), opened_(now() - port_->now()) {}

ByteRead SerialWire::read(std::span<std::uint8_t> buffer) {
  if (!port_) return {.count = 0, .stamp = now(), .open = false};
  ByteRead got = port_->read(buffer);
  const std::scoped_lock lock(mutex_);
  // As RecordingChannel does: whoever replays a recording gets these very stamps.
  got.stamp = stamp_from_nanoseconds(stamp_to_nanoseconds(opened_ + got.stamp));
  last_stamp_ = got.stamp;
  if (writer_) writer_->record(Direction::Received, got.stamp, buffer.first(got.count));
  if (!got.open) port_.reset();
  return got;
}

bool SerialWire::write(std::span<const std::uint8_t> bytes) {
  const std::scoped_lock lock(mutex_);
  if (!port_) return false;
  if (writer_) writer_->record(Direction::Sent, last_stamp_, bytes);
  return port_->write(bytes);
}

bool SerialWire::reopen() {
  const std::scoped_lock lock(mutex_);
  port_.reset();  // it is for one alone
  try {
    port_ = std::make_unique<SerialPort>(address_);
  } catch (const Error&) {
    return false;  // not there yet
  }
  opened_ = now() - port_->now();
  return true;
}

void SerialWire::record(std::unique_ptr<RecordingWriter> writer) {
  const std::scoped_lock lock(mutex_);
  writer_ = std::move(writer);
}

void SerialWire::close_recording() {
  const std::scoped_lock lock(mutex_);
  const std::unique_ptr<RecordingWriter> writer = std::move(writer_);
  if (writer) writer->close();
}

}  // namespace scrubjay
