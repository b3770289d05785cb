/// \file
/// Strategies by name.
#pragma once

#include <memory>
#include <optional>
#include <scrubjay/behavior/behavior.hpp>
#include <scrubjay/geometry/bounds.hpp>
#include <scrubjay/geometry/random.hpp>
#include <scrubjay/robot/robot_model.hpp>
#include <string_view>
#include <vector>

namespace scrubjay {

/// What a strategy is made for.
struct StrategySetting {
  RobotModel robot{};
  Random random{0};
  std::optional<Bounds2> within{};  ///< floor to stay on, for those that plan
  bool return_home = false;         ///< drive back to the start once done, for those that end
};

/// From the one that knows least to the one that knows most.
std::vector<std::string_view> strategy_names();
/// Those that a robot has the senses for.
std::vector<std::string_view> strategy_names(const RobotModel& robot);
/// `frontiers` with a lidar, `contact-frontier` without.
std::string_view default_strategy(const RobotModel& robot);

/// Throws Error that lists the known ones, and the nearest, for a name that isn't one; one that says what is missing
/// for a robot that hasn't the senses; and one that lists those that can for bounds or a way home that it can't heed.
std::unique_ptr<Behavior> make_strategy(std::string_view name, const StrategySetting& setting);

}  // namespace scrubjay
