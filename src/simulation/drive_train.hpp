/// \file
/// Motors, wheels and the floor: from wanted wheel speeds to the way that was made.
#pragma once

#include <array>
#include <scrubjay/geometry/random.hpp>
#include <scrubjay/odometry/arc.hpp>
#include <scrubjay/simulation/body_senses.hpp>
#include <scrubjay/simulation/noise.hpp>
#include <scrubjay/simulation/robot_spec.hpp>

namespace scrubjay::sim {

/// What the wheels did in one tick, before anything was in their way.
struct Roll {
  double left = 0.0;   ///< by the encoders' account [m]
  double right = 0.0;  ///< [m]
  Arc arc;             ///< what that made of the robot, if nothing blocks it
};

class DriveTrain {
 public:
  DriveTrain(const RobotSpec& spec, const NoiseProfile& noise, const SystematicErrors& errors, const Random& random);

  /// Advances by `dt` [s]. `slip` is the share of the way that the floor takes; a wheel that is `stuck` (left, right)
  /// stands.
  Roll tick(const WheelSpeeds& wanted, double slip, const std::array<bool, 2>& stuck, double dt);
  const WheelSpeeds& speeds() const { return speeds_; }

 private:
  double attainable(double wanted) const;
  double approach(double speed, double wanted, double dt) const;

  DifferentialDrive true_drive_;
  double acceleration_;
  double braking_;
  double max_speed_;
  NoiseProfile noise_;
  double left_scale_;
  double right_scale_;
  Random random_;
  WheelSpeeds speeds_;
};

}  // namespace scrubjay::sim
