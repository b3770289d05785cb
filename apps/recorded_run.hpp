/// \file
/// A mission with a robot whose bytes were recorded.
#pragma once

#include <filesystem>
#include <scrubjay/io/recording.hpp>
#include <scrubjay/io/run_files.hpp>
#include <scrubjay/mission/scenario.hpp>
#include <stop_token>

namespace scrubjay::apps {

struct Recording {
  RecordingReader reader;
  Scenario scenario;    ///< with no strategy if somebody else drove
  bool is_ours = true;  ///< one of our strategies drove; otherwise what a client asked for tells what the bytes mean
};

/// Throws Error for what is no recording, or was cut before its scenario ends.
Recording open_recording(const std::filesystem::path& file);

/// Decides anew from the same frames, with `scenario` in place of the recording's; the robot of a recording goes where
/// it went. Without a strategy nobody decides anything, and only the map is made. `speed`: times real time; 0 is as
/// fast as possible.
RunResult run_recorded(Recording& recording, const Scenario& scenario, double speed, const std::stop_token& stop);

}  // namespace scrubjay::apps
