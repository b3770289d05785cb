/// \file
/// Scenarios as YAML.
#pragma once

#include <filesystem>
#include <scrubjay/mission/scenario.hpp>
#include <string>

namespace scrubjay {

/// Fields have the names of Scenario's members, `start` being [x, y, theta]. Numbers read back the same.
std::string scenario_text(const Scenario& scenario);
/// Fields that aren't given are as in Scenario. `file` stands in the errors: Error with line and field.
Scenario parse_scenario(const std::string& text, const std::string& file);
Scenario read_scenario(const std::filesystem::path& path);

}  // namespace scrubjay
