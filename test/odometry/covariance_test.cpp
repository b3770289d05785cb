#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <scrubjay/geometry/random.hpp>
#include <scrubjay/odometry/arc.hpp>
#include <scrubjay/odometry/odometry.hpp>
#include <vector>

#include "odometry/drive.hpp"

namespace scrubjay {
namespace {

using Ticks = std::vector<WheelTravel>;

/// Adds a leg of `length` [m] and `turn` [rad] in equal ticks.
void add_leg(Ticks& ticks, double length, double turn, int count) {
  const double half = 0.5 * kDrive.wheel_separation * turn;
  ticks.insert(ticks.end(), static_cast<std::size_t>(count), {(length - half) / count, (length + half) / count});
}

Eigen::Matrix3d predicted(const Ticks& ticks, const WheelNoise& noise) {
  Odometry odometry(kDrive, noise);
  double stamp = 0.0;
  for (const WheelTravel& tick : ticks) odometry.update(tick, stamp += 0.015);
  return odometry.estimate().covariance;
}

/// Covariance of where `drives` robots end whose wheels err as the noise model says, each tick for itself.
Eigen::Matrix3d sampled(const Ticks& ticks, const WheelNoise& noise, int drives) {
  Random random(1);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  for (int drive = 0; drive < drives; ++drive) {
    Eigen::Vector3d pose = Eigen::Vector3d::Zero();
    for (const WheelTravel& tick : ticks) {
      const double left = tick.left + std::sqrt(noise.left_variance_per_metre * std::fabs(tick.left)) * random.normal();
      const double right =
          tick.right + std::sqrt(noise.right_variance_per_metre * std::fabs(tick.right)) * random.normal();
      const double turn = (right - left) / kDrive.wheel_separation;
      const double middle = pose(2) + 0.5 * turn;
      pose += Eigen::Vector3d(0.5 * (left + right) * std::cos(middle), 0.5 * (left + right) * std::sin(middle), turn);
    }
    sum += pose;
    squares += pose * pose.transpose();
  }
  const Eigen::Vector3d mean = sum / drives;
  return squares / drives - mean * mean.transpose();
}

void expect_within_ten_percent(const Ticks& ticks, const WheelNoise& noise) {
  const Eigen::Matrix3d p = predicted(ticks, noise);
  const Eigen::Matrix3d s = sampled(ticks, noise, 10000);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      // Terms much smaller than their standard deviations' product can't be sampled to 10 %.
      ASSERT_GT(std::fabs(p(i, j)), 0.3 * std::sqrt(p(i, i) * p(j, j))) << "choose another path";
      EXPECT_NEAR(p(i, j) / s(i, j), 1.0, 0.1) << "element " << i << ", " << j;
    }
  }
}

/// Forward, a left bend, forward, a spin to the right, forward.
Ticks room_drive() {
  Ticks ticks;
  add_leg(ticks, 1.0, 0.0, 60);
  add_leg(ticks, 0.5, radians(60.0), 40);
  add_leg(ticks, 1.0, 0.0, 60);
  add_leg(ticks, 0.0, radians(-30.0), 20);
  add_leg(ticks, 0.5, 0.0, 40);
  return ticks;
}

TEST(OdometryCovarianceTest, MatchesTenThousandSimulatedDrives) {
  expect_within_ten_percent(room_drive(), {});
}

TEST(OdometryCovarianceTest, MatchesTenThousandDrivesWithOneWheelWorseThanTheOther) {
  expect_within_ten_percent(room_drive(), {1e-5, 2e-6});
  expect_within_ten_percent(room_drive(), {1e-6, 8e-6});
}

TEST(OdometryCovarianceTest, MatchesTenThousandDrivesThatReverse) {
  Ticks ticks;
  add_leg(ticks, 0.8, radians(45.0), 60);
  add_leg(ticks, -0.5, radians(20.0), 40);
  add_leg(ticks, 1.2, 0.0, 80);
  expect_within_ten_percent(ticks, {1e-5, 5e-6});
}

