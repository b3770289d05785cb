/// \file
/// A robot whose wheels and axle are known, as one that is just as its model.
#pragma once

#include <scrubjay/odometry/calibration.hpp>
#include <scrubjay/robot/robot.hpp>

namespace scrubjay {

/// Frames tell the travel that the model's wheels would have made, and motions come out as they were wanted: everyone
/// else can go on believing the model. A robot that tells its own odometry instead of travel is left as it is.
class CalibratedRobot final : public Robot {
 public:
  /// The robot must outlive this.
  CalibratedRobot(Robot& robot, const Calibration& calibration, const DifferentialDrive& drive)
      : robot_(robot), calibration_(calibration), separation_(drive.wheel_separation) {}

  std::optional<Frame> next() override {
    std::optional<Frame> frame = robot_.next();
    if (frame) {
      const WheelTravel travel = calibrated({frame->left_travel, frame->right_travel}, calibration_);
      frame->left_travel = travel.left;
      frame->right_travel = travel.right;
    }
    return frame;
  }

  void drive(const Motion& motion) override {
    const double half = 0.5 * separation_ * motion.angular;
    const WheelTravel told = uncalibrated({motion.linear - half, motion.linear + half}, calibration_);
    robot_.drive({0.5 * (told.left + told.right), (told.right - told.left) / separation_});
  }

  bool order(const oi::Command& command) override { return robot_.order(command); }
  void stop() override { robot_.stop(); }

 private:
  Robot& robot_;
  Calibration calibration_;
  double separation_;
};

}  // namespace scrubjay
