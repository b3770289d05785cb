/// \file
/// How a robot fares, as rqt_robot_monitor and diagnostic_aggregator show it.
#pragma once

#include <scrubjay/messages/diagnostic_msgs.hpp>
#include <scrubjay/robot/frame.hpp>
#include <scrubjay/robot/robot_model.hpp>
#include <string_view>

namespace scrubjay::ros {

/// Where a battery's status is no more OK. The levels are io's HealthLimits, as of `scrubjay doctor`.
struct BatteryLimits {
  double low = 0.15;    ///< share of the capacity, below which a Roomba looks for its dock: WARN
  double empty = 0.05;  ///< ERROR
  double hot = 50.0;    ///< WARN [deg C]
};

/// What it does; WARN where it can't drive: off, passive without a charger, or a wheel hangs down. `doing`: in a word
/// or two.
DiagnosticStatus robot_status(const RobotModel& robot, const Frame& frame, std::string_view doing);

/// Of a robot that speaks the Open Interface: others don't tell.
DiagnosticStatus battery_status(const Battery& battery, const BatteryLimits& limits = {});

}  // namespace scrubjay::ros
