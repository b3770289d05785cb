/// \file
/// A robot that is told what others order, between its frames.
#pragma once

#include <scrubjay/robot/robot.hpp>
#include <scrubjay/ros2/commands.hpp>

namespace scrubjay::ros {

/// One order a frame: however many there are, they leave most of a slow wire to the wheels.
class OrderedRobot final : public Robot {
 public:
  /// Both must outlive it.
  OrderedRobot(Robot& robot, Commands& commands) : robot_(robot), commands_(commands) {}

  std::optional<Frame> next() override {
    if (const auto command = commands_.next_order()) robot_.order(*command);
    return robot_.next();
  }
  void drive(const Motion& motion) override { robot_.drive(motion); }
  bool order(const oi::Command& command) override { return robot_.order(command); }
  void stop() override { robot_.stop(); }

 private:
  Robot& robot_;
  Commands& commands_;
};

}  // namespace scrubjay::ros
