#include <Eigen/LU>
#include <cmath>
#include <scrubjay/localization/pose_filter.hpp>

namespace scrubjay {
namespace {

constexpr double kLeastVariance = 1e-9;  // the first pose is known for certain, but nothing divides by that

double squared(double x) {
  return x * x;
}

Eigen::Vector3d squares(const OdometryBias& bias) {
  return {squared(bias.way), squared(bias.turn), squared(bias.bend)};
}

/// What is symmetric but for rounding, to the last bit.
Eigen::Matrix3d symmetric(const Eigen::Matrix3d& m) {
  return 0.5 * (m + m.transpose());
}

/// Way along the robot's own axis: backwards is negative.
double way_of(const Pose2& step) {
  const double length = std::sqrt(step.position().squaredNorm());
  return step.x < 0.0 ? -length : length;
}

}  // namespace

PoseFilter::PoseFilter(const MotionNoise& noise) : noise_(noise) {
  covariance_.diagonal().tail<3>() = squares(noise.bias);
}

void PoseFilter::predict(const Pose2& step) {
  if (step == Pose2{}) return;  // what stands still is not to creep by rounding errors
  const double way = way_of(step);
  const double more_turn = bias_.turn * step.yaw + bias_.bend * way;
  const SinCos aside = sin_cos(0.5 * more_turn);
  const Point2 moved =
      (1.0 + bias_.way) * Point2(aside.cos * step.x - aside.sin * step.y, aside.sin * step.x + aside.cos * step.y);
  const Pose2 next = pose_ * Pose2{moved.x(), moved.y(), step.yaw + more_turn};
  const Point2 by = next.position() - pose_.position();
  pose_ = next;

  Matrix6d slope = Matrix6d::Identity();
  slope(0, 2) = -by.y();
  slope(1, 2) = by.x();
  slope.block<2, 1>(0, 3) = by;
  slope(2, 4) = step.yaw;
  slope(2, 5) = way;
  const Matrix6d carried = slope * covariance_ * slope.transpose();
  covariance_ = 0.5 * (carried + carried.transpose());
  const double length = std::fabs(way);
  const double turn = std::fabs(step.yaw);
  const double way_variance = squared(noise_.way_per_way) * length + squared(noise_.way_per_turn) * turn;
  const double turn_variance = squared(noise_.turn_per_way) * length + squared(noise_.turn_per_turn) * turn;
  covariance_.diagonal().head<3>() += Eigen::Vector3d(way_variance, way_variance, turn_variance);
  covariance_.diagonal().tail<3>() += length * squares(noise_.bias_walk);
}

void PoseFilter::correct(const Pose2& pose, const Eigen::Matrix3d& information) {
  const Eigen::Matrix3d before = covariance();
  const Eigen::Matrix3d known = this->information();
  const Eigen::Matrix3d after = symmetric((known + information).inverse());
  const Eigen::Vector3d off(pose.x - pose_.x, pose.y - pose_.y, angle_difference(pose.yaw, pose_.yaw));
  // What is known of the bias, given the pose (conditional Gaussians).
  const Eigen::Matrix3d gain = covariance_.bottomLeftCorner<3, 3>() * known;
  const Eigen::Vector3d more = gain * off;
  bias_ = {bias_.way + more.x(), bias_.turn + more.y(), bias_.bend + more.z()};
  const Eigen::Matrix3d less = gain * (before - after) * gain.transpose();
  covariance_.bottomRightCorner<3, 3>() -= symmetric(less);
  covariance_.bottomLeftCorner<3, 3>() = gain * after;
  covariance_.topRightCorner<3, 3>() = covariance_.bottomLeftCorner<3, 3>().transpose();
  covariance_.topLeftCorner<3, 3>() = after;
  pose_ = pose;
}

void PoseFilter::correct_heading(double by, double information) {
  const Eigen::Vector3d of_heading = covariance().col(2);
  const Eigen::Vector3d move = by / (of_heading.z() + 1.0 / information) * of_heading;
  Eigen::Matrix3d reading = Eigen::Matrix3d::Zero();
  reading(2, 2) = information;
  correct({pose_.x + move.x(), pose_.y + move.y(), wrap_angle(pose_.yaw + move.z())}, reading);
}

Eigen::Matrix3d PoseFilter::information() const {
  Eigen::Matrix3d known = covariance();
  known.diagonal().array() += kLeastVariance;
  return symmetric(known.inverse());
}

void PoseFilter::slip(const Eigen::Vector3d& by) {
  covariance_.diagonal().head<3>() += by.cwiseAbs2();
}

}  // namespace scrubjay
