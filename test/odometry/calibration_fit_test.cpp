#include <gtest/gtest.h>

#include <cmath>
#include <scrubjay/geometry/random.hpp>
#include <scrubjay/odometry/calibration_fit.hpp>
#include <vector>

#include "odometry/drive.hpp"

namespace scrubjay {
namespace {

using Travel = std::vector<WheelTravel>;

/// What the encoders tell of a robot that rolls `way`, then turns by `turn`, as it believes.
void append_leg(Travel& travel, double way, double turn) {
  constexpr int kTicks = 100;
  const double half = 0.5 * kDrive.wheel_separation * turn / kTicks;
  travel.insert(travel.end(), kTicks, {way / kTicks, way / kTicks});
  travel.insert(travel.end(), kTicks, {-half, half});
}

Travel square(double side, double turn) {
  Travel travel;
  for (int i = 0; i < 4; ++i) append_leg(travel, side, turn);
  return travel;
}

Travel straight(double way) {
  Travel travel;
  append_leg(travel, way, 0.0);
  return travel;
}

Travel spin(double turns) {
  Travel travel;
  append_leg(travel, 0.0, 2.0 * kPi * turns);
  return travel;
}

EndOfDrive offset_of(const Travel& travel, const Calibration& truth) {
  return {end_of(travel, kDrive, truth).offset, {}, {}};
}
EndOfDrive distance_of(const Travel& travel, const Calibration& truth) {
  return {{}, end_of(travel, kDrive, truth).distance, {}};
}
EndOfDrive turn_of(const Travel& travel, const Calibration& truth) {
  return {{}, {}, end_of(travel, kDrive, truth).turn};
}

/// As far off as robots are that nobody has calibrated.
Calibration any_robot(Random& random) {
  const double scale = random.uniform(0.97, 1.03);
  return {scale * random.uniform(0.99, 1.01), scale * random.uniform(0.99, 1.01), random.uniform(0.83, 1.17)};
}

void expect_near(const Calibration& found, const Calibration& truth, double tolerance) {
  EXPECT_NEAR(found.left, truth.left, tolerance);
  EXPECT_NEAR(found.right, truth.right, tolerance);
  EXPECT_NEAR(found.axle, truth.axle, tolerance);
}

const Travel kLeft = square(1.0, 0.5 * kPi);
const Travel kRight = square(1.0, -0.5 * kPi);
const Travel kStraight = straight(2.0);
const Travel kSpin = spin(10.0);

TEST(CalibrationFitTest, AnEndIsWhereOdometryEnds) {
  Random random(3);
  Travel travel;
  for (int i = 0; i < 1000; ++i) travel.push_back({random.uniform(-0.01, 0.02), random.uniform(-0.01, 0.02)});
  Odometry odometry(kDrive);
  for (const WheelTravel& tick : travel) odometry.update(tick, 0.0);
  const EndOfDrive end = end_of(travel, kDrive, {});
  const Pose2 pose = odometry.estimate().pose;
  EXPECT_NEAR((*end.offset - pose.position()).norm(), 0.0, 1e-12);
  EXPECT_NEAR(angle_difference(*end.turn, pose.yaw), 0.0, 1e-12);
  EXPECT_NEAR(*end.distance, pose.position().norm(), 1e-12);
  EXPECT_NEAR(*end_of(kSpin, kDrive, {}).turn, 20.0 * kPi, 1e-9) << "whole turns count";
}

TEST(CalibrationFitTest, FindsAnyRobotsFactorsFromSquaresBothWaysAndAStraight) {
  Random random(4);
  for (int i = 0; i < 100; ++i) {
    const Calibration truth = any_robot(random);
    const MeasuredDrive drives[] = {{kLeft, offset_of(kLeft, truth)},
                                    {kRight, offset_of(kRight, truth)},
                                    {kStraight, distance_of(kStraight, truth)}};
    const auto fit = fit_calibration(drives, kDrive);
    ASSERT_TRUE(fit.has_value());
    expect_near(fit->calibration, truth, 1e-3);
  }
}

TEST(CalibrationFitTest, FindsTurnsFromFarOffWithoutAStraight) {
  Random random(6);
  constexpr int kRobots = 100;
  int found_from_afar = 0;
  for (int i = 0; i < kRobots; ++i) {
    const Calibration truth = any_robot(random);
    // The square was driven by what the spin told: seen with the model's factors it ends far away, and turned.
    const auto turns = [](const Calibration& factors) { return 2.0 * factors.axle / (factors.left + factors.right); };
    const Travel turned = spin(1.0);
    const Travel closed = square(1.0, 0.5 * kPi * turns(truth));
    const MeasuredDrive drives[] = {{turned, turn_of(turned, truth)}, {closed, offset_of(closed, truth)}};
    const auto spun = fit_calibration(std::span(drives).first(1), kDrive);
    ASSERT_TRUE(spun.has_value());
    const auto fit = fit_calibration(drives, kDrive, {}, spun->calibration);
    ASSERT_TRUE(fit.has_value()) << i;
    EXPECT_NEAR(turns(fit->calibration) / turns(truth), 1.0, 5e-3) << i;
    EXPECT_GT(fit->deviation.axle, 0.03) << "neither drive tells the wheels' scale";
    const auto afar = fit_calibration(drives, kDrive);
    if (afar && std::fabs(turns(afar->calibration) / turns(truth) - 1.0) < 5e-3) ++found_from_afar;
  }
  EXPECT_GE(found_from_afar, 95) << "without a start";
}

TEST(CalibrationFitTest, ASpinTellsTheAxleBetterThanSquares) {
  const Calibration truth{1.004, 0.996, 1.12};
  const MeasuredDrive drives[] = {{kLeft, offset_of(kLeft, truth)},
                                  {kRight, offset_of(kRight, truth)},
                                  {kStraight, distance_of(kStraight, truth)},
                                  {kSpin, turn_of(kSpin, truth)}};
  const auto squares = fit_calibration(std::span(drives).first(3), kDrive);
  const auto all = fit_calibration(drives, kDrive);
  ASSERT_TRUE(squares.has_value() && all.has_value());
  expect_near(all->calibration, truth, 2e-4);
  EXPECT_LT(all->deviation.axle, 0.75 * squares->deviation.axle);
}

TEST(CalibrationFitTest, WhatNoDriveTellsOfStaysAsItIsWithADeviationToShowForIt) {
  const CalibrationFitParams params;
  const auto none = fit_calibration({}, kDrive, params);
  ASSERT_TRUE(none.has_value());
  EXPECT_EQ(none->calibration, Calibration{});
  EXPECT_NEAR(none->deviation.axle, params.axle_error, 1e-12);

  const Calibration truth{1.01, 1.01, 1.05};
  const MeasuredDrive along[] = {{kStraight, distance_of(kStraight, truth)}};
  const auto fit = fit_calibration(along, kDrive, params);
  ASSERT_TRUE(fit.has_value());
  EXPECT_NEAR(0.5 * (fit->calibration.left + fit->calibration.right), 1.01, 1e-4);
  EXPECT_NEAR(fit->calibration.axle, 1.0, 1e-6);
  EXPECT_NEAR(fit->deviation.axle, params.axle_error, 1e-6);
  EXPECT_GT(fit->deviation.left, 0.008) << "one distance says nothing of the wheels' ratio";
}

TEST(CalibrationFitTest, ItsDeviationsAreThoseOfItsErrors) {
  const Calibration truth{0.995, 1.006, 0.93};
  const CalibrationFitParams params;
  Random random(5);
  constexpr int kTrials = 200;
  Eigen::Array3d squares = Eigen::Array3d::Zero();
  for (int i = 0; i < kTrials; ++i) {
    // Wheels that err as WheelNoise says: the truth rolls what the encoders tell, and a little beside it.
    const auto rolled = [&](Travel travel) {
      for (WheelTravel& tick : travel) {
        tick.left += std::sqrt(params.noise.left_variance_per_metre * std::fabs(tick.left)) * random.normal();
        tick.right += std::sqrt(params.noise.right_variance_per_metre * std::fabs(tick.right)) * random.normal();
      }
      return travel;
    };
    EndOfDrive left = offset_of(rolled(kLeft), truth);
    EndOfDrive right = offset_of(rolled(kRight), truth);
    EndOfDrive along = distance_of(rolled(kStraight), truth);
    for (EndOfDrive* end : {&left, &right}) *end->offset += params.ruler * Point2(random.normal(), random.normal());
    *along.distance += params.ruler * random.normal();
    const MeasuredDrive drives[] = {{kLeft, left}, {kRight, right}, {kStraight, along}};
    const auto fit = fit_calibration(drives, kDrive, params);
    ASSERT_TRUE(fit.has_value());
    const Calibration& found = fit->calibration;
    squares += (Eigen::Array3d(found.left - truth.left, found.right - truth.right, found.axle - truth.axle) /
                Eigen::Array3d(fit->deviation.left, fit->deviation.right, fit->deviation.axle))
                   .square();
  }
  for (const double sum : squares) {
    EXPECT_GT(sum / kTrials, 0.6);
    EXPECT_LT(sum / kTrials, 1.4);
  }
}

TEST(CalibrationFitTest, RefusesWhatNoWheelsCanHaveDone) {
  const MeasuredDrive drives[] = {{kStraight, {{}, 2000.0, {}}}};
  EXPECT_FALSE(fit_calibration(drives, kDrive).has_value());
  const MeasuredDrive nowhere[] = {{kStraight, {{}, std::nan(""), {}}}};
  EXPECT_FALSE(fit_calibration(nowhere, kDrive).has_value());
}

}  // namespace
}  // namespace scrubjay
