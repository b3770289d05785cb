/// \file
/// What a robot's own wheels and axle are, where its model only says what they should be.
#pragma once

#include <scrubjay/odometry/differential_drive.hpp>

namespace scrubjay {

/// Three factors that make odometry right: those that Borenstein and Feng name unequal wheel diameters and uncertain
/// wheelbase, and the wheels' common scale. *Measurement and Correction of Systematic Odometry Errors in Mobile
/// Robots*, IEEE Transactions on Robotics and Automation 12(6), 1996, where E_d is right / left and E_b is axle.
struct Calibration {
  double left = 1.0;   ///< way that the left wheel makes, per way that its encoder tells
  double right = 1.0;  ///< the same of the right wheel
  double axle = 1.0;   ///< distance between the wheels, per distance that the model tells

  bool operator==(const Calibration&) const = default;
};

/// What the wheels of a robot that is just as its model would have rolled, had it moved as this one did: what `told` is
/// by the encoders. Whoever goes by the model's DifferentialDrive then gets the right arc.
inline WheelTravel calibrated(const WheelTravel& told, const Calibration& calibration) {
  const double left = calibration.left * told.left;
  const double right = calibration.right * told.right;
  const double middle = 0.5 * (left + right);
  const double half = 0.5 * (right - left) / calibration.axle;
  return {middle - half, middle + half};
}

/// The inverse: what the encoders tell of a motion that the model's wheels would have made by rolling `travel`. The
/// factors are not 0.
inline WheelTravel uncalibrated(const WheelTravel& travel, const Calibration& calibration) {
  const double middle = 0.5 * (travel.left + travel.right);
  const double half = 0.5 * (travel.right - travel.left) * calibration.axle;
  return {(middle - half) / calibration.left, (middle + half) / calibration.right};
}

}  // namespace scrubjay
