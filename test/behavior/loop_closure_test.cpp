#include <gtest/gtest.h>

#include <scrubjay/behavior/loop_closure.hpp>

namespace scrubjay::test {
namespace {

/// Drives lines and turns on the spot in small steps, and counts how often the loop closes.
class Drive {
 public:
  explicit Drive(const LoopClosureParams& params = {}) : closure(params) { closure.begin(estimate); }

  Drive& forward(double distance) {
    constexpr double kStep = 0.01;
    for (double way = 0.0; way < distance - 0.5 * kStep; way += kStep) go({kStep, 0.0, 0.0});
    return *this;
  }
  Drive& turn(double angle) {
    constexpr int kSteps = 20;
    for (int i = 0; i < kSteps; ++i) go({0.0, 0.0, angle / kSteps});
    return *this;
  }
  /// Once around a square with sides of `side`, from the middle of one; left turns are positive.
  Drive& square(double side, double turn_angle) {
    forward(side / 2.0);
    for (int i = 0; i < 3; ++i) turn(turn_angle).forward(side);
    return turn(turn_angle).forward(side / 2.0);
  }

  PoseEstimate estimate;
  LoopClosure closure;
  int closed = 0;
  double first_at = 0.0;  // length at which it closed first

 private:
  void go(const Pose2& step) {
    estimate.pose = estimate.pose * step;
    if (!closure.update(estimate)) return;
    if (++closed == 1) first_at = closure.length();
    closure.begin(estimate);
  }
};

constexpr double kRightAngle = kPi / 2.0;

TEST(LoopClosureTest, ASquareClosesOnceWhicheverWayItIsDriven) {
  for (const double corner : {kRightAngle, -kRightAngle}) {
    Drive drive;
    drive.square(1.0, corner);
    EXPECT_EQ(drive.closed, 1);
    EXPECT_NEAR(drive.first_at, 4.0, 0.13) << "within the reach of its start";
  }
}

TEST(LoopClosureTest, ClosesOncePerRound) {
  Drive drive;
  for (int round = 0; round < 3; ++round) drive.square(1.0, kRightAngle);
  EXPECT_EQ(drive.closed, 3);
}

TEST(LoopClosureTest, BackAtTheStartWithoutAFullTurnClosesNothing) {
  Drive there_and_back;
  there_and_back.forward(1.0).turn(kPi).forward(1.0).turn(-kPi).forward(0.05);
  EXPECT_NEAR(there_and_back.estimate.pose.x, 0.05, 1e-9);
  EXPECT_EQ(there_and_back.closed, 0);

  // A figure of eight: one lobe turns left, the other as much to the right.
  Drive eight;
  eight.forward(0.5);
  for (int i = 0; i < 3; ++i) eight.turn(kRightAngle).forward(1.0);
  eight.turn(-kRightAngle).forward(1.0);
  for (int i = 0; i < 2; ++i) eight.turn(-kRightAngle).forward(1.0);
  EXPECT_EQ(eight.closed, 0);
}

TEST(LoopClosureTest, BackAtTheStartLookingElsewhereClosesNothing) {
  Drive drive;
  drive.forward(0.5);
  for (int i = 0; i < 3; ++i) drive.turn(kRightAngle).forward(1.0);
  drive.turn(0.3 * kPi).forward(0.5);  // cuts the last corner, so that it comes to the start askew
  EXPECT_EQ(drive.closed, 0);
}

TEST(LoopClosureTest, NothingShorterThanTheLeastLengthCloses) {
  Drive drive;
  drive.square(0.1, kRightAngle);
  EXPECT_EQ(drive.closed, 0);
  LoopClosureParams params;
  params.min_length = 0.2;
  Drive patient(params);
  patient.square(0.1, kRightAngle);
  EXPECT_EQ(patient.closed, 1);
}

/// A square whose last corner is `error` beside where the first one was.
Drive drifted_square(double error, double variance) {
  Drive drive;
  drive.forward(0.5).turn(kRightAngle).forward(1.0).turn(kRightAngle).forward(1.0).turn(kRightAngle);
  drive.estimate.covariance(0, 0) = drive.estimate.covariance(1, 1) = variance;
  drive.forward(1.0 + error).turn(kRightAngle).forward(0.6);
  return drive;
}

TEST(LoopClosureTest, UncertaintyGainedOnTheWayWidensTheReach) {
  EXPECT_EQ(drifted_square(0.3, 0.0).closed, 0);
  EXPECT_EQ(drifted_square(0.3, 0.01).closed, 1);  // 2 * sqrt(0.02) = 0.28 m more
}

TEST(LoopClosureTest, HoweverUncertainAnotherPlaceIsNotTheStart) {
  EXPECT_EQ(drifted_square(0.9, 4.0).closed, 0);
}

TEST(LoopClosureTest, UncertaintyAtTheStartDoesNotCount) {
  Drive drive;
  drive.estimate.covariance(0, 0) = drive.estimate.covariance(1, 1) = 0.01;
  drive.closure.begin(drive.estimate);
  drive.forward(0.5).turn(kRightAngle).forward(1.0).turn(kRightAngle).forward(1.0).turn(kRightAngle);
  drive.forward(1.3).turn(kRightAngle).forward(0.6);
  EXPECT_EQ(drive.closed, 0);
}

TEST(LoopClosureTest, GivesUpAfterSeveralTurnsWhenThePoseHasDrifted) {
  // A spiral whose rounds never come near the start again.
  Drive drive;
  for (int corner = 1; corner <= 11; ++corner) drive.forward(1.0 + 0.5 * corner).turn(kRightAngle);
  EXPECT_EQ(drive.closed, 0);
  drive.forward(1.0).turn(kRightAngle + 0.01);
  EXPECT_EQ(drive.closed, 1);
}

}  // namespace
}  // namespace scrubjay::test
