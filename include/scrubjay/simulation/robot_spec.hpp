/// \file
/// All that the simulation must know of a robot: what the core knows, and the rest of its body.
#pragma once

#include <array>
#include <scrubjay/robot/robot_model.hpp>
#include <string>

namespace scrubjay::sim {

/// The wall sensor on the right side (create_autonomy).
struct WallSensorSpec {
  Pose2 mount{0.09, -0.12, radians(-57.0)};
  double min_range = 0.016;  ///< [m]
  double max_range = 0.040;  ///< [m]
  double max_signal = 1023.0;
};

/// The receivers of infrared characters, and what the dock sends (create3_sim).
struct InfraredSpec {
  Point2 receiver{0.153, 0.0};
  double buoy_bearing =
      radians(10.0);  ///< of the beams' middles, from the dock's axis: green left of it, red right [rad]
  double buoy_half_angle = radians(15.0);  ///< [rad]
  double buoy_range = 1.0;                 ///< [m]
  double force_field = 0.61;               ///< around the dock [m]
};

/// Our own figures: a 3 Ah pack that lasts about two hours.
struct BatterySpec {
  double capacity = 2.696;       ///< [Ah]
  double full_voltage = 16.8;    ///< [V]
  double empty_voltage = 13.2;   ///< [V]
  double idle_current = 0.25;    ///< [A]
  double drive_current = 0.5;    ///< per wheel at full speed [A]
  double charge_current = 1.25;  ///< in the dock [A]
};

/// Defaults: Roomba 600 / Create 2, as urdf/roomba_600.urdf and .yaml have them.
struct RobotSpec {
  std::string name = "roomba-600";
  RobotModel model;
  double mass = 3.6;                  ///< [kg]
  double acceleration = 0.4;          ///< of a wheel [m/s^2] (Gazebo plugin of create_autonomy)
  double braking = 0.3;               ///< of a wheel [m/s^2] (the same)
  double wheel_drop_offset = 0.1175;  ///< of the wheels from the middle [m]
  WallSensorSpec wall;
  InfraredSpec infrared;
  BatterySpec battery;
};

}  // namespace scrubjay::sim
