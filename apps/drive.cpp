/// \file
/// `scrubjay drive`: a robot by keyboard.
#include <fmt/format.h>
#include <unistd.h>

#include <functional>
#include <memory>
#include <optional>
#include <scrubjay/error.hpp>
#include <scrubjay/io/key_drive.hpp>
#include <scrubjay/mission/paced_robot.hpp>
#include <scrubjay/robot/calibrated_robot.hpp>
#include <scrubjay/robot/oi_robot.hpp>
#include <scrubjay/simulation/simulated_roomba.hpp>
#include <scrubjay/simulation/simulated_turtlebot.hpp>

#include "audience.hpp"
#include "commands.hpp"
#include "data_folder.hpp"
#include "drive_view.hpp"
#include "interrupt.hpp"
#include "live_run.hpp"
#include "live_text.hpp"
#include "random_streams.hpp"
#include "robot_address.hpp"
#include "run_options.hpp"
#include "simulated_run.hpp"
#include "watched_drive.hpp"

namespace scrubjay::apps {
namespace {

struct DriveFlags {
  std::string robot = "sim";
  Scenario scenario;  // of a simulated one
  std::optional<std::string> model;
  std::optional<std::string> start;
  std::optional<std::string> calibration_file;
  KeyDriveParams keys;
  RosFlags ros;
};

/// A robot to drive, and its model.
class Driven {
 public:
  virtual ~Driven() = default;
  virtual Robot& robot() = 0;
  virtual const RobotModel& model() const = 0;
  /// The name of the model, or its URDF file.
  virtual const std::string& model_name() const = 0;
  /// As SerialRobot does; one that is never silent never calls it.
  virtual void while_silent(const std::function<bool(double)>&) {}
};

/// A simulated one, as fast as the clock.
class DrivenSimulation final : public Driven {
 public:
  explicit DrivenSimulation(const Scenario& scenario) : stage_(set_stage(scenario)), model_name_(scenario.model) {
    const Random random = Random(scenario.seed).fork(kRobotStream);
    const sim::RobotSpec& spec = stage_.robot;
    if (spec.model.open_interface) {
      roomba_.emplace(stage_.world, stage_.index, spec, stage_.noise, random, stage_.start);
      paced_.emplace(oi_robot_.emplace(*roomba_, spec.model), 1.0);
    } else {
      paced_.emplace(turtlebot_.emplace(stage_.world, stage_.index, spec, stage_.noise, random, stage_.start), 1.0);
    }
  }
  Robot& robot() override { return *paced_; }
  const RobotModel& model() const override { return stage_.robot.model; }
  const std::string& model_name() const override { return model_name_; }

 private:
  Stage stage_;
  std::string model_name_;
  std::optional<sim::SimulatedTurtlebot> turtlebot_;
  std::optional<sim::SimulatedRoomba> roomba_;
  std::optional<OiRobot> oi_robot_;
  std::optional<PacedRobot> paced_;
};

/// A real one.
class DrivenRoomba final : public Driven {
 public:
  DrivenRoomba(const SerialAddress& address, const std::optional<std::string>& model, const std::stop_token& stop)
      : live_(address, model, OiRobot::Session::Drive, stop, false), model_(live_.robot().model()) {}
  Robot& robot() override { return live_.robot(); }
  const RobotModel& model() const override { return model_; }
  const std::string& model_name() const override { return live_.model_name(); }
  void while_silent(const std::function<bool(double)>& go_on) override { live_.robot().while_silent(go_on); }

