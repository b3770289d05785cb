/// \file
/// `scrubjay doctor`: what is connected, and whether it is well; or the same of a domain of ROS 2.
#include <fmt/format.h>
#include <unistd.h>

#include <memory>
#include <optional>
#include <scrubjay/error.hpp>
#include <scrubjay/io/examination.hpp>

#include "commands.hpp"
#include "doctor_hands.hpp"
#include "doctor_report.hpp"
#include "doctor_ros2.hpp"
#include "interrupt.hpp"
#include "robot_address.hpp"
#include "run_options.hpp"

namespace scrubjay::apps {
namespace {

struct DoctorFlags {
  std::optional<std::string> port;
  double listen = 3.0;
  bool check = false;
  bool yes = false;
  bool no_reset = false;
  bool json = false;
  RosFlags ros;
};

void say(const std::string& what) {
  if (::isatty(STDERR_FILENO) != 0) fmt::print(stderr, "{}\n", what);
}

SerialAddress choose_port(const DoctorFlags& flags) {
  if (flags.port) return parse_port(*flags.port, "--port");
  const std::vector<std::filesystem::path> ports = serial_ports();
  if (ports.empty()) throw Error("there is no serial port on USB; plug the robot's cable in, or name one with --port");
  if (ports.size() > 1) {
    std::string names;
    for (const std::filesystem::path& port : ports) names += (names.empty() ? "" : ", ") + port.string();
    throw Error(fmt::format("there are several ports: {}; name one with --port", names));
  }
  say(fmt::format("the only port is {}", ports.front().string()));
  return {ports.front()};
}

/// Throws Error where the domain is to be examined, and something of a port is told.
void expect_no_port(const DoctorFlags& flags) {
  if (!flags.port && !flags.check && !flags.yes && !flags.no_reset) return;
  throw Error("--ros2 examines others, and no robot; want none of --port, --check, --yes and --no-reset with it");
}

/// Tries these rates until one answers, and wakes it in between. The rate that it was.
int find_rate(SerialPort& port, Examination& examination, const std::vector<int>& rates, const std::stop_token& stop) {
  std::optional<int> foreign;
  for (const int rate : rates) {
    say(fmt::format("listening at {} baud ...", rate));
    port.set_baud(rate);
    port.discard();
    Contact contact = examination.find_robot();
    if (contact == Contact::Silent && port.pulse_wake()) contact = examination.find_robot();
    if (contact == Contact::Robot || stop.stop_requested()) return rate;
    if (contact == Contact::Foreign && !foreign) foreign = rate;
  }
  if (foreign) {  // what said more than nothing is what there is to report
    port.set_baud(*foreign);
    examination.find_robot();
  }
  return foreign.value_or(rates.front());
}

void examine(Examination& examination, const DoctorFlags& flags) {
  if (!flags.no_reset) {
    say("starting the robot anew, to read the release of its firmware ...");
    if (!examination.read_banner()) return;
  }
  say("measuring ...");
  examination.time_replies();
  examination.listen(flags.listen);
}

void doctor(const DoctorFlags& flags) {
  if (!(flags.listen >= 0.5 && flags.listen <= 3600.0)) {
    throw Error(fmt::format("--listen is {}; want 0.5 to 3600 seconds", flags.listen));
  }
  if (flags.ros.wanted) {
    expect_no_port(flags);
    return examine_domain(flags.ros, flags.listen, flags.json);
  }
  if (flags.ros.distro) throw Error("--ros-distro is of nodes; want --ros2 with it");
  const Interrupt interrupt;
  PortReport port_report;
  port_report.address = choose_port(flags);
  SerialPort port(port_report.address);
  port_report.driver = serial_driver(port_report.address.path);
  port_report.low_latency = port.low_latency();

  Examination examination(
      port, [&port] { return port.now(); }, interrupt.token());
  port_report.address.baud = find_rate(port, examination, rates_to_try(port_report.address), interrupt.token());
  std::optional<HandCheck> hands;
  if (examination.report().contact == Contact::Robot) {
    examine(examination, flags);
    const bool somebody = ::isatty(STDIN_FILENO) != 0 && ::isatty(STDERR_FILENO) != 0 && !flags.json;
    const bool well = examination.report().frames.frames > 0 && !examination.report().link_lost;
    if (well && !flags.yes && (flags.check || somebody)) hands = check_by_hand(examination, interrupt.token());
  }
  if (interrupt.token().stop_requested())
    throw Error("interrupted; nothing is known of the robot", Error::Kind::Failure);

  const HandCheck* felt = hands ? &*hands : nullptr;
  const std::vector<Finding> findings = diagnose(examination.report(), felt);
  fmt::print("{}", (flags.json ? report_json : report_text)(port_report, examination.report(), felt, findings));
  if (!healthy(findings)) throw Error("the robot isn't healthy", Error::Kind::Failure);
}

}  // namespace

void add_doctor(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "doctor", "Examine a robot on a serial port, which never drives,\nor who else is in the domain of ROS 2");
  const auto flags = std::make_shared<DoctorFlags>();
  command->add_option("--port", flags->port, "PATH[@BAUD], as /dev/ttyUSB0 (the only one there is)");
  command->add_option("--listen", flags->listen, "count frames, or look for others, for so long [s] (3)")
      ->check(number);
  command->add_flag("--check", flags->check, "check bumpers and wheels by hand, terminal or not");
  command->add_flag("--yes", flags->yes, "ask nothing: no check by hand");
  command->add_flag("--no-reset", flags->no_reset, "don't restart the robot to read its release");
  command->add_flag("--json", flags->json, "print the report as JSON");
  add_ros_flags(*command, flags->ros, "examine who else is in the domain of ROS 2, and what\nthey hear of us");
  command->callback([flags] { doctor(*flags); });
}

}  // namespace scrubjay::apps
