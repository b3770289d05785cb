/// \file
/// Dead reckoning: wheel travel to pose and twist, with covariances.
#pragma once

#include <scrubjay/geometry/pose_estimate.hpp>
#include <scrubjay/odometry/differential_drive.hpp>

namespace scrubjay {

/// How a wheel errs: the variance of its travel grows with the distance rolled, independently for each wheel.
/// Siegwart, Nourbakhsh, Scaramuzza, *Introduction to Autonomous Mobile Robots*, 2nd ed., eq. 5.8.
struct WheelNoise {
  double left_variance_per_metre = 1.7e-6;   ///< k_l [m^2/m]; 0.13 % per square root of a metre: hard floor, Create 2
  double right_variance_per_metre = 1.7e-6;  ///< k_r [m^2/m]
};

/// Integrates wheel travel as exact arcs, in double precision.
///
/// The covariance is propagated to first order (Siegwart et al., eqs. 5.7 to 5.11, at the arc's middle heading), so it
/// grows with the way driven and never by the tick: standing still adds nothing.
class Odometry {
 public:
  explicit Odometry(const DifferentialDrive& drive, const WheelNoise& noise = {}, const Pose2& start = {});

  /// What the wheels rolled since the update before, and when [s]. The twist is a mean over at least kTwistInterval, so
  /// that ticks which arrive late or in bursts don't make it jump.
  const PoseEstimate& update(const WheelTravel& travel, double stamp);
  /// The same from a robot that tells its motion instead of its wheels' travel: it is at `pose` now, exactly, and
  /// the covariance grows as if the wheels had rolled an arc of that length and turn.
  const PoseEstimate& follow(const Pose2& pose, double stamp);
  const PoseEstimate& estimate() const { return estimate_; }

  static constexpr double kTwistInterval = 0.025;  ///< [s]; two ticks of the Open Interface make it

 private:
  void propagate(const WheelTravel& travel, double middle_sin, double middle_cos);
  void update_twist(const WheelTravel& travel, double stamp);

  DifferentialDrive drive_;
  WheelNoise noise_;
  PoseEstimate estimate_;
  WheelTravel since_twist_;  // travel since the twist was last computed
  double twist_stamp_ = 0.0;
  bool started_ = false;
};

}  // namespace scrubjay
