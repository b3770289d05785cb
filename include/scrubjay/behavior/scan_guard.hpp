/// \file
/// Keeps a robot with a lidar from driving into what its last scan shows, whatever its plan is.
#pragma once

#include <scrubjay/robot/frame.hpp>
#include <scrubjay/robot/motion.hpp>
#include <scrubjay/robot/robot_model.hpp>

namespace scrubjay {

/// Our own choice: a plan that keeps its distances is never slowed down.
struct ScanGuardParams {
  double margin = 0.01;   ///< stands this far from what is in the way [m]
  double reaction = 0.3;  ///< slow enough to get there in no less: a turn of the lidar, and time to stop [s]
  double graze = 0.05;    ///< a share of the radius: what would touch this little of the side is the plan's affair
};

/// How far a disc of `radius` around the robot's origin can go straight forwards, or backwards, until it touches a
/// point of the scan; negative where one is inside of it, `at_most` if that is less [m]. `mount`: sensor on the robot.
double clear_way(const LaserScan& scan, const Pose2& mount, double radius, bool backwards, double at_most);

/// Limits the speed towards what is near. Turning on the spot is always allowed: a disc can.
class ScanGuard {
 public:
  /// A robot without a lidar is never limited.
  explicit ScanGuard(const RobotModel& robot, const ScanGuardParams& params = {});

  /// Every frame, with or without a scan: between scans, the way driven counts.
  void sense(const Frame& frame);
  /// The motion, slowed down or stopped.
  Motion limit(const Motion& wanted) const;

 private:
  Pose2 mount_;
  double disc_, front_, sight_, reaction_;  // the disc that meets things; the way from its front to the margin's [m]
  double ahead_, behind_;                   // clear as of now [m]
  double travel_ = 0.0;                     // since the last scan, forwards [m]
};

}  // namespace scrubjay
