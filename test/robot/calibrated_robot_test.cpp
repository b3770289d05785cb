#include <gtest/gtest.h>

#include <scrubjay/robot/calibrated_robot.hpp>

namespace scrubjay {
namespace {

const DifferentialDrive kBelieved;

/// Wheels that are off, and an encoder on each: moves as its motors are told, and tells what they turned.
class OffRobot final : public Robot {
 public:
  explicit OffRobot(const Calibration& truth) : truth_(truth) {}

  std::optional<Frame> next() override {
    if (gone) return std::nullopt;
    const double half = 0.5 * kBelieved.wheel_separation * told.angular;
    Frame frame;
    frame.bump_left = true;
    frame.left_travel = told.linear - half;
    frame.right_travel = told.linear + half;
    const double left = truth_.left * frame.left_travel;
    const double right = truth_.right * frame.right_travel;
    made = {0.5 * (left + right), (right - left) / (kBelieved.wheel_separation * truth_.axle)};
    return frame;
  }
  void drive(const Motion& motion) override { told = motion; }
  void stop() override { stopped = true; }

  Motion told;  // what it was told
  Motion made;  // what it really did, in the second of a frame
  bool stopped = false;
  bool gone = false;

 private:
  Calibration truth_;
};

TEST(CalibratedRobotTest, MovesAsItIsToldAndTellsHowItMoved) {
  const Calibration truth{1.02, 0.97, 1.15};
  OffRobot off(truth);
  CalibratedRobot robot(off, truth, kBelieved);
  for (const Motion& motion : {Motion{0.2, 0.0}, Motion{0.0, 1.0}, Motion{-0.1, 0.4}}) {
    robot.drive(motion);
    const auto frame = robot.next();
    ASSERT_TRUE(frame.has_value());
    EXPECT_NEAR(off.made.linear, motion.linear, 1e-12);
    EXPECT_NEAR(off.made.angular, motion.angular, 1e-12);
    EXPECT_NEAR(0.5 * (frame->left_travel + frame->right_travel), motion.linear, 1e-12);
    EXPECT_NEAR((frame->right_travel - frame->left_travel) / kBelieved.wheel_separation, motion.angular, 1e-12);
    EXPECT_TRUE(frame->bump_left) << "all else is as it was";
  }
}

TEST(CalibratedRobotTest, StopsAndEndsWithTheRobot) {
  OffRobot off({});
  CalibratedRobot robot(off, {1.1, 1.1, 0.9}, kBelieved);
  robot.stop();
  EXPECT_TRUE(off.stopped);
  off.gone = true;
  EXPECT_FALSE(robot.next().has_value());
}

}  // namespace
}  // namespace scrubjay
