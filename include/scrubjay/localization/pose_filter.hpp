/// \file
/// A pose by odometry and by what is seen, and what odometry errs by.
#pragma once

#include <Eigen/Core>
#include <scrubjay/geometry/pose2.hpp>

namespace scrubjay {

/// What odometry errs by all the time: wheels that are smaller than the model says, or not of one size, or that stand
/// closer together. The base really went `1 + way` times as far and turned `1 + turn` times as much as odometry tells,
/// and turned by `bend` on top for each metre.
struct OdometryBias {
  double way = 0.0;   ///< [m/m]
  double turn = 0.0;  ///< [rad/rad]
  double bend = 0.0;  ///< [rad/m], to the left when driving forward
};

/// How far odometry may be off, in standard deviations. Our own choices, tried where ScanMatchingParams were; wheels on
/// a hard floor err by less, but now and then they slip, and an edge of a map is never as straight as its wall.
struct MotionNoise {
  // Random: the variance grows with the way or the turn.
  double way_per_way = 0.02;           ///< of the position [m/sqrt(m)]
  double way_per_turn = 0.001;         ///< of the position [m/sqrt(rad)]
  double turn_per_way = radians(1.5);  ///< of the heading [rad/sqrt(m)]
  double turn_per_turn = 0.03;         ///< of the heading [rad/sqrt(rad)]
  // Constant, or nearly so: floors differ, tyres wear.
  OdometryBias bias{.way = 0.03, .turn = 0.05, .bend = radians(4.0)};         ///< at the start
  OdometryBias bias_walk{.way = 0.001, .turn = 0.002, .bend = radians(0.1)};  ///< by which it changes, per sqrt(m)
};

/// Kalman filter of a pose together with odometry's bias. Wherever something tells the pose, it also tells what
/// odometry erred by since the last time: so odometry is good by the time when nothing else can be seen. Larsen, Bak,
/// Andersen, Ravn, *Location Estimation for an Autonomously Guided Vehicle using an Augmented Kalman Filter to
/// Autocalibrate the Odometry*, FUSION 1998; Martinelli, Tomatis, Siegwart, *Simultaneous Localization and Odometry
/// Self Calibration for Mobile Robot*, Autonomous Robots 22, 2007.
class PoseFilter {
 public:
  /// Begins at the origin, for certain.
  explicit PoseFilter(const MotionNoise& noise = {});

  /// Odometry tells of a step, in the robot's frame. Steps are short: an arc is as good as its chord.
  void predict(const Pose2& step);
  /// The pose turned out to be `pose`, which takes this filter's own guess into account already (the mean of the
  /// posterior), by a reading of the given information on (x, y, yaw).
  void correct(const Pose2& pose, const Eigen::Matrix3d& information);
  /// Something told that the heading is off by `by` [rad], with an inverse variance of `information` > 0 [1/rad^2].
  void correct_heading(double by, double information);
  /// The wheels slipped by what no bias explains: (x, y, yaw) are off by these standard deviations more.
  void slip(const Eigen::Vector3d& by);

  const Pose2& pose() const { return pose_; }
  /// Of (x, y, yaw).
  Eigen::Matrix3d covariance() const { return covariance_.topLeftCorner<3, 3>(); }
  /// Its inverse; finite where the pose is known for certain, too.
  Eigen::Matrix3d information() const;
  const OdometryBias& bias() const { return bias_; }

 private:
  using Matrix6d = Eigen::Matrix<double, 6, 6>;

  MotionNoise noise_;
  Pose2 pose_;
  OdometryBias bias_;
  Matrix6d covariance_ = Matrix6d::Zero();  // of x, y, yaw, way, turn, bend
};

}  // namespace scrubjay
