/// \file
/// `scrubjay record`: keeps what a robot senses, and drives nothing.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <scrubjay/error.hpp>
#include <scrubjay/io/scenario_file.hpp>

#include "commands.hpp"
#include "data_folder.hpp"
#include "interrupt.hpp"
#include "live_run.hpp"
#include "recorded_run.hpp"
#include "robot_address.hpp"
#include "run_options.hpp"
#include "summary.hpp"

namespace scrubjay::apps {
namespace {

struct RecordFlags {
  std::string robot;
  std::string out;
  std::optional<std::string> model;
  std::optional<std::string> calibration_file;
  double max_time = 7200.0;  ///< [s]
  OutputFlags output;
};

void record(const RecordFlags& flags) {
  const SerialAddress address = parse_serial_robot(flags.robot);
  if (!(flags.max_time > 0.0)) throw Error(fmt::format("--max-time is {}; want a number above 0", flags.max_time));
  if (flags.model) find_oi_robot(*flags.model);
  const Interrupt interrupt;
  LiveRobot live(address, flags.model, OiRobot::Session::Listen, interrupt.token(), flags.output.quiet);
  Scenario scenario;  // without a strategy: nobody of ours drives
  live.enter(scenario, flags.calibration_file);
  scenario.max_time = std::clamp(flags.max_time, scenario.max_time, kLongestReplay);
  SerialRobot& robot = live.robot();
  robot.record(std::make_unique<RecordingWriter>(flags.out, scenario_text(scenario)));
  std::optional<double> first;
  bool is_there = true;
  while (!interrupt.token().stop_requested()) {
    const auto frame = robot.next();
    is_there = frame.has_value();
    if (!is_there) break;
    if (!first) first = frame->stamp;
    if (frame->stamp - *first >= flags.max_time) break;
  }
  robot.stop();
  robot.close_recording();
  if (!flags.output.quiet) fmt::print("{}\nrecording: {}\n", link_line(robot.report()), flags.out);
  if (!is_there && !interrupt.token().stop_requested()) {
    throw Error("the robot fell silent", Error::Kind::Failure);
  }
}

}  // namespace

void add_record(CLI::App& app) {
  CLI::App* command = app.add_subcommand("record", "Record what a robot senses, without driving it");
  const auto flags = std::make_shared<RecordFlags>();
  command->add_option("--robot", flags->robot, "serial:PATH[@BAUD]")->required();
  command->add_option("--out", flags->out, "the recording, an .oilog")->required();
  command->add_option("--model", flags->model, "the one that is expected (what answers)");
  add_calibration_flag(*command, flags->calibration_file);
  command->add_option("--max-time", flags->max_time, "seconds (7200)")->check(number);
  command->add_flag("--quiet", flags->output.quiet, "print no summary");
  command->callback([flags] { record(*flags); });
}

}  // namespace scrubjay::apps
