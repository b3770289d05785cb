#include <gtest/gtest.h>

#include <Eigen/LU>
#include <scrubjay/geometry/random.hpp>
#include <scrubjay/localization/pose_filter.hpp>

namespace scrubjay {
namespace {

Eigen::Vector3d difference(const Pose2& a, const Pose2& b) {
  return {a.x - b.x, a.y - b.y, angle_difference(a.yaw, b.yaw)};
}

double squared(double x) {
  return x * x;
}

/// A base whose odometry errs, on the way around a few corners.
struct Drive {
  explicit Drive(const OdometryBias& errs) : bias(errs) {}

  /// Drives a step that odometry tells as `told`; returns what it really was.
  Pose2 go(const Pose2& told) {
    const double turn = (1.0 + bias.turn) * told.yaw + bias.bend * told.x;
    const SinCos half = sin_cos(0.5 * turn);
    const double way = (1.0 + bias.way) * told.x;
    const Pose2 step{way * half.cos, way * half.sin, turn};
    truth = truth * step;
    return step;
  }
  /// The i-th of steps of 2 cm, with a quarter of a turn now and then, to either side.
  static Pose2 told(int i) {
    const int phase = i % 60;
    if (phase < 50) return {0.02, 0.0, 0.0};
    return {0.0, 0.0, (i / 60) % 3 == 0 ? -0.15 : 0.15};
  }

