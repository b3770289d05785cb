/// \file
/// Which robot is on a port, if any.
#pragma once

#include <optional>
#include <scrubjay/io/serial_port.hpp>
#include <scrubjay/oi/model.hpp>
#include <stop_token>

namespace scrubjay {

struct FoundRobot {
  oi::Model protocol = oi::Model::Create2;
  int baud = 115200;
  bool woken = false;              ///< by its BRC pin
  bool mode_one_too_high = false;  ///< it says so of Passive, in which it is left
};

/// Looks for a robot at the address's rate first, and for the expected dialect first; wakes one that sleeps; then tries
/// 115200, 57600 and 19200 baud. The robot is left in Passive mode, its stream paused.
///
/// Throws Error (Kind::Failure) within `timeout` [s] if there is none: what answers instead, and what to try.
FoundRobot find_robot(SerialPort& port, const SerialAddress& address, std::optional<oi::Model> expected, double timeout,
                      const std::stop_token& stop);

/// "Create 2", "Create 1", "Roomba 400".
const char* name_of(oi::Model protocol);

}  // namespace scrubjay
