#include <fmt/format.h>

#include <algorithm>
#include <scrubjay/io/serial_robot.hpp>
#include <scrubjay/oi/command.hpp>
#include <scrubjay/robot/reconnection.hpp>
#include <thread>

#include "robot_finder.hpp"
#include "serial_wire.hpp"
#include "watchdog.hpp"

namespace scrubjay {
namespace {

constexpr double kHaltInterval = 0.03;              // between two orders to stand, to a robot that rolls on [s]
constexpr double kHaltsEnd = 1.5;                   // from full speed a robot brakes for as long [s]
constexpr double kHopelessEnd = 0.2;                // for one that has been silent anyway [s]
constexpr double kPassiveEnd = 0.5;                 // for the robot to say that it is Passive [s]
constexpr double kQuietEnd = 0.2;                   // for the stream to end [s]
constexpr std::chrono::milliseconds kPatience{10};  // between two looks at what isn't there

RobotModel body_of(const FoundRobot& found, const std::optional<RobotModel>& expected,
                   const SerialRobotParams& params) {
  RobotModel model = expected ? *expected : params.body ? params.body(found.protocol) : RobotModel{};
  model.protocol = found.protocol;
  model.has_light_sensors = model.has_light_sensors && found.protocol == oi::Model::Create2;
  return model;
}

}  // namespace

/// The session with the robot, and how its link is.
///
/// Alive -> Silent when no frame came for a while: told to stand again and again, and the session is taken up anew with
/// growing pauses, on a port that is opened anew if it went away, and once by waking it; -> Alive with the next frame.
struct SerialRobot::State {
  State(const SerialAddress& address, const std::optional<RobotModel>& expected, std::stop_token ask_to_stop,
        const SerialRobotParams& given)
      : params(given),
        stop_asked(std::move(ask_to_stop)),
        wire(address),
        found(find_robot(wire.port(), address, expected ? std::optional(expected->protocol) : std::nullopt,
                         given.connect_timeout, given.session, stop_asked)),
        model(body_of(found, expected, given)),
        reconnection({given.first_retry, given.longest_retry, given.give_up}),
        watchdog(given.renewal, [this] {
          wire.write(encode(oi::Drive{oi::Velocity(0), oi::Radius::straight()}));
        }) {
    wire.set_baud(found.baud);
    remark(address, expected);
  }

  void remark(const SerialAddress& address, const std::optional<RobotModel>& expected) {
    if (found.woken) remarks.emplace_back("the robot was asleep, and was woken");
    if (found.baud != address.baud) {
      remarks.push_back(fmt::format("the robot answers at {} baud, not at {}", found.baud, address.baud));
    }
    if (expected && expected->protocol != found.protocol) {
      remarks.push_back(
          fmt::format("the robot speaks as a {}, not as a {}", name_of(found.protocol), name_of(expected->protocol)));
    }
    if (found.mode_one_too_high) remarks.emplace_back("the robot reports its mode one too high, which is allowed for");
    if (!wire.port().low_latency()) remarks.emplace_back("the port's driver may hold bytes back for 16 ms");
  }

  oi::FirmwareQuirks quirks() const {
    oi::FirmwareQuirks known;
    known.mode_one_too_high = found.mode_one_too_high;
    return known;
  }

  bool listens() const { return params.session == OiRobot::Session::Listen; }

  OiRobot& session() {
    if (!robot) {
      if (listens()) wire.port().discard();  // of the stream that runs: it is to begin now
      robot.emplace(wire, model, quirks(), params.session);
    } else if (over) {
      robot->restart();
    }
    over = false;
    return *robot;
  }

  void welcome(const Frame& frame) {
    ++frames;
    silent = false;
    heard = frame.stamp;
    attempts = 0;
    reconnection.alive(frame.stamp);
  }

  /// A step on the way to the next frame; false if none will come.
  bool heal() {
    if (!silent) watchdog.rest();  // the robot is told to stand anyway
    silent = true;
    const bool closed = robot->link() == LinkState::Closed;
    const double now = wire.now();
    const Reconnection::Step step = reconnection.silent(now);
    if (step == Reconnection::Step::GiveUp || stop_asked.stop_requested()) return false;
    if (go_on && !go_on(now - heard)) return false;
    if (step == Reconnection::Step::Retry) {
      if (!closed || wire.reopen()) take_up();
    } else if (closed) {
      std::this_thread::sleep_for(kPatience);
    }
    return true;
  }

  /// Takes the session up with a silent robot. A byte that changed on the way may have become Power (133), which put it
  /// to sleep: it is woken once a silence, and not before the second attempt, since the first one ends most silences
  /// and nobody tells the robot to stand while its pin is pulled.
  void take_up() {
    ++attempts;
    if (attempts == 2 && !listens()) wire.pulse_wake();
    robot->restart();
  }

