/// \file
/// A robot whose frames come from a CARMEN log.
#pragma once

#include <scrubjay/io/carmen_log.hpp>
#include <scrubjay/robot/robot.hpp>

namespace scrubjay {

/// A frame a record: odometry always, and a scan where one was taken. It goes where it went, whatever it is told.
class CarmenRobot final : public Robot {
 public:
  /// `log` must outlive it, and the frames' scans.
  explicit CarmenRobot(const CarmenLog& log) : log_(log) {}

  std::optional<Frame> next() override;
  void drive(const Motion&) override {}
  void stop() override {}

 private:
  const CarmenLog& log_;
  std::size_t next_ = 0;
};

/// What is known of the robot that made a log: its lidar, and `radius` [m], which no log tells.
RobotModel robot_of(const CarmenLog& log, double radius);

}  // namespace scrubjay
