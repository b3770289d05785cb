#include "drive_train.hpp"

#include <algorithm>
#include <cmath>

namespace scrubjay::sim {

DriveTrain::DriveTrain(const RobotSpec& spec, const NoiseProfile& noise, const SystematicErrors& errors,
                       const Random& random)
    : true_drive_(spec.model.drive),
      acceleration_(spec.acceleration),
      braking_(spec.braking),
      max_speed_(spec.model.max_wheel_speed),
      noise_(noise),
      left_scale_(errors.left_scale),
      right_scale_(errors.right_scale),
      random_(random) {
  true_drive_.wheel_separation *= errors.separation_scale;
}

// Motors turn at few speeds, and not at all at the lowest ones.
double DriveTrain::attainable(double wanted) const {
  const double speed = std::clamp(wanted, -max_speed_, max_speed_);
  if (std::fabs(speed) < noise_.speed_deadband) return 0.0;
  if (noise_.speed_step <= 0.0) return speed;
  const double above = std::fabs(speed) - noise_.speed_deadband;
  const double steps = std::floor(above / noise_.speed_step + 0.5);
  return std::copysign(noise_.speed_deadband + steps * noise_.speed_step, speed);
}

double DriveTrain::approach(double speed, double wanted, double dt) const {
  const bool faster = wanted * speed >= 0.0 && std::fabs(wanted) > std::fabs(speed);
  const double limit = (faster ? acceleration_ : braking_) * dt;
  return speed + std::clamp(wanted - speed, -limit, limit);
}

Roll DriveTrain::tick(const WheelSpeeds& wanted, double slip, const std::array<bool, 2>& stuck, double dt) {
  speeds_.left = stuck[0] ? 0.0 : approach(speeds_.left, attainable(wanted.left), dt);
  speeds_.right = stuck[1] ? 0.0 : approach(speeds_.right, attainable(wanted.right), dt);
  Roll roll;
  roll.left = speeds_.left * dt;
  roll.right = speeds_.right * dt;
  if (roll.left == 0.0 && roll.right == 0.0) return roll;

  WheelTravel travel{roll.left * left_scale_ * (1.0 - slip), roll.right * right_scale_ * (1.0 - slip)};
  if (noise_.travel_noise > 0.0) {
    travel.left += noise_.travel_noise * std::sqrt(std::fabs(roll.left)) * random_.normal();
    travel.right += noise_.travel_noise * std::sqrt(std::fabs(roll.right)) * random_.normal();
  }
  roll.arc = arc_of(travel, true_drive_);
  if (noise_.turn_noise > 0.0) {
    roll.arc.turn += noise_.turn_noise * std::sqrt(std::fabs(roll.arc.turn)) * random_.normal();
  }
  return roll;
}

}  // namespace scrubjay::sim
