/// \file
/// Where a robot thinks that it is, how fast it moves, and how sure it is of both.
#pragma once

#include <Eigen/Core>
#include <scrubjay/geometry/pose2.hpp>

namespace scrubjay {

/// As nav_msgs/Odometry, in the plane.
struct PoseEstimate {
  Pose2 pose;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of (x, y, yaw) [m, m, rad]
  Twist2 twist;
  Eigen::Matrix3d twist_covariance = Eigen::Matrix3d::Zero();  ///< of (linear, lateral, angular) [m/s, m/s, rad/s]
};

}  // namespace scrubjay
