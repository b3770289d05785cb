/// \file
/// What a run tells when it is over.
#pragma once

#include <filesystem>
#include <scrubjay/io/run_files.hpp>
#include <scrubjay/io/run_folder.hpp>
#include <scrubjay/io/serial_robot.hpp>
#include <string>

#include "run_options.hpp"

namespace scrubjay::apps {

/// The folder of a run's results. Throws Error (Kind::Failure) unless they can be written: asked before it, so that
/// none is in vain.
[[nodiscard]] RunFolder prepare_results(const std::filesystem::path& folder, const OctomapFlags& octomap);

/// Writes the results of a run into `folder`, and prints a summary for people or metrics.json for programs: that even
/// if writing fails, before it throws.
void deliver(const RunResult& run, const std::filesystem::path& folder, const OctomapFlags& octomap,
             const OutputFlags& flags);

/// As in "link: 40,123 frames, 3 lost, 1 reconnection (0.8 s silent)".
std::string link_line(const LinkReport& link);

}  // namespace scrubjay::apps
