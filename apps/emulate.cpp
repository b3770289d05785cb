/// \file
/// `scrubjay emulate WORLD --pty LINK`: be Roombas on serial ports.
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <memory>
#include <scrubjay/error.hpp>
#include <scrubjay/io/atomic_file.hpp>
#include <scrubjay/io/line_server.hpp>

#include "brc_pin.hpp"
#include "commands.hpp"
#include "data_folder.hpp"
#include "emulation.hpp"
#include "fault_flags.hpp"
#include "interrupt.hpp"
#include "run_options.hpp"
#include "tick_clock.hpp"

namespace scrubjay::apps {
namespace {

struct EmulateFlags {
  std::string world;
  std::string link;
  Scenario defaults;
  std::string model = defaults.model;
  std::string noise = defaults.noise;
  std::uint64_t seed = defaults.seed;
  std::optional<std::string> start;
  int count = 1;
  double speed = 1.0;
  std::optional<double> max_time;
  FaultFlags faults;
  std::optional<std::string> truth;
  std::optional<std::string> truth_log;
  std::optional<int> truth_port;
  OutputFlags output;
};

void check(const EmulateFlags& flags) {
  if (flags.count < 1 || flags.count > 100) {
    throw Error(fmt::format("--count is {}; want 1 to 100 robots", flags.count));
  }
  if (!(flags.speed > 0.0 && flags.speed <= 1e6)) {
    throw Error(fmt::format("--speed is {}; want a factor of real time, more than 0", flags.speed));
  }
  if (flags.max_time && !(*flags.max_time > 0.0)) {
    throw Error(fmt::format("--max-time is {}; want a positive number of seconds", *flags.max_time));
  }
  if (flags.truth_port && (*flags.truth_port < 0 || *flags.truth_port > 65'535)) {
    throw Error(fmt::format("--truth-port is {}; want a port, 1 to 65535, or 0 for any", *flags.truth_port));
  }
}

Stage set_emulated_stage(const EmulateFlags& flags) {
  Scenario scenario;
  scenario.world = flags.world;
  scenario.model = flags.model;
  scenario.noise = flags.noise;
  scenario.seed = flags.seed;
  if (flags.start) scenario.start = parse_pose(*flags.start, "--start");
  find_oi_robot(flags.model);
  return set_stage(scenario);
}

/// Where the robots are, as lines of JSON while they drive.
class LiveTruth {
 public:
  explicit LiveTruth(const EmulateFlags& flags) {
    if (flags.truth_log) {
      log_.emplace(*flags.truth_log, std::ios::trunc);
      if (!*log_) throw Error(fmt::format("{}: cannot write", *flags.truth_log), Error::Kind::Failure);
    }
    if (flags.truth_port) server_.emplace(static_cast<std::uint16_t>(*flags.truth_port));
  }

  std::optional<std::uint16_t> port() const { return server_ ? std::optional(server_->port()) : std::nullopt; }

  void tell(const Emulation& emulation) {
    constexpr double kInterval = 0.1;  // [s]
    if ((!log_ && !server_) || emulation.now() < next_) return;
    next_ += kInterval;
    for (const EmulatedRobot& robot : emulation.robots()) {
      const std::string line = robot.now_json().dump();
      if (log_) *log_ << line << '\n' << std::flush;
      if (server_) server_->tell(line);
    }
  }

 private:
  std::optional<std::ofstream> log_;
  std::optional<LineServer> server_;
  double next_ = 0.0;
};

/// To stdout, or beside it where that is to hold nothing but JSON.
void introduce(const Emulation& emulation, const EmulateFlags& flags, const std::optional<std::uint16_t>& port) {
  if (flags.output.quiet) return;
  std::FILE* const to = flags.output.json ? stderr : stdout;
  for (const EmulatedRobot& robot : emulation.robots()) {
    fmt::print(to, "{} behind {} ({})\n", flags.model, robot.link().string(), robot.terminal().device().string());
  }
  if (port) fmt::print(to, "where they are: port {} of this machine, as lines of JSON\n", *port);
  fmt::print(to, "try: scrubjay explore --robot serial:{}\n", emulation.robots().front().link().string());
  if (flags.faults.asleep) fmt::print(to, "asleep; SIGUSR1 or the line brc on stdin wakes them\n");
  fmt::print(to, "Ctrl-C ends it\n");
  std::fflush(to);
}

nlohmann::ordered_json account_of(const Emulation& emulation, const EmulateFlags& flags, double gave_up) {
  nlohmann::ordered_json account{{"world", flags.world},  {"model", flags.model}, {"noise", flags.noise},
                                 {"seed", flags.seed},    {"speed", flags.speed}, {"time", emulation.now()},
                                 {"fell_behind", gave_up}};
  for (const EmulatedRobot& robot : emulation.robots()) account["robots"].push_back(robot.account());
  return account;
}

void print_account(const nlohmann::ordered_json& account, const OutputFlags& output) {
  if (output.json) return fmt::print("{}\n", account.dump(2));
  if (output.quiet) return;
  for (const auto& robot : account["robots"]) {
    fmt::print("{}: {:.0f} s, {:.2f} m driven, turned {:.0f} degrees, {} bumps, {} bytes received, {} sent\n",
               robot["link"].get<std::string>(), account["time"].get<double>(), robot["distance"].get<double>(),
               degrees(robot["turned"].get<double>()), robot["bumps"].get<std::uint64_t>(),
               robot["bytes"]["received"].get<std::uint64_t>(), robot["bytes"]["sent"].get<std::uint64_t>());
  }
}

/// Until a stop is asked for or the time is over; returns how far it fell behind in all [s].
double run(Emulation& emulation, const EmulateFlags& flags, LiveTruth& live, BrcPin& pin, const std::stop_token& stop) {
  double gave_up = 0.0;
  TickClock clock(sim::kTick, flags.speed);
  while (clock.wait(stop)) {
    if (clock.gave_up() > 0.0) {
      gave_up += clock.gave_up();
      fmt::print(stderr, "scrubjay: {:.1f} s behind the clock; going on from here\n", clock.gave_up());
    }
    for (const std::size_t robot : pin.pulsed()) emulation.pulse_brc(robot);
    emulation.tick();
    live.tell(emulation);
    if (flags.max_time && emulation.now() >= *flags.max_time) break;
  }
  return gave_up;
}

void emulate(const EmulateFlags& flags) {
  check(flags);
  const EmulatedFaults faults = make_faults(flags.faults);
  const Stage stage = set_emulated_stage(flags);
  const auto count = static_cast<std::size_t>(flags.count);
  if (flags.truth) AtomicFiles().add(*flags.truth, "");  // nobody is to drive in vain
  // Signals have their meaning before anybody can know that there is a robot.
  const Interrupt interrupt;
  BrcPin pin(count);
  LiveTruth live(flags);
  Emulation emulation(stage, count, faults, flags.seed, flags.link);
  introduce(emulation, flags, live.port());
  const double gave_up = run(emulation, flags, live, pin, interrupt.token());
  const nlohmann::ordered_json account = account_of(emulation, flags, gave_up);
  try {
    if (flags.truth) write_file_atomically(*flags.truth, account.dump(2) + "\n");
  } catch (const Error&) {
    print_account(account, flags.output);  // nobody can drive this again
    throw;
  }
  print_account(account, flags.output);
}

}  // namespace

void add_emulate(CLI::App& app) {
  CLI::App* command = app.add_subcommand("emulate", "Be Roombas on serial ports, for any client");
  const auto flags = std::make_shared<EmulateFlags>();
  command->add_option("WORLD", flags->world, "world YAML, HouseExpo plan or nav2 map")->required();
  command
      ->add_option("--pty", flags->link,
                   "link to make to the robot's serial port;\nLINK0, LINK1 ... if --count is more than 1")
      ->required();
  command->add_option("--model", flags->model,
                      "roomba-600, create-2, create-1, roomba-400\nor a URDF file (roomba-600)");
  command->add_option("--count", flags->count, "robots, which see and block each other (1)");
  command->add_option("--noise", flags->noise, "none, hard-floor, carpet, uncalibrated (none)");
  command->add_option("--seed", flags->seed, "of noise and faults (1)")->check(whole_number);
  command->add_option("--start", flags->start, "x,y,theta of the first robot in the world [m, rad]");
  command->add_option("--speed", flags->speed, "times real time (1)")->check(number);
  command->add_option("--max-time", flags->max_time, "simulated seconds (until it is interrupted)")->check(number);
  command->add_option("--truth", flags->truth, "file for what really happened, as JSON, at the end");
  command->add_option("--truth-log", flags->truth_log, "file for where the robots are, a line of JSON\neach 0.1 s");
  command->add_option("--truth-port", flags->truth_port, "the same at this TCP port of this machine; 0: any");
  add_fault_flags(*command, flags->faults);
  add_output_flags(*command, flags->output);
  command->callback([flags] { emulate(*flags); });
}

}  // namespace scrubjay::apps
