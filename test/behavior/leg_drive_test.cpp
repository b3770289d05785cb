#include <gtest/gtest.h>

#include <cmath>
#include <scrubjay/behavior/leg_drive.hpp>
#include <scrubjay/odometry/odometry.hpp>
#include <vector>

namespace scrubjay {
namespace {

constexpr double kTick = 0.015;
const DifferentialDrive kDrive;

/// A robot that does at once what it is told, but for what its wheels add.
class Rider {
 public:
  explicit Rider(const std::vector<Leg>& legs) : behavior(legs) {}

  /// One tick; false once the behavior is done.
  bool step(const Frame& felt = {}) {
    Frame frame = felt;
    frame.stamp = stamp_ += kTick;
    const double half = 0.5 * kDrive.wheel_separation * motion_.angular;
    frame.left_travel = kTick * (motion_.linear - half) * left_scale;
    frame.right_travel = kTick * (motion_.linear + half);
    turned += (frame.right_travel - frame.left_travel) / kDrive.wheel_separation;
    const PoseEstimate& estimate = odometry_.update({frame.left_travel, frame.right_travel}, stamp_);
    farthest = std::max(farthest, estimate.pose.position().norm());
    const Decision decision = behavior.decide({frame, estimate, {}, {}});
    motion_ = decision.motion;
    return !decision.done;
  }
  /// To the end, or for ten minutes.
  void ride() {
    int ticks = 0;
    while (step() && ++ticks < 40'000) {
    }
    EXPECT_LT(ticks, 40'000);
  }
  const Pose2& pose() const { return odometry_.estimate().pose; }
  const Motion& motion() const { return motion_; }

  LegDrive behavior;
  double left_scale = 1.0;
  double turned = 0.0;
  double farthest = 0.0;

 private:
  Odometry odometry_{kDrive, {}, {}};
  Motion motion_;
  double stamp_ = 0.0;
};

TEST(LegDriveTest, ASquareEndsWhereItBegan) {
  for (const double turn : {0.5 * kPi, -0.5 * kPi}) {
    Rider rider(std::vector<Leg>(4, {1.0, turn}));
    rider.ride();
    EXPECT_LT(rider.pose().position().norm(), 0.02);
    EXPECT_NEAR(rider.turned, 4.0 * turn, radians(2.0));
    EXPECT_NEAR(rider.farthest, std::sqrt(2.0), 0.03);
    EXPECT_EQ(rider.motion(), Motion{});
    EXPECT_FALSE(rider.behavior.failed());
  }
}

TEST(LegDriveTest, AStraightIsAsLongAsItShould) {
  Rider rider({{2.0, 0.0}});
  rider.ride();
  EXPECT_NEAR(rider.pose().x, 2.0, 0.005);
  EXPECT_NEAR(rider.pose().y, 0.0, 0.005);
  EXPECT_NEAR(rider.pose().yaw, 0.0, radians(1.0));
}

TEST(LegDriveTest, TurnsAsOftenAsItIsTold) {
  for (const double turns : {10.0, -3.25}) {
    Rider rider({{0.0, 2.0 * kPi * turns}});
    rider.ride();
    EXPECT_NEAR(rider.turned, 2.0 * kPi * turns, radians(2.0));
    EXPECT_LT(rider.farthest, 1e-9);
  }
}

TEST(LegDriveTest, SteersBackToItsLine) {
  Rider rider({{3.0, 0.0}});
  rider.left_scale = 0.97;
  rider.ride();
  EXPECT_NEAR(rider.pose().x, 3.0, 0.01);
  EXPECT_NEAR(rider.pose().y, 0.0, 0.05);
}

TEST(LegDriveTest, WaitsUntilItsWheelsAreAtRest) {
  Rider rider({{1.0, 0.0}});
  ASSERT_TRUE(rider.step());
  EXPECT_EQ(rider.motion(), Motion{});
  for (int i = 0; i < 20; ++i) ASSERT_TRUE(rider.step());
  EXPECT_EQ(rider.motion(), Motion{});
  for (int i = 0; i < 20; ++i) ASSERT_TRUE(rider.step());
  EXPECT_GT(rider.motion().linear, 0.0);
}

TEST(LegDriveTest, StopsForGoodAtWhatItFeels) {
  Frame bump;
  bump.bump_left = true;
  Frame cliff;
  cliff.cliff_flags = 1;
  Frame lifted;
  lifted.wheel_drop_right = true;
  for (const Frame& felt : {bump, cliff, lifted}) {
    Rider rider({{1.0, 0.0}});
    for (int i = 0; i < 100; ++i) ASSERT_TRUE(rider.step());
    EXPECT_FALSE(rider.step(felt));
    EXPECT_TRUE(rider.behavior.failed());
    EXPECT_EQ(rider.motion(), Motion{});
    EXPECT_FALSE(rider.step());
  }
}

}  // namespace
}  // namespace scrubjay
