/// \file
/// Robots from files: a URDF, and beside it a YAML of what a URDF can't say.
#pragma once

#include <filesystem>
#include <scrubjay/simulation/noise.hpp>
#include <scrubjay/simulation/robot_spec.hpp>
#include <string_view>

namespace scrubjay {

/// Reads a robot with two driven wheels and a round base.
///
/// From the URDF: `base_link`, a cylinder; `left_wheel_joint` and `right_wheel_joint` with the wheels' cylinders; and
/// where there are such links, `light_left` ... `light_right`, `cliff_left` ... `cliff_right`, `wall_sensor`,
/// `infrared_receiver` and `base_scan`, a lidar. From the YAML of the same name, if it is there: see
/// urdf/roomba_600.yaml and urdf/turtlebot3_burger.yaml. What neither says is as on a Roomba 600, and a lidar as an
/// LDS-01; the base is as fast as its wheels. Throws Error with file, line or link, and field.
sim::RobotSpec read_robot(const std::filesystem::path& urdf);

/// A profile of a YAML file of noise profiles, such as urdf/noise.yaml. Throws Error, which names the known ones for a
/// profile that isn't there.
sim::NoiseProfile read_noise(const std::filesystem::path& path, std::string_view profile);

}  // namespace scrubjay
