#include <gtest/gtest.h>

#include <cmath>
#include <scrubjay/error.hpp>
#include <scrubjay/localization/localizer.hpp>
#include <scrubjay/mission/calibration_session.hpp>
#include <scrubjay/robot/calibrated_robot.hpp>
#include <scrubjay/robot/oi_robot.hpp>
#include <scrubjay/simulation/simulated_roomba.hpp>

#include "stage.hpp"
#include "wire.hpp"

namespace scrubjay::test {
namespace {

using Figures = std::vector<CalibrationFigure>;

const Figures kAll{CalibrationFigure::Spin, CalibrationFigure::Straight, CalibrationFigure::SquareLeft,
                   CalibrationFigure::SquareRight, CalibrationFigure::Spin};

/// A robot that nobody has calibrated, on a floor that takes its share; it errs by nothing else.
sim::NoiseProfile uncalibrated_robot() {
  sim::NoiseProfile noise;
  noise.wheel_mismatch = {0.005, 0.01};
  noise.separation_error = {0.10, 0.17};
  noise.distance_error = 0.01;
  noise.grip = {0.95, 1.0};
  return noise;
}

/// A robot that is carried back to its start, and measured by the truth.
class Calibrator {
 public:
  explicit Calibrator(const sim::NoiseProfile& noise, std::uint64_t seed = 1, oi::Model protocol = oi::Model::Create2,
                      World scenery = {})
      : world_(std::move(scenery)),
        index_(solid_segments(world_)),
        spec_(speaking(protocol)),
        roomba_(world_, index_, spec_, noise, Random(seed), start_),
        // A body draws its errors from the first of its robot's streams.
        errors_(sim::draw_errors(noise, 0, Random(seed).fork(0))),
        session(spec_.model) {}

  void drive(CalibrationFigure figure) {
    const EndOfDrive plan = session.plan(figure);
    roomba_.place(start_);
    OiRobot robot(roomba_, spec_.model);
    session.drive(robot, figure, {});
    const Pose2 end = inverse(start_) * roomba_.truth().pose;
    if (plan.turn) {
      session.measure({{}, {}, *plan.turn + angle_difference(end.yaw, *plan.turn)});
    } else if (plan.distance) {
      session.measure({{}, end.position().norm(), {}});
    } else {
      session.measure({end.position(), {}, {}});
    }
  }

  /// How far off the robot is, in the end, after a tour of some 17 m with many turns.
  struct Off {
    double distance = 0.0;  ///< [m]
    double heading = 0.0;   ///< [rad]
  };
  Off tour(const Calibration& calibration) {
    roomba_.place(start_);
    OiRobot robot(roomba_, spec_.model);
    CalibratedRobot calibrated(robot, calibration, spec_.model.drive);
    DeadReckoning odometry(spec_.model.drive);
    const auto drive = [&](const Motion& motion, double seconds) {
      for (int i = ticks_in(seconds); i > 0; --i) {
        const auto frame = calibrated.next();
        if (frame) odometry.update(*frame);
        calibrated.drive(motion);
      }
    };
    for (int leg = 0; leg < 20; ++leg) {
      drive({0.2, 0.1}, 4.0);
      drive({0.0, leg % 4 == 3 ? -0.6 : 0.6}, 3.0);
    }
    drive({}, 1.0);
    const Pose2 truth = inverse(start_) * roomba_.truth().pose;
    const auto frame = calibrated.next();
    const Pose2 believed = odometry.update(*frame).pose;
    return {(believed.position() - truth.position()).norm(), std::fabs(angle_difference(believed.yaw, truth.yaw))};
  }

  const Calibration& found() const { return session.fit().calibration; }
  Calibration truth() const { return {errors_.left_scale, errors_.right_scale, errors_.separation_scale}; }

 private:
  Pose2 start_{1.0, 2.0, 0.5};
  World world_;
  SegmentIndex index_;
  sim::RobotSpec spec_;
  sim::SimulatedRoomba roomba_;
  sim::SystematicErrors errors_;

