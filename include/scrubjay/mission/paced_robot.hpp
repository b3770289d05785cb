/// \file
/// A simulated or recorded robot at the speed of the wall clock.
#pragma once

#include <chrono>
#include <scrubjay/robot/robot.hpp>
#include <thread>

namespace scrubjay {

/// Holds each frame back until its time has come.
class PacedRobot final : public Robot {
 public:
  /// `speed`: seconds of the robot per second of the clock, > 0. The robot must outlive this.
  PacedRobot(Robot& robot, double speed) : robot_(robot), speed_(speed) {}

  std::optional<Frame> next() override {
    std::optional<Frame> frame = robot_.next();
    if (frame) {
      const double first = first_stamp_.value_or(frame->stamp);
      first_stamp_ = first;
      std::this_thread::sleep_until(begin_ + std::chrono::duration_cast<Clock::duration>(
                                                 std::chrono::duration<double>((frame->stamp - first) / speed_)));
    }
    return frame;
  }
  void drive(const Motion& motion) override { robot_.drive(motion); }
  bool order(const oi::Command& command) override { return robot_.order(command); }
  void stop() override { robot_.stop(); }

 private:
  using Clock = std::chrono::steady_clock;

  Robot& robot_;
  double speed_;
  Clock::time_point begin_ = Clock::now();
  std::optional<double> first_stamp_;
};

}  // namespace scrubjay
