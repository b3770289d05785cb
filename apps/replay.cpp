/// \file
/// `scrubjay replay LOG`: the same run from a recording of its bytes, or a map from a CARMEN log.
#include <fmt/format.h>

#include <memory>
#include <scrubjay/error.hpp>
#include <scrubjay/io/file_kind.hpp>

#include "audience.hpp"
#include "commands.hpp"
#include "interrupt.hpp"
#include "recorded_run.hpp"
#include "replay_bag.hpp"
#include "replay_carmen.hpp"
#include "summary.hpp"

namespace scrubjay::apps {
namespace {

void replay(const ReplayFlags& flags) {
  expect_speed(flags.speed.value_or(0.0));
  check_octomap(flags.octomap);
  const FileKind kind = file_kind(flags.log);
  const bool tells_wheels = kind != FileKind::CarmenLog && kind != FileKind::Bag;
  if (flags.calibration_file && !tells_wheels) {
    throw Error(fmt::format("{}: a {} tells no wheels; want no --calibration", flags.log, to_string(kind)));
  }
  if (kind == FileKind::CarmenLog) return replay_carmen(flags);
  if (flags.carmen != CarmenFlags{}) {
    throw Error(
        fmt::format("{}: no CARMEN log; want none of --poses, --resolution, --forward-cone, --robot-radius, "
                    "--max-range and --relations with it",
                    flags.log));
  }
  if (kind == FileKind::Bag) return replay_bag(flags);
  Recording recording = open_recording(flags.log);
  Scenario scenario = recording.scenario;
  if (flags.calibration_file) scenario.calibration = calibration_for(scenario.model, *flags.calibration_file);
  const RunFolder folder = prepare_results(replay_folder(flags), flags.octomap);
  const Interrupt interrupt;
  Audience audience(flags.ros, flags.output.quiet);
  const RunResult run =
      run_recorded(recording, scenario, {replay_speed(flags), audience.publishing()}, interrupt.token());
  audience.finish();
  deliver(run, folder.path(), flags.octomap, flags.output);
}

}  // namespace

void add_replay(CLI::App& app) {
  CLI::App* command = app.add_subcommand("replay", "Map from a recording");
  const auto flags = std::make_shared<ReplayFlags>();
  command->add_option("LOG", flags->log, "an .oilog, an .mcap or a folder of rosbag2;\nor a CARMEN log (.gz)")
      ->required();
  command->add_option("--speed", flags->speed, "times real time; 0: as fast as possible (0)")->check(number);
  command->add_option("--out", flags->out, "folder for the results (out/LOG)");
  command->add_option("--calibration", flags->calibration_file, "other factors than those it was driven with");
  add_carmen_flags(*command, flags->carmen);
  add_octomap_flags(*command, flags->octomap);
  add_ros_flags(*command, flags->ros, "be a node of ROS 2; as fast as it was then");
  add_output_flags(*command, flags->output);
  command->callback([flags] { replay(*flags); });
}

}  // namespace scrubjay::apps
