/// \file
/// Rows of a doctor's report: a name and what there is to say, in lines of 79 columns at most; and what was found.
#pragma once

#include <nlohmann/json.hpp>
#include <scrubjay/finding.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace scrubjay::apps {

/// Words that begin after `begin` on the first line, and under it on the others. A word that is longer than a line
/// stays whole.
std::string wrapped(std::string_view begin, std::string_view text);
/// The same behind a name that takes 14 columns.
std::string row(std::string_view name, std::string_view text);

/// A paragraph each, and whether all is well.
std::string findings_text(const std::vector<Finding>& findings);
nlohmann::json findings_json(const std::vector<Finding>& findings);

}  // namespace scrubjay::apps
