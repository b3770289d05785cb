/// \file
/// The one boundary to a Roomba: some bytes in, some bytes out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace scrubjay {

/// What one read brought.
struct ByteRead {
  std::size_t count = 0;  ///< bytes placed at the front of the caller's buffer
  double stamp = 0.0;     ///< when they arrived, or when waiting ended [s], by the channel's clock
  bool open = true;       ///< false: there will never be more
};

/// A serial port, a pty, a recording or the simulated firmware.
class ByteChannel {
 public:
  virtual ~ByteChannel() = default;
  /// Waits for bytes, at most about a tick of the robot (15 ms), and places what is there, at most buffer.size().
  /// A count of 0 with `open` says that none came in that time.
  virtual ByteRead read(std::span<std::uint8_t> buffer) = 0;
  /// Sends all of `bytes`; false if the link is gone.
  virtual bool write(std::span<const std::uint8_t> bytes) = 0;
};

}  // namespace scrubjay
