/// \file
/// The loop: one robot, one localizer, one mapper, one behavior, and those who watch.
#pragma once

#include <optional>
#include <scrubjay/behavior/behavior.hpp>
#include <scrubjay/localization/localizer.hpp>
#include <scrubjay/mapping/mapper.hpp>
#include <scrubjay/mapping/stuck_detector.hpp>
#include <scrubjay/mission/observer.hpp>
#include <scrubjay/robot/robot.hpp>
#include <stop_token>
#include <string_view>
#include <vector>

namespace scrubjay {

struct Limits {
  double max_time = 3600.0;  ///< [s]
};

/// Why a mission ended. The last one is of a replay that would have gone on.
enum class Ended : std::uint8_t { Done, TimeLimit, Stopped, Stuck, RobotGone, EndOfRecording };

/// "done", "time limit", "stopped", "stuck", "robot gone", "end of the recording".
std::string_view to_string(Ended ended);

struct Report {
  Ended ended = Ended::RobotGone;
  std::uint64_t frames = 0;         ///< that it took from the robot
  double time = 0.0;                ///< from the first frame to the last [s]
  double distance = 0.0;            ///< driven, by the wheels or the robot's own odometry [m]
  std::uint64_t bumps = 0;          ///< times that the bumper closed
  Pose2 pose;                       ///< where the robot thinks that it is
  std::optional<Point2> stuck;      ///< where it can't free itself
  std::vector<Leftover> leftovers;  ///< what the behavior would have gone to, and hasn't
};

/// Runs until the behavior is done, a limit is reached, the robot is gone or stuck, or somebody asks it to stop. The
/// robot stands afterwards.
class Mission {
 public:
  /// All of them must outlive it.
  Mission(Robot& robot, Localizer& localizer, Mapper& mapper, Behavior& behavior, const Limits& limits)
      : robot_(robot), localizer_(localizer), mapper_(mapper), behavior_(behavior), limits_(limits) {}

  void watch(Observer& observer) { observers_.push_back(&observer); }
  Report run(std::stop_token stop);

 private:
  std::optional<Ended> ended(const Frame& frame, const PoseEstimate& estimate, const Decision& decision,
                             const std::stop_token& stop);
  void count(const Frame& frame, const PoseEstimate& estimate);

  Robot& robot_;
  Localizer& localizer_;
  Mapper& mapper_;
  Behavior& behavior_;
  Limits limits_;
  StuckDetector stuck_;
  std::vector<Observer*> observers_;
  Report report_;
  std::optional<double> first_stamp_;
  std::optional<Pose2> last_odometry_;
  bool was_bumped_ = false;
};

}  // namespace scrubjay
