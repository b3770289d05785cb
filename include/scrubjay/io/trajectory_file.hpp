/// \file
/// Trajectories as text, a pose a line: `stamp x y z qx qy qz qw`, the format of the TUM RGB-D benchmark.
#pragma once

#include <filesystem>
#include <scrubjay/geometry/stamped_pose.hpp>
#include <span>
#include <string>
#include <vector>

namespace scrubjay {

/// Nanoseconds, micrometres, and quaternions to nine decimals; z, qx and qy are 0.
std::string trajectory_text(std::span<const StampedPose> trajectory);
/// The same to a file. Throws Error (Kind::Failure).
void write_trajectory(const std::filesystem::path& path, std::span<const StampedPose> trajectory);

/// Reads what write_trajectory and others write: eight numbers a line, empty lines and those that start with # left
/// out. Position and yaw are kept, height and tilt dropped. Throws Error with file and line.
std::vector<StampedPose> read_trajectory(const std::filesystem::path& path);

}  // namespace scrubjay
