/// \file
/// What a run tells when it is over.
#pragma once

#include <filesystem>
#include <scrubjay/io/run_files.hpp>
#include <scrubjay/io/serial_robot.hpp>
#include <string>

#include "run_options.hpp"

namespace scrubjay::apps {

/// Prints a summary for people, or metrics.json for programs. `folder` is where the files are.
void print_summary(const RunResult& run, const std::filesystem::path& folder, const OutputFlags& flags);

/// As in "link: 40,123 frames, 3 lost, 1 reconnection (0.8 s silent)".
std::string link_line(const LinkReport& link);

}  // namespace scrubjay::apps
