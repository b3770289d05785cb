#include <gtest/gtest.h>

#include <scrubjay/geometry/random.hpp>
#include <scrubjay/odometry/calibration.hpp>

namespace scrubjay {
namespace {

Calibration any_calibration(Random& random) {
  return {random.uniform(0.9, 1.1), random.uniform(0.9, 1.1), random.uniform(0.8, 1.2)};
}

WheelTravel any_travel(Random& random) {
  return {random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1)};
}

TEST(CalibrationTest, ChangesNothingWhenTheModelIsRight) {
  const WheelTravel travel = calibrated({0.12, -0.03}, {});
  EXPECT_NEAR(travel.left, 0.12, 1e-16);
  EXPECT_NEAR(travel.right, -0.03, 1e-16);
}

TEST(CalibrationTest, GivesTheModelTheArcThatTheTrueWheelsDrive) {
  const DifferentialDrive model;
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Calibration calibration = any_calibration(random);
    const WheelTravel told = any_travel(random);
    DifferentialDrive own = model;
    own.wheel_separation *= calibration.axle;
    const Pose2 truth = arc_motion({calibration.left * told.left, calibration.right * told.right}, own);
    const Pose2 believed = arc_motion(calibrated(told, calibration), model);
    EXPECT_NEAR((truth.position() - believed.position()).norm(), 0.0, 1e-15);
    EXPECT_NEAR(truth.yaw, believed.yaw, 1e-14);
  }
}

TEST(CalibrationTest, CanBeTakenBack) {
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const Calibration calibration = any_calibration(random);
    const WheelTravel told = any_travel(random);
    const WheelTravel back = uncalibrated(calibrated(told, calibration), calibration);
    EXPECT_NEAR(back.left, told.left, 1e-16);
    EXPECT_NEAR(back.right, told.right, 1e-16);
  }
}

}  // namespace
}  // namespace scrubjay
