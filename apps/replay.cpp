/// \file
/// `scrubjay replay LOG`: the same run from a recording of its bytes, or a map from a CARMEN log.
#include <fmt/format.h>

#include <memory>
#include <scrubjay/error.hpp>
#include <scrubjay/io/file_kind.hpp>

#include "commands.hpp"
#include "interrupt.hpp"
#include "recorded_run.hpp"
#include "replay_carmen.hpp"
#include "summary.hpp"

namespace scrubjay::apps {
namespace {

void replay(const ReplayFlags& flags) {
  expect_speed(flags.speed);
  check_octomap(flags.octomap);
  if (file_kind(flags.log) == FileKind::CarmenLog) {
    if (flags.calibration_file)
      throw Error(fmt::format("{}: a CARMEN log tells no wheels; want no --calibration", flags.log));
    return replay_carmen(flags);
  }
  if (flags.carmen != CarmenFlags{}) {
    throw Error(
        fmt::format("{}: no CARMEN log; want none of --poses, --resolution, --forward-cone, --robot-radius, "
                    "--max-range and --relations with it",
                    flags.log));
  }
  Recording recording = open_recording(flags.log);
  Scenario scenario = recording.scenario;
  if (flags.calibration_file) scenario.calibration = calibration_for(scenario.model, *flags.calibration_file);
  const std::filesystem::path folder = replay_folder(flags);
  prepare_results(folder, flags.octomap);
  const Interrupt interrupt;
  const RunResult run = run_recorded(recording, scenario, flags.speed, interrupt.token());
  deliver(run, folder, flags.octomap, flags.output);
}

}  // namespace

void add_replay(CLI::App& app) {
  CLI::App* command = app.add_subcommand("replay", "Map from a recording");
  const auto flags = std::make_shared<ReplayFlags>();
  command->add_option("LOG", flags->log, "an .oilog of explore --record, record or tap;\nor a CARMEN log (.gz)")
      ->required();
  command->add_option("--speed", flags->speed, "times real time; 0: as fast as possible (0)")->check(number);
  command->add_option("--out", flags->out, "folder for the results (out/LOG)");
  command->add_option("--calibration", flags->calibration_file, "other factors than those it was driven with");
  add_carmen_flags(*command, flags->carmen);
  add_octomap_flags(*command, flags->octomap);
  add_output_flags(*command, flags->output);
  command->callback([flags] { replay(*flags); });
}

}  // namespace scrubjay::apps