  OdometryBias bias;
  Pose2 truth;
};

/// Readings of the pose, as good as a centimetre and half a degree.
Eigen::Matrix3d reading() {
  return Eigen::Vector3d(1e4, 1e4, 1.3e4).asDiagonal();
}

/// What a filter makes of a reading of the true pose.
Pose2 posterior(const PoseFilter& filter, const Pose2& truth, const Eigen::Matrix3d& information) {
  const Eigen::Vector3d off = difference(truth, filter.pose());
  const Eigen::Vector3d move = (filter.information() + information).inverse() * information * off;
  return {filter.pose().x + move.x(), filter.pose().y + move.y(), wrap_angle(filter.pose().yaw + move.z())};
}

TEST(PoseFilterTest, GoesAsOdometryTellsWhileItKnowsNoBetter) {
  PoseFilter filter;
  Pose2 told;
  for (int i = 0; i < 300; ++i) {
    told = told * Drive::told(i);
    filter.predict(Drive::told(i));
  }
  EXPECT_LT(difference(filter.pose(), told).norm(), 1e-12);
  EXPECT_EQ(filter.bias().way, 0.0);
}

TEST(PoseFilterTest, StandingStillAddsNothing) {
  PoseFilter filter;
  filter.predict({0.1, 0.0, 0.2});
  const Pose2 pose = filter.pose();
  const Eigen::Matrix3d covariance = filter.covariance();
  for (int i = 0; i < 1000; ++i) filter.predict({});
  EXPECT_EQ(filter.pose(), pose);
  EXPECT_EQ(filter.covariance(), covariance);
}

TEST(PoseFilterTest, FindsOutWhatOdometryErrsByAllTheTime) {
  for (const double sign : {-1.0, 1.0}) {
    Drive drive({.way = sign * 0.02, .turn = -sign * 0.03, .bend = sign * radians(3.0)});
    PoseFilter filter;
    for (int i = 0; i < 1500; ++i) {
      drive.go(Drive::told(i));
      filter.predict(Drive::told(i));
      if (i % 10 == 9) filter.correct(posterior(filter, drive.truth, reading()), reading());
    }
    EXPECT_NEAR(filter.bias().way, drive.bias.way, 0.004);
    EXPECT_NEAR(filter.bias().turn, drive.bias.turn, 0.006);
    EXPECT_NEAR(filter.bias().bend, drive.bias.bend, radians(0.4));
    // So five metres of which nothing is seen are no harm; odometry alone would be off by more than half a metre.
    const Pose2 begin = drive.truth;
    Pose2 told;
    for (int i = 0; i < 250; ++i) {
      drive.go({0.02, 0.0, 0.0});
      filter.predict({0.02, 0.0, 0.0});
      told = told * Pose2{0.02, 0.0, 0.0};
    }
    EXPECT_GT((drive.truth.position() - (begin * told).position()).norm(), 0.5);
    EXPECT_LT((drive.truth.position() - filter.pose().position()).norm(), 0.1);
  }
}

TEST(PoseFilterTest, ASlipIsNoBias) {
  Drive drive({});
  PoseFilter filter;
  const auto go = [&](int from, int to) {
    for (int i = from; i < to; ++i) {
      drive.go(Drive::told(i));
      filter.predict(Drive::told(i));
      if (i % 10 == 9) filter.correct(posterior(filter, drive.truth, reading()), reading());
    }
  };
  go(0, 600);
  drive.truth = drive.truth * Pose2{0.3, 0.1, 0.2};
  filter.slip({0.2, 0.2, 0.2});
  filter.correct(posterior(filter, drive.truth, reading()), reading());
  EXPECT_LT(difference(filter.pose(), drive.truth).norm(), 0.01);
  EXPECT_NEAR(filter.bias().way, 0.0, 0.002);
  EXPECT_NEAR(filter.bias().turn, 0.0, 0.002);
  EXPECT_NEAR(filter.bias().bend, 0.0, radians(0.2));
}

// Over many drives that err as the filter was told they do, the squared error in units of the covariance is the number
// of dimensions (Bar-Shalom, Li, Kirubarajan, Estimation with Applications to Tracking and Navigation, sec. 5.4).
TEST(PoseFilterTest, KnowsHowFarItIsOff) {
  MotionNoise noise;
  noise.bias_walk = {};
  Random random(11);
  double normalized = 0.0;
  constexpr int kDrives = 2000;
  constexpr int kSteps = 150;
  for (int drive_index = 0; drive_index < kDrives; ++drive_index) {
    Drive drive({.way = noise.bias.way * random.normal(),
                 .turn = noise.bias.turn * random.normal(),
                 .bend = noise.bias.bend * random.normal()});
    PoseFilter filter(noise);
    for (int i = 0; i < kSteps; ++i) {
      const Pose2 told = Drive::told(i);
      drive.go(told);
      const double way = std::fabs(told.x);
      const double turn = std::fabs(told.yaw);
      const double aside = std::sqrt(squared(noise.way_per_way) * way + squared(noise.way_per_turn) * turn);
      const double around = std::sqrt(squared(noise.turn_per_way) * way + squared(noise.turn_per_turn) * turn);
      drive.truth = {drive.truth.x + aside * random.normal(), drive.truth.y + aside * random.normal(),
                     wrap_angle(drive.truth.yaw + around * random.normal())};
      filter.predict(told);
      if (i % 30 != 29) continue;
      const Pose2 seen{drive.truth.x + 0.01 * random.normal(), drive.truth.y + 0.01 * random.normal(),
                       wrap_angle(drive.truth.yaw + random.normal() / std::sqrt(1.3e4))};
      filter.correct(posterior(filter, seen, reading()), reading());
    }
    const Eigen::Vector3d off = difference(drive.truth, filter.pose());
    normalized += off.dot(filter.information() * off);
  }
  EXPECT_NEAR(normalized / kDrives, 3.0, 0.3);
}

TEST(PoseFilterTest, TakesAHeadingForWhatItIsWorth) {
  PoseFilter filter;
  for (int i = 0; i < 100; ++i) filter.predict({0.02, 0.0, 0.01});
  PoseFilter told = filter;
  const double variance = filter.covariance()(2, 2);
  told.correct_heading(0.1, 1.0 / variance);  // as sure as the filter itself
  EXPECT_NEAR(told.pose().yaw, filter.pose().yaw + 0.05, 1e-6);
  EXPECT_NEAR(told.covariance()(2, 2), 0.5 * variance, 1e-6);
  // Where it is hangs together with how it headed on the way there.
  const double aside = filter.covariance()(0, 2) / variance;
  EXPECT_NEAR(told.pose().x, filter.pose().x + 0.05 * aside, 1e-6);
  EXPECT_LT(told.covariance()(0, 0), filter.covariance()(0, 0));
  EXPECT_GT(told.bias().turn + told.bias().bend, 0.0) << "odometry told of too little turn";
}

TEST(PoseFilterTest, LetsNobodyTurnAHeadingThatIsCertain) {
  PoseFilter filter;
  filter.correct_heading(0.1, 1e4);
  EXPECT_EQ(filter.pose(), Pose2{});
}

}  // namespace
}  // namespace scrubjay
