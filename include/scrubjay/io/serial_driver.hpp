/// \file
/// What the kernel knows of a serial port's adapter.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace scrubjay {

struct SerialDriver {
  std::string name;               ///< of its driver, as "ftdi_sio"; empty if there is none to tell
  std::optional<int> latency_ms;  ///< how long the adapter gathers bytes before it hands them on [ms]; FTDI tells
};

/// Looks it up in `sys`, where Linux tells of devices. Nothing there is no error.
SerialDriver serial_driver(const std::filesystem::path& port, const std::filesystem::path& sys = "/sys");

}  // namespace scrubjay
