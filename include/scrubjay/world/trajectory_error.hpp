/// \file
/// How far an estimated trajectory is from the true one.
#pragma once

#include <cmath>
#include <scrubjay/geometry/stamped_pose.hpp>
#include <span>

namespace scrubjay {

/// Both trajectories in one frame, without any alignment but that. Sturm et al., *A Benchmark for the Evaluation of
/// RGB-D SLAM Systems*, 2012, sec. VII.
struct TrajectoryError {
  double ate = 0.0;             ///< root mean square of the distance [m]
  double final_distance = 0.0;  ///< at the last pose [m]
  double final_heading = 0.0;   ///< at the last pose, 0 to pi [rad]
};

/// Pose by pose: both are as long as each other, taken at the same times.
inline TrajectoryError trajectory_error(std::span<const StampedPose> estimate, std::span<const StampedPose> truth) {
  TrajectoryError error;
  if (estimate.empty() || estimate.size() != truth.size()) return error;
  double sum = 0.0;
  for (std::size_t i = 0; i < estimate.size(); ++i) {
    sum += (estimate[i].pose.position() - truth[i].pose.position()).squaredNorm();
  }
  error.ate = std::sqrt(sum / static_cast<double>(estimate.size()));
  error.final_distance = (estimate.back().pose.position() - truth.back().pose.position()).norm();
  error.final_heading = std::fabs(angle_difference(estimate.back().pose.yaw, truth.back().pose.yaw));
  return error;
}

}  // namespace scrubjay
