/// \file
/// Strategies by name.
#pragma once

#include <memory>
#include <scrubjay/behavior/behavior.hpp>
#include <scrubjay/geometry/random.hpp>
#include <scrubjay/robot/robot_model.hpp>
#include <string_view>
#include <vector>

namespace scrubjay {

/// From the one that knows least to the one that knows most.
std::vector<std::string_view> strategy_names();

/// Throws Error that lists the known ones, and the nearest, for a name that isn't one.
std::unique_ptr<Behavior> make_strategy(std::string_view name, const RobotModel& robot, const Random& random);

}  // namespace scrubjay