 public:
  CalibrationSession session;
};

void expect_near(const Calibration& found, const Calibration& truth, double share) {
  EXPECT_NEAR(found.left / truth.left, 1.0, share);
  EXPECT_NEAR(found.right / truth.right, 1.0, share);
  EXPECT_NEAR(found.axle / truth.axle, 1.0, share);
}

TEST(CalibrationDriveTest, FindsTheFactorsOfTwentyRobotsWithinThreePerMille) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Calibrator calibrator(uncalibrated_robot(), seed);
    for (const CalibrationFigure figure : kAll) calibrator.drive(figure);
    SCOPED_TRACE(seed);
    expect_near(calibrator.found(), calibrator.truth(), 0.003);
  }
}

TEST(CalibrationDriveTest, SoItDoesForRobotsWithoutEncoders) {
  for (const oi::Model protocol : {oi::Model::Create1, oi::Model::Roomba400}) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      Calibrator calibrator(uncalibrated_robot(), seed, protocol);
      for (const CalibrationFigure figure : kAll) calibrator.drive(figure);
      SCOPED_TRACE(seed);
      expect_near(calibrator.found(), calibrator.truth(), 0.003);
    }
  }
}

TEST(CalibrationDriveTest, AnExactRobotIsFoundToBeOne) {
  Calibrator calibrator({});
  for (const CalibrationFigure figure : kAll) calibrator.drive(figure);
  expect_near(calibrator.found(), {}, 0.0005);
}

TEST(CalibrationDriveTest, AnyDrivesWillDoForWhatTheyTell) {
  using enum CalibrationFigure;
  for (const Figures& figures : {Figures{Spin, SquareLeft}, Figures{SquareLeft, SquareRight}, Figures{SquareRight}}) {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      Calibrator calibrator(uncalibrated_robot(), seed);
      for (const CalibrationFigure figure : figures) calibrator.drive(figure);
      // How far a turn is, which doesn't take the wheels' scale to know.
      const auto turns = [](const Calibration& factors) { return factors.axle / (factors.left + factors.right); };
      SCOPED_TRACE(seed);
      EXPECT_NEAR(turns(calibrator.found()) / turns(calibrator.truth()), 1.0, figures.size() == 1 ? 0.04 : 0.015);
    }
  }
}

TEST(CalibrationDriveTest, SpinsOnlyAsOftenAsTurnsCanBeToldApart) {
  Calibrator calibrator(uncalibrated_robot());
  EXPECT_DOUBLE_EQ(*calibrator.session.plan(CalibrationFigure::Spin).turn, 2.0 * kPi);
  calibrator.drive(CalibrationFigure::Spin);
  EXPECT_GT(*calibrator.session.plan(CalibrationFigure::Spin).turn, 4.0 * kPi);
}

TEST(CalibrationDriveTest, LaterDrivesCloseBetterThanTheFirst) {
  Calibrator calibrator(uncalibrated_robot());
  calibrator.drive(CalibrationFigure::SquareLeft);
  calibrator.drive(CalibrationFigure::SquareLeft);
  const std::vector<CalibrationDrive> drives = calibrator.session.drives();
  ASSERT_EQ(drives.size(), 2u);
  EXPECT_GT(std::hypot(drives[0].measured[0], drives[0].measured[1]), 0.2);
  EXPECT_LT(std::hypot(drives[1].measured[0], drives[1].measured[1]), 0.05);
  EXPECT_LT(std::hypot(drives[1].residual[0], drives[1].residual[1]), 0.01);
}

TEST(CalibrationDriveTest, SaysWhatStoodInTheWay) {
  Calibrator calibrator({}, 1, oi::Model::Create2, with_walls({facing({1.0, 2.0}, 0.5, 0.7, 1.0)}));
  EXPECT_THROW(calibrator.drive(CalibrationFigure::SquareLeft), Error);
  EXPECT_TRUE(calibrator.session.drives().empty());
}

TEST(CalibrationDriveTest, ACalibratedRobotEndsWhereItBelievesToEnd) {
  Calibrator calibrator(uncalibrated_robot(), 3);
  for (const CalibrationFigure figure : kAll) calibrator.drive(figure);

  const Calibrator::Off before = calibrator.tour({});
  const Calibrator::Off after = calibrator.tour(calibrator.found());
  EXPECT_GT(before.distance, 0.3);
  EXPECT_LT(after.distance, 0.02);
  EXPECT_LT(after.heading, radians(2.0));
}

}  // namespace
}  // namespace scrubjay::test
