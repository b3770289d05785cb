/// \file
/// Where the robots and the noise profiles that come with scrubjay are.
#pragma once

#include <filesystem>
#include <scrubjay/simulation/noise.hpp>
#include <scrubjay/simulation/robot_spec.hpp>
#include <string>

namespace scrubjay::apps {

/// $SCRUBJAY_DATA_DIR, or the installed share/scrubjay, or the source tree that the program was built from.
/// Throws Error if none of them is there.
std::filesystem::path data_folder();

/// The URDF of a robot by its name, or by its path. Throws Error that lists the known names for one that isn't.
std::filesystem::path robot_file(const std::string& model);

/// A robot by its name, or by the path of a URDF file. Throws Error that lists the known names for one that isn't.
sim::RobotSpec find_robot(const std::string& model);

/// The same where only one that speaks the Open Interface will do: one on a serial port. Throws Error.
sim::RobotSpec find_oi_robot(const std::string& model);

sim::NoiseProfile find_noise(const std::string& profile);

}  // namespace scrubjay::apps
