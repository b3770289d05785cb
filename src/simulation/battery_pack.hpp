/// \file
/// What a robot's battery gives and takes.
#pragma once

#include <algorithm>
#include <cmath>
#include <scrubjay/simulation/body_senses.hpp>
#include <scrubjay/simulation/robot_spec.hpp>

namespace scrubjay::sim {

inline double voltage_of(const BatterySpec& pack, double share) {
  return pack.empty_voltage + (pack.full_voltage - pack.empty_voltage) * share;
}

/// At rest, and full to that share.
inline Battery charged_battery(const BatterySpec& pack, double share) {
  return {voltage_of(pack, share), 0.0, share * pack.capacity, pack.capacity, 25.0, false};
}

/// `dt` [s] of standing or driving at these wheel speeds; it charges while it stands `docked`.
inline void use_battery(const RobotSpec& spec, const WheelSpeeds& speeds, bool docked, double dt, Battery& battery) {
  const BatterySpec& pack = spec.battery;
  const double effort = (std::fabs(speeds.left) + std::fabs(speeds.right)) / spec.model.max_wheel_speed;
  battery.charging = docked && effort == 0.0 && battery.charge < battery.capacity;
  battery.current = battery.charging ? pack.charge_current : -(pack.idle_current + pack.drive_current * effort);
  const double hours = dt / 3600.0;
  battery.charge = std::clamp(battery.charge + battery.current * hours, 0.0, battery.capacity);
  battery.voltage = voltage_of(pack, battery.charge / battery.capacity);
}

}  // namespace scrubjay::sim
