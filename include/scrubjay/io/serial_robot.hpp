/// \file
/// A Roomba on a serial port, with a link that may break and heal.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <scrubjay/io/recording.hpp>
#include <scrubjay/io/serial_port.hpp>
#include <scrubjay/robot/oi_robot.hpp>
#include <stop_token>
#include <string>
#include <vector>

namespace scrubjay {

/// How the link fared.
struct LinkReport {
  std::uint64_t frames = 0;          ///< whole ones
  std::uint64_t lost_frames = 0;     ///< by the time between those that came, that of silences too; or lost replies
  std::uint64_t bad_bytes = 0;       ///< that belonged to no whole frame
  std::uint64_t silences = 0;        ///< times that no frame came for OiRobot::kSilence
  std::uint64_t reconnections = 0;   ///< ... and one came again
  double longest_silence = 0.0;      ///< [s]
  std::uint64_t watchdog_stops = 0;  ///< motions that weren't renewed in time

  bool operator==(const LinkReport&) const = default;
};

struct SerialRobotParams {
  double connect_timeout = 2.0;  ///< to find a robot, and its model [s]
  double renewal = 0.2;          ///< a motion that isn't renewed within this is stopped [s]
  double first_retry = 0.1;      ///< pause behind the first attempt to reconnect [s]; doubles each time ...
  double longest_retry = 2.0;    ///< ... up to this
  double give_up = 60.0;         ///< without a frame for this long, the robot is gone [s]
  /// One that listens takes no control, and leaves the robot in its mode, with the stream that ran before. It sends
  /// nothing where a stream of all packets runs, as long as no silence breaks it; else it asks for that stream, in
  /// place of another one. A robot that answers nothing without Start (Off, asleep) is woken and started when it is
  /// sought, and never later; and at a wrong rate bytes may mean anything to a robot: the address should name the right
  /// one.
  OiRobot::Session session = OiRobot::Session::Drive;
  /// The body that goes with a dialect, where no model is expected; none: RobotModel's defaults.
  std::function<RobotModel(oi::Model)> body = nullptr;
};

/// Finds the robot on a port: opens it, wakes the robot, tries the model's rate and dialect first, then those of the
/// others. What it found is in model(), and said by remarks(). While a mission runs, next() heals the link by itself,
/// waking the robot once a silence, and a thread of its own stops a motion that isn't renewed. Destroyed, it tells the
/// robot to stop and leaves it in a mode that charges.
///
/// All calls from one thread.
class SerialRobot final : public Robot {
 public:
  /// `model`: the one that is expected, or none. Throws Error within SerialRobotParams::connect_timeout: what is wrong,
  /// and what to try.
  SerialRobot(const SerialAddress& address, const std::optional<RobotModel>& model, std::stop_token stop,
              const SerialRobotParams& params = {});
  ~SerialRobot() override;

  /// Blocks until a frame comes; the first call begins the session. None once the robot is gone for good, or somebody
  /// asks to stop while it is silent.
  std::optional<Frame> next() override;
  /// For SerialRobotParams::renewal, unless it is told again.
  void drive(const Motion& motion) override;
  bool order(const oi::Command& command) override;
  /// Tells the robot to stand until its frames say that it does, or for 1.5 s; then leaves it in Passive mode, without
  /// a stream. next() begins a new session.
  void stop() override;

  /// Has next() call `go_on` about every 20 ms while the robot is silent, and say for how long it has been [s]; if that
  /// gives false, next() waits no longer and gives none.
  void while_silent(std::function<bool(double silence)> go_on);

  /// Records all bytes from now on: to be told before the session begins, so that a replay sees all of it.
  void record(std::unique_ptr<RecordingWriter> writer);
  /// Closes the recording, if there is one. Throws Error if not all of it could be written.
  void close_recording();

  const RobotModel& model() const;
  /// Of its firmware, as far as they were found out.
  oi::FirmwareQuirks quirks() const;
  /// What a user should know of the connection, a sentence each; such as that another model was found.
  const std::vector<std::string>& remarks() const;
  LinkReport report() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace scrubjay