 private:
  LiveRobot live_;
  RobotModel model_;
};

std::unique_ptr<Driven> make_driven(const DriveFlags& flags, const std::stop_token& stop) {
  const RobotAddress address = parse_robot_address(flags.robot);
  if (std::holds_alternative<InSimulation>(address)) {
    if (flags.scenario.world.empty()) {
      throw Error("want a WORLD to drive a simulated robot in, as worlds/room.yaml, or --robot serial:PORT");
    }
    return std::make_unique<DrivenSimulation>(flags.scenario);
  }
  const auto* port = std::get_if<SerialAddress>(&address);
  if (port == nullptr) throw Error("a recording can't be driven; want --robot sim or serial:PORT");
  if (!flags.scenario.world.empty()) throw Error("a real robot drives in no WORLD; leave it out, or --robot");
  if (flags.model) find_oi_robot(*flags.model);
  return std::make_unique<DrivenRoomba>(*port, flags.model, stop);
}

void expect_limits(const KeyDriveParams& keys, const RobotModel& model) {
  if (!(keys.max_speed > 0.0 && keys.max_speed <= model.max_linear_speed)) {
    throw Error(fmt::format("--max-speed is {}; want more than 0 and at most {} m/s, which this robot can do",
                            keys.max_speed, model.max_linear_speed));
  }
  if (!(keys.max_turn > 0.0 && keys.max_turn <= model.max_angular_speed)) {
    throw Error(fmt::format("--max-turn is {}; want more than 0 and at most {} rad/s, which this robot can do",
                            keys.max_turn, model.max_angular_speed));
  }
}

Ended ended(DriveEnd end) {
  return end == DriveEnd::RobotGone ? Ended::RobotGone : Ended::Stopped;
}

/// Drives `robot`, which is the driven one as its calibration has it, until it is over; throws Error if that wasn't the
/// driver's will. `watched`: others see it; may be nobody.
void drive_until_the_end(Driven& driven, Robot& robot, const KeyDriveParams& params, WatchedDrive* watched,
                         const std::stop_token& stop) {
  DriveDisplay display(driven.model());
  KeyDriver driver(params);
  DriveEnd end = DriveEnd::Quit;
  {
    Keyboard keyboard(STDIN_FILENO);
    LiveText screen(STDOUT_FILENO);
    const auto keys = [&] { return keyboard.read(); };
    driven.while_silent([&](double silence) {
      screen.show(display.lines_of_silence(silence));
      return heed_keys_in_silence(driver, keys);
    });
    end = drive_by_keys(
        robot, driver, keys,
        [&](const Frame& frame, const Motion& motion, const KeyDriver& now) {
          display.take(frame);
          if (watched != nullptr) watched->see(frame, motion);
          screen.show(display.lines(frame, motion, now));
        },
        stop);
  }
  if (watched != nullptr) watched->end(ended(end), display.driven());
  if (end == DriveEnd::KeyboardGone) throw Error("the terminal went away; the robot was stopped", Error::Kind::Failure);
  if (end == DriveEnd::RobotGone) throw Error("the robot fell silent", Error::Kind::Failure);
  fmt::print("driven {:.2f} m; the robot stands\n", display.driven());
}

void drive(DriveFlags& flags) {
  if (::isatty(STDIN_FILENO) == 0 || ::isatty(STDOUT_FILENO) == 0) {
    throw Error("driving takes a terminal: its keyboard and its screen, neither of them redirected");
  }
  if (flags.model) flags.scenario.model = *flags.model;
  if (flags.start) flags.scenario.start = parse_pose(*flags.start, "--start");
  const bool on_a_wire = std::holds_alternative<SerialAddress>(parse_robot_address(flags.robot));
  const Interrupt interrupt(on_a_wire ? Interrupt::Stake::RobotOnAWire : Interrupt::Stake::Nothing);
  const std::unique_ptr<Driven> driven = make_driven(flags, interrupt.token());
  const RobotModel& model = driven->model();
  expect_limits(flags.keys, model);
  std::optional<CalibratedRobot> calibrated;
  if (flags.calibration_file) {
    calibrated.emplace(driven->robot(), calibration_for(driven->model_name(), *flags.calibration_file), model.drive);
  }
  Robot& robot = calibrated ? static_cast<Robot&>(*calibrated) : driven->robot();
  Audience audience(flags.ros, false);
  std::optional<WatchedDrive> watched;
  if (Publishing* publishing = audience.publishing()) {
    Scenario scenario = flags.scenario;
    scenario.model = driven->model_name();
    watched.emplace(scenario, model, *publishing, on_a_wire ? RunTime::Real : RunTime::Paced);
    audience.node()->hold_lines();
  }
  drive_until_the_end(*driven, robot, flags.keys, watched ? &*watched : nullptr, interrupt.token());
  audience.finish();
}

}  // namespace

void add_drive(CLI::App& app) {
  CLI::App* command = app.add_subcommand("drive", "Drive a robot by keyboard");
  const auto flags = std::make_shared<DriveFlags>();
  Scenario& scenario = flags->scenario;
  command->add_option("WORLD", scenario.world, "to drive a simulated robot in");
  command->add_option("--robot", flags->robot, "sim, or serial:PORT[@BAUD] (sim)");
  command->add_option(
      "--model", flags->model,
      "roomba-600, create-2, create-1, roomba-400,\nturtlebot3-burger or a URDF file (roomba-600, or what\nanswers)");
  command->add_option("--noise", scenario.noise, "simulated: none, hard-floor, carpet, uncalibrated (none)");
  command->add_option("--seed", scenario.seed, "simulated: of its noise (1)")->check(whole_number);
  command->add_option("--start", flags->start, "simulated: x,y,theta in the world [m, rad]");
  add_calibration_flag(*command, flags->calibration_file);
  command->add_option("--max-speed", flags->keys.max_speed, "full speed [m/s] (0.2)")->check(number);
  command->add_option("--max-turn", flags->keys.max_turn, "full rate of turn [rad/s] (1)")->check(number);
  add_ros_flags(*command, flags->ros, "be a node of ROS 2, for others to look on");
  command->callback([flags] { drive(*flags); });
}

}  // namespace scrubjay::apps
