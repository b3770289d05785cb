/// \file
/// Which robot is on a port, if any.
#pragma once

#include <optional>
#include <scrubjay/io/serial_port.hpp>
#include <scrubjay/oi/model.hpp>
#include <scrubjay/robot/oi_robot.hpp>
#include <stop_token>

namespace scrubjay {

struct FoundRobot {
  oi::Model protocol = oi::Model::Create2;
  int baud = 115200;
  bool woken = false;              ///< by its BRC pin
  bool mode_one_too_high = false;  ///< it says so of Passive; known only where Start took it there
  bool streamed_before = false;    ///< all packets, unasked
};

/// Looks for a robot at the address's rate first, and for the expected dialect first; wakes one that sleeps; then tries
/// 115200, 57600 and 19200 baud.
///
/// For a session that drives, the robot is left in Passive mode, its stream paused. For one that listens, it is left
/// with a stream of all packets (but for a Roomba 400), and in the mode that it has: where that stream runs already,
/// nothing is sent at all; else it is only asked for sensors, which it answers in any mode but Off (OI specification,
/// "Sensors", "Stream"). Only where nobody answers that, at no rate, is it taken for Off or asleep, woken and sent
/// Start.
///
/// Throws Error (Kind::Failure) within `timeout` [s] if there is none: what answers instead, and what to try.
FoundRobot find_robot(SerialPort& port, const SerialAddress& address, std::optional<oi::Model> expected, double timeout,
                      OiRobot::Session session, const std::stop_token& stop);

/// "Create 2", "Create 1", "Roomba 400".
const char* name_of(oi::Model protocol);

}  // namespace scrubjay
