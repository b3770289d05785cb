/// \file
/// Where a robot is: what --robot says.
#pragma once

#include <filesystem>
#include <scrubjay/io/serial_port.hpp>
#include <string>
#include <variant>

namespace scrubjay::apps {

/// A simulated one.
struct InSimulation {};
/// One whose bytes were recorded.
struct InRecording {
  std::filesystem::path file;
};

using RobotAddress = std::variant<InSimulation, SerialAddress, InRecording>;

/// "sim", "serial:PATH[@BAUD]" or "log:FILE". Throws Error.
RobotAddress parse_robot_address(const std::string& text);
/// The same where only a robot on a serial port will do.
SerialAddress parse_serial_robot(const std::string& text);
/// "PATH[@BAUD]". Throws Error; `flag` stands in it.
SerialAddress parse_port(const std::string& text, const std::string& flag);

}  // namespace scrubjay::apps
