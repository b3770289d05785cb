/// \file
/// The whole loop for firmware: a Roomba's bytes in, a map and a motion out, over the caller's memory.
#pragma once

#include <scrubjay/behavior/behavior.hpp>
#include <scrubjay/grid/contact_model.hpp>
#include <scrubjay/odometry/odometry.hpp>
#include <scrubjay/robot/oi_robot.hpp>
#include <scrubjay/robot/reconnection.hpp>

namespace scrubjay {

/// What Mission is to a computer: frames from the robot, dead reckoning, the contact map, and a behavior that decides.
///
/// No heap, no clock, no waiting: each step takes what the channel has by then. Time is the stamps of its reads.
class EmbeddedMission {
 public:
  /// Wakes the robot and takes control of it. `channel`, the cells and `behavior` must outlive it. The map's frame
  /// begins at the robot's pose of now, (0, 0) with heading 0; what leaves the grid isn't mapped.
  EmbeddedMission(ByteChannel& channel, const RobotModel& robot, GridView<LogOdds> map, Behavior& behavior);

  /// Reads from the channel until a read completes no frame, takes each one through the loop, and sends the motion
  /// decided. Says how many frames there were. A robot that is silent is told to stand still, and its session is
  /// started anew, again and again until it answers: it may have been reset, or have had its battery out.
  int step();
  /// Stands still, and ends in a mode that charges. Steps go on to tell the pose, but map and decide no more.
  void stop();

  /// What the robot was told last.
  const Motion& motion() const { return motion_; }
  const PoseEstimate& estimate() const { return odometry_.estimate(); }
  GridView<const LogOdds> map() const { return map_; }
  /// The behavior has ended, or stop() was called.
  bool done() const { return done_; }
  LinkState link() const { return robot_.link(); }
  const OiRobot& robot() const { return robot_; }

 private:
  void heal();
  void take(const Frame& frame);
  void drive(const Motion& motion);

  OiRobot robot_;
  Reconnection reconnection_;
  Odometry odometry_;
  ContactModel model_;
  GridView<LogOdds> map_;
  Behavior& behavior_;
  Motion motion_;
  bool done_ = false;
};

}  // namespace scrubjay
