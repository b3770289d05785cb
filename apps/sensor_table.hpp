/// \file
/// All that a Roomba senses, as a table for people.
#pragma once

#include <scrubjay/oi/mode.hpp>
#include <scrubjay/oi/model.hpp>
#include <scrubjay/oi/sensors.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace scrubjay::apps {

/// Lines of 79 columns at most, without their ends: what the model has, grouped as people think of it.
std::vector<std::string> sensor_table(const oi::Sensors& sensors, oi::Model model);

/// As "full charging".
std::string_view charging_name(const oi::Sensors& sensors);

/// As "Passive".
std::string_view mode_name(oi::OiMode mode);

/// As "82 % of 2.70 Ah, 15.90 V, -0.21 A, 24 degrees, not charging".
std::string battery_line(const oi::Sensors& sensors);

}  // namespace scrubjay::apps
