#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <scrubjay/geometry/random.hpp>
#include <scrubjay/odometry/arc.hpp>
#include <scrubjay/odometry/encoder.hpp>
#include <scrubjay/odometry/odometry.hpp>
#include <vector>

#include "odometry/drive.hpp"

namespace scrubjay {
namespace {

constexpr double kTick = 0.015;  // [s]

/// Some equal ticks: a straight, an arc or a spin.
struct Leg {
  WheelTravel tick;
  int ticks;
};

/// Where all legs end, each as one arc of its whole turn, in extended precision.
struct ClosedForm {
  long double x = 0.0L;
  long double y = 0.0L;
  long double yaw = 0.0L;
  long double way = 0.0L;

  void drive(const Leg& leg) {
    const long double left = static_cast<long double>(leg.tick.left) * leg.ticks;
    const long double right = static_cast<long double>(leg.tick.right) * leg.ticks;
    const long double length = (left + right) / 2;
    const long double turn = (right - left) / kDrive.wheel_separation;
    const long double half = turn / 2;
    const long double chord = half == 0 ? length : length * std::sin(half) / half;
    x += chord * std::cos(yaw + half);
    y += chord * std::sin(yaw + half);
    yaw += turn;
    way += std::fabs(length);
  }
};

double distance(const Pose2& pose, const ClosedForm& truth) {
  return static_cast<double>(std::hypot(pose.x - truth.x, pose.y - truth.y));
}

TEST(OdometryTest, StartsWhereItIsTold) {
  const Pose2 start{1.0, 2.0, 0.5};
  Odometry odometry(kDrive, {}, start);
  EXPECT_EQ(odometry.estimate().pose, start);
  EXPECT_EQ(odometry.update({0.0, 0.0}, 0.0).pose, start);
  const Pose2 moved = odometry.update({0.1, 0.2}, kTick).pose;
  const Pose2 expected = start * arc_motion({0.1, 0.2}, kDrive);
  EXPECT_NEAR((moved.position() - expected.position()).norm(), 0.0, 1e-15);
  EXPECT_NEAR(moved.yaw, expected.yaw, 1e-15);
}

TEST(OdometryTest, AKilometreErrsByLessThanAMillimetre) {
  Random random(1);
  Odometry odometry(kDrive);
  ClosedForm truth;
  double stamp = 0.0;
  while (truth.way < 1000.0L) {
    const double left = random.uniform(-0.0075, 0.0075);
    const double right = random.below(3) == 0 ? left : random.uniform(-0.0075, 0.0075);
    const Leg leg{{left, right}, 1 + static_cast<int>(random.below(400))};
    truth.drive(leg);
    for (int i = 0; i < leg.ticks; ++i) odometry.update(leg.tick, stamp += kTick);
  }
  // 1e-10 m and less is what it is.
  EXPECT_LT(distance(odometry.estimate().pose, truth), 1e-9);
  EXPECT_NEAR(std::remainder(odometry.estimate().pose.yaw - static_cast<double>(truth.yaw), 2.0 * kPi), 0.0, 1e-10);
}

TEST(OdometryTest, AKilometreInCountsErrsByLessThanAMillimetre) {
  Random random(2);
  Odometry odometry(kDrive);
  ClosedForm truth;
  Encoder left_encoder;
  Encoder right_encoder;
  std::int64_t left_count = 65000;
  std::int64_t right_count = 5;
  left_encoder.advance(static_cast<std::uint16_t>(left_count), 100);
  right_encoder.advance(static_cast<std::uint16_t>(right_count), 100);
  const double per_count = kDrive.metres_per_count();
  double stamp = 0.0;
  while (truth.way < 1000.0L) {
    const int left = static_cast<int>(random.below(35)) - 17;
    const int right = random.below(3) == 0 ? left : static_cast<int>(random.below(35)) - 17;
    const int ticks = 1 + static_cast<int>(random.below(400));
    truth.drive({{left * per_count, right * per_count}, ticks});
    for (int i = 0; i < ticks; ++i) {
      left_count += left;
      right_count += right;
      const int left_step = left_encoder.advance(static_cast<std::uint16_t>(left_count), 100);
      const int right_step = right_encoder.advance(static_cast<std::uint16_t>(right_count), 100);
      odometry.update({left_step * per_count, right_step * per_count}, stamp += kTick);
    }
  }
  EXPECT_LT(distance(odometry.estimate().pose, truth), 1e-9);
}

TEST(OdometryTest, AKilometreOfLapsEndsWhereItBegan) {
  Odometry odometry(kDrive);
  constexpr int kTicks = 1397;  // a lap
  const double radius = 10.0 / (2.0 * kPi);
  const double half = 0.5 * kDrive.wheel_separation;
  const WheelTravel tick{2.0 * kPi * (radius - half) / kTicks, 2.0 * kPi * (radius + half) / kTicks};
  double stamp = 0.0;
  for (int lap = 0; lap < 100; ++lap) {
    for (int i = 0; i < kTicks; ++i) odometry.update(tick, stamp += kTick);
  }
  EXPECT_LT(odometry.estimate().pose.position().norm(), 1e-9);
  EXPECT_NEAR(odometry.estimate().pose.yaw, 0.0, 1e-9);
}

TEST(TwistTest, IsTheMeanVelocity) {
  Odometry odometry(kDrive);
  const double half = 0.5 * kDrive.wheel_separation * 1.5;
  const WheelTravel tick{(0.2 - half) * kTick, (0.2 + half) * kTick};
  for (int i = 0; i < 10; ++i) odometry.update(tick, i * kTick);
  const Twist2 twist = odometry.estimate().twist;
  EXPECT_NEAR(twist.linear, 0.2, 1e-12);
  EXPECT_NEAR(twist.angular, 1.5, 1e-12);
  EXPECT_EQ(twist.lateral, 0.0);
}

TEST(TwistTest, EndsWithinTwoTicksOfStanding) {
  Odometry odometry(kDrive);
  int i = 0;
  for (; i < 11; ++i) odometry.update({0.003, 0.003}, i * kTick);
  for (int standing = 0; standing < 4; ++standing) odometry.update({0.0, 0.0}, i++ * kTick);
  EXPECT_EQ(odometry.estimate().twist, Twist2{});
  EXPECT_EQ(odometry.estimate().twist_covariance.norm(), 0.0);
}

struct TwistRecord {
  double lowest = 1e9;
  double highest = -1e9;
  double mean = 0.0;
};

/// Drives ticks of 3 mm a wheel, 15 ms apart in truth, at the stamps given.
TwistRecord drive_at(const std::vector<double>& stamps) {
  Odometry odometry(kDrive);
  TwistRecord record;
  int counted = 0;
  for (const double stamp : stamps) {
    const PoseEstimate& estimate = odometry.update({0.003, 0.003}, stamp);
    EXPECT_TRUE(std::isfinite(estimate.twist.linear) && std::isfinite(estimate.twist_covariance.norm()));
    if (++counted <= 10) continue;
    record.lowest = std::min(record.lowest, estimate.twist.linear);
    record.highest = std::max(record.highest, estimate.twist.linear);
    record.mean += estimate.twist.linear;
  }
  record.mean /= counted - 10;
  return record;
}

TEST(TwistTest, StaysRightWhenTicksAreUneven) {
  Random random(3);
  std::vector<double> stamps;
  for (int i = 0; i < 5000; ++i) stamps.push_back(i * kTick + random.uniform(-0.004, 0.004));
  const TwistRecord record = drive_at(stamps);
  EXPECT_NEAR(record.mean, 0.2, 0.01);
  EXPECT_GT(record.lowest, 0.1);
  EXPECT_LT(record.highest, 0.3);
}

TEST(TwistTest, StaysRightWhenTicksComeInBurstsOfOneStamp) {
  for (const int burst : {2, 3, 7}) {
    std::vector<double> stamps;
    for (int i = 0; i < 5000; ++i) stamps.push_back((i / burst * burst) * kTick);
    const TwistRecord record = drive_at(stamps);
    EXPECT_NEAR(record.mean, 0.2, 0.01) << "bursts of " << burst;
    EXPECT_GT(record.lowest, 0.05) << "bursts of " << burst;
    EXPECT_LT(record.highest, 0.41) << "bursts of " << burst;
  }
}

TEST(TwistTest, StaysFiniteWhenAllStampsAreTheSame) {
  const TwistRecord record = drive_at(std::vector<double>(1000, 5.0));
  EXPECT_EQ(record.highest, 0.0);
  EXPECT_EQ(record.lowest, 0.0);
}

TEST(TwistTest, StaysRightWhenStampsStepBackALittle) {
  std::vector<double> stamps;
  for (int i = 0; i < 5000; ++i) stamps.push_back(i * kTick - (i % 10 == 0 ? 0.02 : 0.0));
  const TwistRecord record = drive_at(stamps);
  EXPECT_NEAR(record.mean, 0.2, 0.02);
  EXPECT_GT(record.lowest, 0.08);
  EXPECT_LT(record.highest, 0.4);
}

TEST(TwistTest, RecoversAtOnceWhenTheClockIsSetBack) {
  Odometry odometry(kDrive);
  for (int i = 0; i < 20; ++i) odometry.update({0.003, 0.003}, 1000.0 + i * kTick);
  for (int i = 0; i < 4; ++i) odometry.update({0.006, 0.006}, i * kTick);
  EXPECT_NEAR(odometry.estimate().twist.linear, 0.4, 1e-9);
}

TEST(TwistTest, CovarianceIsTheNoiseOfTheWheelsOverTheInterval) {
  const WheelNoise noise{4e-6, 1e-6};
  Odometry odometry(kDrive, noise);
  odometry.update({0.0, 0.0}, 0.0);
  odometry.update({-0.006, 0.008}, 0.03);
  const Eigen::Matrix3d& p = odometry.estimate().twist_covariance;
  const double left = 4e-6 * 0.006 / (0.03 * 0.03);
  const double right = 1e-6 * 0.008 / (0.03 * 0.03);
  const double b = kDrive.wheel_separation;
  EXPECT_NEAR(p(0, 0), (left + right) / 4, 1e-15);
  EXPECT_NEAR(p(2, 2), (left + right) / (b * b), 1e-15);
  EXPECT_NEAR(p(0, 2), (right - left) / (2 * b), 1e-15);
  EXPECT_EQ(p(0, 2), p(2, 0));
  EXPECT_EQ(p.row(1).norm() + p.col(1).norm(), 0.0);
}

}  // namespace
}  // namespace scrubjay
