/// \file
/// A scenario with a real robot, and the mission that it drives.
#pragma once

#include <filesystem>
#include <optional>
#include <scrubjay/io/run_files.hpp>
#include <scrubjay/io/serial_robot.hpp>
#include <scrubjay/mission/scenario.hpp>
#include <stop_token>

namespace scrubjay::apps {

class Publishing;
class Steering;

/// Connects to the robot at `address`. `model` is the one that is expected; without it, the one that comes with the
/// dialect that the robot speaks. Says on stderr what there is to say, unless `quiet`. Throws Error.
class LiveRobot {
 public:
  LiveRobot(const SerialAddress& address, const std::optional<std::string>& model, OiRobot::Session session,
            const std::stop_token& stop, bool quiet);

  SerialRobot& robot() { return robot_; }
  /// Name of the model, or its URDF file.
  const std::string& model_name() const { return model_name_; }
  /// Enters what answered into `scenario`, so that a replay hears the same: model, dialect and quirks; and the factors
  /// of a calibration file, if one is named. Throws Error if those are another model's.
  void enter(Scenario& scenario, const std::optional<std::string>& calibration_file) const;

 private:
  SerialRobot robot_;
  std::string model_name_;
};

struct LiveOptions {
  std::optional<std::filesystem::path> record;  ///< where to record the bytes
  Observer* onlooker = nullptr;                 ///< somebody who looks on; may be nobody
  Publishing* publishing = nullptr;             ///< tells others; may be nobody
  Steering* steering = nullptr;                 ///< in place of the scenario's strategy, if anybody
};

/// Runs the scenario on the robot, which stands afterwards and may charge. The recording is left to be closed by
/// SerialRobot::close_recording(), which may throw: nobody loses a map because its recording failed.
RunResult run_live(const Scenario& scenario, SerialRobot& robot, const LiveOptions& options,
                   const std::stop_token& stop);

}  // namespace scrubjay::apps
