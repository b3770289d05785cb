/// \file
/// What the driver of a robot sees.
#pragma once

#include <scrubjay/io/key_drive.hpp>
#include <scrubjay/robot/robot_model.hpp>
#include <string>
#include <vector>

namespace scrubjay::apps {

/// Adds up what the robot did, and puts it beside what it senses.
class DriveDisplay {
 public:
  explicit DriveDisplay(const RobotModel& model) : model_(model) {}

  /// To be told of every frame.
  void take(const Frame& frame);
  /// Lines of 79 columns at most, without their ends.
  std::vector<std::string> lines(const Frame& frame, const Motion& motion, const KeyDriver& driver) const;
  /// The same while no frame comes, for so long by now [s].
  static std::vector<std::string> lines_of_silence(double silence);
  double driven() const { return driven_; }  ///< whichever way [m]

 private:
  RobotModel model_;
  double driven_ = 0.0;
  double heading_ = 0.0;                // since the start [rad]
  double mean_interval_ = 0.0;          // between frames [s]; a running mean
  std::optional<double> last_stamp_;    // [s]
  std::optional<Pose2> last_odometry_;  // of a robot that tells it
  std::optional<float> nearest_;        // of the last scan [m]
};

}  // namespace scrubjay::apps