  /// Reads on until `reached` a frame, or `seconds` are over; `ask` is called now and then.
  template <typename Reached, typename Ask>
  bool read_until(double seconds, Reached reached, Ask ask) {
    const double end = wire.now() + seconds;
    double asked = -1.0;
    for (double now = wire.now(); now < end; now = wire.now()) {
      if (now - asked >= kHaltInterval) {
        asked = now;
        ask();
      }
      const auto frame = robot->next();
      if (frame) ++frames;
      if (reached(frame)) return true;
      if (!frame && robot->link() == LinkState::Closed) return false;
    }
    return false;
  }

  void stand() {
    int still = 0;
    const auto stands = [&](const std::optional<Frame>& frame) {
      if (frame) still = frame->left_travel == 0.0 && frame->right_travel == 0.0 ? still + 1 : 0;
      return still >= 3;
    };
    const bool hears = robot->link() == LinkState::Alive;
    read_until(hears ? kHaltsEnd : kHopelessEnd, stands, [this] { robot->halt(); });
    robot->stop();
    robot->confirm_stop(kPassiveEnd);
  }

  void end_session() {
    if (!robot || over) return;
    over = true;
    watchdog.rest();
    if (robot->link() == LinkState::Closed && wire.reopen()) robot->restart();
    if (!listens()) stand();
    // A Roomba 400 has no stream to end, and what ran before us isn't ours.
    const bool ours = model.protocol != oi::Model::Roomba400 && !(listens() && found.streamed_before);
    if (ours) {
      const auto pause_stream = [this] { wire.write(encode(oi::PauseResumeStream{oi::Bounded<0, 1>(0)})); };
      read_until(
          kQuietEnd, [this](const auto& frame) { return !frame && robot->link() == LinkState::Silent; }, pause_stream);
    }
  }

  SerialRobotParams params;
  std::stop_token stop_asked;
  SerialWire wire;
  FoundRobot found;
  RobotModel model;
  std::vector<std::string> remarks;
  std::optional<OiRobot> robot;  // from the first use on
  bool over = false;             // the session, until somebody wants another frame
  Reconnection reconnection;
  std::uint64_t frames = 0;
  bool silent = false;
  double heard = wire.now();                  // the last frame, or when it was found [s]
  std::function<bool(double silence)> go_on;  // to wait; may be nobody
  int attempts = 0;                           // to take the session up, since the last frame
  Watchdog watchdog;                          // the last member: its thread writes to the wire
};

SerialRobot::SerialRobot(const SerialAddress& address, const std::optional<RobotModel>& model, std::stop_token stop,
                         const SerialRobotParams& params)
    : state_(std::make_unique<State>(address, model, std::move(stop), params)) {}

SerialRobot::~SerialRobot() {
  try {
    state_->end_session();
  } catch (const std::exception&) {
    // The robot has been told what could be told.
  }
}

std::optional<Frame> SerialRobot::next() {
  OiRobot& robot = state_->session();
  while (true) {
    if (auto frame = robot.next()) {
      state_->welcome(*frame);
      return frame;
    }
    if (!state_->heal()) return std::nullopt;
  }
}

void SerialRobot::drive(const Motion& motion) {
  OiRobot& robot = state_->session();
  const auto tell = [&](bool was_stopped) {
    if (was_stopped) robot.halt();
    robot.drive(motion);
  };
  state_->watchdog.renew(tell);
  if (motion == Motion{}) state_->watchdog.rest();
}

bool SerialRobot::order(const oi::Command& command) {
  return state_->session().order(command);
}

void SerialRobot::stop() {
  state_->end_session();
}

void SerialRobot::while_silent(std::function<bool(double silence)> go_on) {
  state_->go_on = std::move(go_on);
}

void SerialRobot::record(std::unique_ptr<RecordingWriter> writer) {
  state_->wire.record(std::move(writer));
}

void SerialRobot::close_recording() {
  state_->wire.close_recording();
}

const RobotModel& SerialRobot::model() const {
  return state_->model;
}

oi::FirmwareQuirks SerialRobot::quirks() const {
  return state_->quirks();
}

const std::vector<std::string>& SerialRobot::remarks() const {
  return state_->remarks;
}

LinkReport SerialRobot::report() const {
  const Reconnection& reconnection = state_->reconnection;
  LinkReport report;
  report.frames = state_->frames;
  report.silences = reconnection.silences();
  report.reconnections = reconnection.reconnections();
  report.longest_silence = reconnection.longest_silence();
  if (state_->robot) {
    report.lost_frames = state_->robot->lost_frames();
    report.bad_bytes = state_->robot->counters().skipped;
  }
  report.watchdog_stops = state_->watchdog.stops();
  return report;
}

}  // namespace scrubjay
