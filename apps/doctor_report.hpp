/// \file
/// What the doctor found, for people and for programs.
#pragma once

#include <scrubjay/io/diagnosis.hpp>
#include <scrubjay/io/serial_driver.hpp>
#include <scrubjay/io/serial_port.hpp>
#include <string>
#include <vector>

namespace scrubjay::apps {

/// What is known of the port.
struct PortReport {
  SerialAddress address;  ///< with the rate at which the robot answered
  SerialDriver driver;
  bool low_latency = false;
};

/// Lines of 79 columns at most: port, robot, figures, sensors, findings. `hands`: none if nobody was asked.
std::string report_text(const PortReport& port, const DoctorReport& report, const HandCheck* hands,
                        const std::vector<Finding>& findings);
/// The same as one JSON object.
std::string report_json(const PortReport& port, const DoctorReport& report, const HandCheck* hands,
                        const std::vector<Finding>& findings);

}  // namespace scrubjay::apps
