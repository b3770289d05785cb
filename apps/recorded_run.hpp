/// \file
/// A mission with a robot whose bytes were recorded.
#pragma once

#include <filesystem>
#include <optional>
#include <scrubjay/io/recording.hpp>
#include <scrubjay/io/run_files.hpp>
#include <scrubjay/mission/scenario.hpp>
#include <stop_token>
#include <string>

namespace scrubjay::apps {

class Publishing;

/// The longest that a scenario's max_time may be [s]: of a recording that is replayed to its end, however long.
inline constexpr double kLongestReplay = 1e7;

struct Recording {
  std::string name;  ///< of its file
  RecordingReader reader;
  Scenario scenario;               ///< with no strategy if somebody else drove
  std::optional<RecordedEnd> end;  ///< of the mission that it is of
  bool is_ours = true;  ///< one of our strategies drove; otherwise what a client asked for tells what the bytes mean
};

/// Throws Error for what is no recording, or was cut before its scenario ends.
Recording open_recording(const std::filesystem::path& file);

/// A replayed run beside the world that it was in, if the scenario names one that can be read: a real one is in no
/// file. Says on stderr that it can't. `name`: of what was replayed.
std::optional<RunTruth> find_truth(const std::string& name, const RunResult& run);

struct ReplayOptions {
  double speed = 0.0;                ///< times real time; 0 is as fast as possible
  Publishing* publishing = nullptr;  ///< tells others; may be nobody
};

/// Decides anew from the same frames, with `scenario` in place of the recording's; the robot of a recording goes where
/// it went. Without a strategy nobody decides anything, and only the map is made.
///
/// Scored if the scenario's world can be read. Says on stderr if not, and if the recording was cut. Throws Error
/// (Kind::Failure) if it holds not a single frame.
RunResult run_recorded(Recording& recording, const Scenario& scenario, const ReplayOptions& options,
                       const std::stop_token& stop);

}  // namespace scrubjay::apps
