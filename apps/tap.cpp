/// \file
/// `scrubjay tap`: listens between a robot and any client, and records both.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <scrubjay/error.hpp>
#include <scrubjay/io/scenario_file.hpp>
#include <scrubjay/io/wire_tap.hpp>

#include "commands.hpp"
#include "data_folder.hpp"
#include "interrupt.hpp"
#include "recorded_run.hpp"
#include "robot_address.hpp"
#include "run_options.hpp"

namespace scrubjay::apps {
namespace {

struct TapFlags {
  std::string port;
  std::string terminal;
  std::string record;
  std::string model = "roomba-600";
  std::optional<std::string> calibration_file;
  double max_time = 1e7;  ///< [s]
  bool quiet = false;
};

void tap(const TapFlags& flags) {
  const SerialAddress address = parse_port(flags.port, "--port");
  if (!(flags.max_time > 0.0)) throw Error(fmt::format("--max-time is {}; want a number above 0", flags.max_time));
  find_oi_robot(flags.model);
  Scenario scenario;  // without a strategy: the client drives
  scenario.model = flags.model;
  scenario.max_time = std::clamp(flags.max_time, scenario.max_time, kLongestReplay);
  if (flags.calibration_file) scenario.calibration = calibration_for(scenario.model, *flags.calibration_file);
  const Interrupt interrupt;
  SerialPort port(address);
  PseudoTerminal terminal(flags.terminal);
  RecordingWriter recording(flags.record, scenario_text(scenario));
  if (!flags.quiet) fmt::print(stderr, "scrubjay: clients find the robot at {}; Ctrl-C ends it\n", flags.terminal);
  const TapReport report = tap_wire(port, terminal, recording, flags.max_time, interrupt.token());
  recording.close();
  if (!flags.quiet) {
    fmt::print("{:.1f} s: {} bytes from the robot, {} bytes to it\n", report.time, report.from_robot, report.to_robot);
    if (report.unread > 0) fmt::print("{} bytes were never read by the client\n", report.unread);
    fmt::print("recording: {}\n", flags.record);
  }
  if (report.robot_gone) {
    throw Error(fmt::format("{}: the port went away", address.path.string()), Error::Kind::Failure);
  }
}

}  // namespace

void add_tap(CLI::App& app) {
  CLI::App* command = app.add_subcommand("tap", "Record what a robot and any client say to each other");
  const auto flags = std::make_shared<TapFlags>();
  command->add_option("--port", flags->port, "the robot's, as /dev/ttyUSB0[@115200]")->required();
  command->add_option("--pty", flags->terminal, "link that clients open instead")->required();
  command->add_option("--record", flags->record, "the recording, an .oilog")->required();
  command->add_option("--model", flags->model, "of the robot, for whoever replays it (roomba-600)");
  add_calibration_flag(*command, flags->calibration_file);
  command->add_option("--max-time", flags->max_time, "seconds (1e7)")->check(number);
  command->add_flag("--quiet", flags->quiet, "print no summary");
  command->callback([flags] { tap(*flags); });
}

}  // namespace scrubjay::apps
