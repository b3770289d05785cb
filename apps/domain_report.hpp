/// \file
/// What the doctor found in a domain of ROS 2, for people and for programs.
#pragma once

#include <scrubjay/ros2/survey.hpp>
#include <string>
#include <vector>

namespace scrubjay::apps {

/// Lines of 79 columns, unless a name is longer: settings, peers with what they write and read, findings.
std::string domain_text(const ros::Survey& survey, const std::vector<Finding>& findings);
/// The same as one JSON object.
std::string domain_json(const ros::Survey& survey, const std::vector<Finding>& findings);

}  // namespace scrubjay::apps
