/// \file
/// How a simulated robot errs: the figures, and what is drawn from them once a run.
#pragma once

#include <array>
#include <cstdint>
#include <scrubjay/geometry/random.hpp>
#include <scrubjay/robot/frame.hpp>
#include <string>
#include <vector>

namespace scrubjay::sim {

/// Values are drawn evenly between these two.
struct Range {
  double low = 0.0;
  double high = 0.0;
};

/// A profile of urdf/noise.yaml, which gives the sources. All zeros: a perfect robot on a perfect floor.
struct NoiseProfile {
  std::string name = "none";
  // Drawn once a run.
  Range wheel_mismatch;         ///< share by which the wheels' diameters differ, either way
  Range separation_error;       ///< share by which the wheels stand wider or narrower than the model says, either way
  double distance_error = 0.0;  ///< share by which both wheels are off, at most, either way
  Range grip{1.0, 1.0};         ///< true distance per distance rolled, by the floor
  Range albedo{1.0, 1.0};       ///< of each thing that light falls on, 1 being average
  double mount_error = 0.0;     ///< by which a light sensor looks aside, at most [rad]
  // Drawn all the time.
  double travel_noise = 0.0;       ///< standard deviation of a wheel's way per square root of way [m/sqrt(m)]
  double turn_noise = 0.0;         ///< standard deviation of a turn per square root of turn [rad/sqrt(rad)]
  double bump_kick = 0.0;          ///< standard deviation of the turn that a bump gives [rad]
  double light_noise = 0.0;        ///< standard deviation of a light signal, as a share of it
  double light_floor_noise = 0.0;  ///< ... and in counts
  double lidar_noise = 0.0;        ///< standard deviation of a lidar's range, whatever it is [m] ...
  double lidar_noise_share = 0.0;  ///< ... and what it grows by, as a share of the range; within LidarModel's accuracy
  // How the floor and the wheels behave.
  double carpet_slip = 0.0;     ///< share of the world's carpets' own slip that takes effect
  double push_slip = 0.0;       ///< share of the wheels' turning that goes on while something blocks the robot
  double wall_friction = 10.0;  ///< of the shell against walls; high: it catches, low: it slides along
  double speed_step = 0.0;      ///< wheel speeds of a robot with an Open Interface come in steps of this [m/s]
  double speed_deadband = 0.0;  ///< ... and those below this are none [m/s]
};

/// The errors that one robot has in one run.
struct SystematicErrors {
  double left_scale = 1.0;  ///< true way per way rolled by the encoder's account
  double right_scale = 1.0;
  double separation_scale = 1.0;                  ///< true distance between the wheels per distance in the model
  std::array<double, kLightSensorCount> mount{};  ///< [rad]
  std::vector<double> albedo;                     ///< by piece of the world
};

/// Draws from the profile. The same for the same generator.
SystematicErrors draw_errors(const NoiseProfile& profile, std::size_t pieces, const Random& random);

}  // namespace scrubjay::sim
