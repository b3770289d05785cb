/// \file
/// What a run tells when it is over.
#pragma once

#include <filesystem>
#include <scrubjay/io/run_files.hpp>

#include "run_options.hpp"

namespace scrubjay::apps {

/// Prints a summary for people, or metrics.json for programs. `folder` is where the files are.
void print_summary(const RunResult& run, const std::filesystem::path& folder, const OutputFlags& flags);

}  // namespace scrubjay::apps
