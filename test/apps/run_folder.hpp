/// \file
/// What is in a folder that a run was to leave behind.
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

namespace scrubjay {

/// Everything under a folder by its path in it: a file's bytes, and for a folder "folder".
using Contents = std::map<std::string, std::string>;

/// `temporary`: with the files that a killed program had not yet given their names.
Contents contents_of(const std::filesystem::path& folder, bool temporary = true);

/// The same but for the clock's figures, which no two runs have in common.
Contents repeatable(Contents contents);

std::set<std::string> names_of(const Contents& contents);

/// The files of a simulated run.
extern const std::set<std::string> kRunFiles;

/// Why the results in the folder aren't whole: those that are there, and not all need be. Empty if they are.
std::string broken_result(const std::filesystem::path& folder);

/// Throws if it isn't JSON.
nlohmann::json metrics_of(const std::filesystem::path& folder);

}  // namespace scrubjay
