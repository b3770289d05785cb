/// \file
/// Geometry of a differential drive, and the arc that it drives.
#pragma once

#include <scrubjay/geometry/pose2.hpp>

namespace scrubjay {

/// Geometry that odometry needs. Defaults: Roomba 600 / Create 2 (OI specification, "Odometry").
struct DifferentialDrive {
  double wheel_separation = 0.235;  ///< between the wheels' contact points [m]
  double wheel_radius = 0.036;      ///< [m]
  double counts_per_turn = 508.8;   ///< encoder counts per wheel turn

  double metres_per_count() const { return 2.0 * kPi * wheel_radius / counts_per_turn; }
};

/// What the wheels rolled, as what the base did.
struct WheelTravel {
  double left = 0.0;   ///< [m]
  double right = 0.0;  ///< [m]
};

/// Motion of a differential drive whose wheels rolled by `travel`, as an arc of constant curvature.
///
/// Exact for constant wheel speeds; continuous through straight motion (no division by a small angle).
/// Siegwart, Nourbakhsh, Scaramuzza, *Introduction to Autonomous Mobile Robots*, 2nd ed., sec. 5.2.4.
Pose2 arc_motion(const WheelTravel& travel, const DifferentialDrive& drive);

}  // namespace scrubjay
