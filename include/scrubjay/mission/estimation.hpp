/// \file
/// The localizer and the mapper that a scenario asks for.
#pragma once

#include <memory>
#include <scrubjay/localization/localizer.hpp>
#include <scrubjay/mapping/mapper.hpp>
#include <scrubjay/mission/scenario.hpp>
#include <scrubjay/robot/robot_model.hpp>

namespace scrubjay {

/// What turns frames into poses and a map.
struct Estimation {
  std::unique_ptr<Mapper> mapper;
  std::unique_ptr<Localizer> localizer;  ///< may look at the mapper's map
};

/// "scan-matching" with a lidar, "odometry" without.
std::string_view default_localizer(const RobotModel& robot);

/// Throws Error for a localizer that isn't one, or that the robot lacks a lidar for.
Estimation make_estimation(const Scenario& scenario, const RobotModel& robot);

}  // namespace scrubjay