TEST(OdometryCovarianceTest, IsRightByHandAfterAStraight) {
  const WheelNoise noise{2e-6, 3e-6};
  Ticks ticks;
  add_leg(ticks, 2.0, 0.0, 2000);
  const Eigen::Matrix3d p = predicted(ticks, noise);
  const double per_metre = 5e-6 / (kDrive.wheel_separation * kDrive.wheel_separation);
  EXPECT_NEAR(p(0, 0), 5e-6 / 4 * 2.0, 1e-12);
  EXPECT_NEAR(p(2, 2), per_metre * 2.0, 1e-12);
  EXPECT_NEAR(p(1, 2), per_metre * 2.0, 1e-10);      // integral of the way still to go: L^2 / 2
  EXPECT_NEAR(p(1, 1), per_metre * 8.0 / 3, 1e-10);  // of its square: L^3 / 3
  EXPECT_NEAR(p(0, 2), 1e-6 / (2 * kDrive.wheel_separation) * 2.0, 1e-12);
}

TEST(OdometryCovarianceTest, DoesNotGrowWhileStanding) {
  Odometry odometry(kDrive);
  double stamp = 0.0;
  for (const WheelTravel& tick : room_drive()) odometry.update(tick, stamp += 0.015);
  const Eigen::Matrix3d before = odometry.estimate().covariance;
  for (int i = 0; i < 100000; ++i) odometry.update({0.0, 0.0}, stamp += 0.015);
  EXPECT_EQ(odometry.estimate().covariance, before);
}

TEST(OdometryCovarianceTest, DoesNotDependOnTheTick) {
  const Ticks coarse = room_drive();
  const Eigen::Matrix3d reference = predicted(coarse, {});
  for (const int parts : {2, 10, 100}) {
    Ticks fine;
    for (const WheelTravel& tick : coarse) {
      fine.insert(fine.end(), static_cast<std::size_t>(parts), {tick.left / parts, tick.right / parts});
    }
    EXPECT_LT((predicted(fine, {}) - reference).norm(), 1e-3 * reference.norm()) << parts << " parts a tick";
  }
}

TEST(OdometryCovarianceTest, DoesNotExplodeOverAKilometre) {
  // A straight kilometre is the worst case: sideways variance grows as its cube.
  Ticks ticks;
  add_leg(ticks, 1000.0, 0.0, 100000);
  const WheelNoise noise;
  const Eigen::Matrix3d p = predicted(ticks, noise);
  const double heading = 2.0 * noise.left_variance_per_metre / std::pow(kDrive.wheel_separation, 2);
  EXPECT_NEAR(p(2, 2) / (heading * 1e3), 1.0, 1e-6);
  EXPECT_NEAR(p(1, 1) / (heading * 1e9 / 3), 1.0, 1e-3);
}

TEST(OdometryCovarianceTest, StaysSymmetricAndPositiveOnAnyDrive) {
  Random random(2);
  for (int run = 0; run < 20; ++run) {
    Odometry odometry(kDrive, {random.uniform(0.0, 1e-4), random.uniform(0.0, 1e-4)});
    double heading = 0.0;
    for (int i = 0; i < 5000; ++i) {
      const WheelTravel tick{random.uniform(-0.01, 0.01), random.uniform(-0.01, 0.01)};
      const Eigen::Matrix3d& p = odometry.update(tick, i * 0.015).covariance;
      ASSERT_EQ(p, p.transpose());
      if (i % 100 != 0) continue;
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(p, Eigen::EigenvaluesOnly);
      ASSERT_GE(solver.eigenvalues().minCoeff(), -1e-12 * p.trace());
      ASSERT_GT(p(2, 2), heading);  // never more certain of the heading than before
      heading = p(2, 2);
    }
  }
}

TEST(OdometryCovarianceTest, TurnsWithTheStart) {
  const Pose2 start{3.0, -2.0, 1.1};
  Odometry turned(kDrive, {}, start);
  Odometry plain(kDrive);
  double stamp = 0.0;
  for (const WheelTravel& tick : room_drive()) {
    turned.update(tick, stamp += 0.015);
    plain.update(tick, stamp);
  }
  Eigen::Matrix3d r = Eigen::Matrix3d::Identity();
  r.topLeftCorner<2, 2>() << std::cos(1.1), -std::sin(1.1), std::sin(1.1), std::cos(1.1);
  const Eigen::Matrix3d expected = r * plain.estimate().covariance * r.transpose();
  EXPECT_LT((turned.estimate().covariance - expected).norm(), 1e-12 * expected.norm());
}

}  // namespace
}  // namespace scrubjay
