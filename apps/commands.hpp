/// \file
/// The subcommands: each adds itself to the command line.
#pragma once

#include <CLI/CLI.hpp>

namespace scrubjay::apps {

/// What a subcommand's run tells main besides an exception.
inline constexpr int kSuccess = 0;
inline constexpr int kFailure = 1;     ///< the run failed
inline constexpr int kWrongInput = 2;  ///< wrong usage or input

void add_bridge(CLI::App& app);
void add_calibrate(CLI::App& app);
void add_doctor(CLI::App& app);
void add_drive(CLI::App& app);
void add_emulate(CLI::App& app);
void add_explore(CLI::App& app);
void add_replay(CLI::App& app);
void add_compare(CLI::App& app);
void add_record(CLI::App& app);
void add_tap(CLI::App& app);
void add_render(CLI::App& app);
void add_rooms(CLI::App& app);
void add_score(CLI::App& app);
void add_info(CLI::App& app);

}  // namespace scrubjay::apps
