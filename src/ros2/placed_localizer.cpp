#include <scrubjay/ros2/placed_localizer.hpp>

namespace scrubjay::ros {

const PoseEstimate& PlacedLocalizer::update(const Frame& frame) {
  estimate_ = reckoning_->update(frame);
  if (const auto told = commands_.initial_pose()) place_ = *told * inverse(estimate_.pose);
  const SinCos turn = sin_cos(place_.yaw);
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  rotation.topLeftCorner<2, 2>() << turn.cos, -turn.sin, turn.sin, turn.cos;
  estimate_.pose = place_ * estimate_.pose;
  estimate_.covariance = rotation * estimate_.covariance * rotation.transpose();
  return estimate_;
}

}  // namespace scrubjay::ros
