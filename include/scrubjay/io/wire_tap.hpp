/// \file
/// Between a robot and its client.
#pragma once

#include <cstdint>
#include <scrubjay/io/pseudo_terminal.hpp>
#include <scrubjay/io/recording.hpp>
#include <scrubjay/io/serial_port.hpp>
#include <stop_token>

namespace scrubjay {

/// What passed a tap.
struct TapReport {
  double time = 0.0;             ///< [s]
  std::uint64_t from_robot = 0;  ///< [bytes]
  std::uint64_t to_robot = 0;    ///< [bytes]
  std::uint64_t unread = 0;      ///< of those from the robot, what the client never read [bytes]
  bool robot_gone = false;       ///< the port went away
};

/// Passes bytes on both ways between the robot on `port` and whatever client opens `terminal`, and records them, until
/// somebody asks to stop, `max_time` [s] is over or the port goes away. A client that doesn't read holds nothing up. A
/// robot that a client has spoken to is told to stand at the end, and left in a mode that charges.
TapReport tap_wire(SerialPort& port, PseudoTerminal& terminal, RecordingWriter& recording, double max_time,
                   const std::stop_token& stop);

}  // namespace scrubjay
