#include <gtest/gtest.h>

#include <scrubjay/exploration/contact_frontier.hpp>
#include <scrubjay/mapping/contact_mapper.hpp>

#include "behavior/situations.hpp"

namespace scrubjay::test {
namespace {

/// A robot without a body: it goes where it is told, and senses what a test says.
class ContactFrontierTest : public testing::Test {
 protected:
  Decision step(Frame frame) {
    stamp += 0.015;
    frame.stamp = stamp;
    const Motion& motion = last.motion;
    estimate.pose = estimate.pose * Pose2{0.015 * motion.linear, 0.0, 0.015 * motion.angular};
    mapper.update(frame, estimate);
    last = behavior.decide({frame, estimate, mapper.map(), mapper.changed()});
    return last;
  }
  /// True once it does that, within so many seconds.
  bool until(const char* doing, double seconds = 20.0) {
    for (const double end = stamp + seconds; stamp < end;) {
      if (std::string_view(step(quiet_frame()).doing) == doing) return true;
    }
    return false;
  }

  ContactFrontierParams params;
  ContactFrontier behavior{RobotModel{}, Random(1)};
  ContactMapper mapper{RobotModel{}, 0.05};
  PoseEstimate estimate;
  Decision last;
  double stamp = 0.0;
};

TEST_F(ContactFrontierTest, DrivesALaneOverUnknownFloorSlowly) {
  ASSERT_TRUE(until("sweeping a lane"));
  double fastest = 0.0;
  for (int i = 0; i < 400; ++i) fastest = std::max(fastest, step(quiet_frame()).motion.linear);
  EXPECT_STREQ(last.doing, "sweeping a lane");
  EXPECT_NEAR(fastest, params.unknown_speed, 0.01);
  EXPECT_GT(estimate.pose.position().norm(), 0.8);
}

TEST_F(ContactFrontierTest, FollowsTheEdgeThatItTouches) {
  ASSERT_TRUE(until("sweeping a lane"));
  for (int i = 0; i < 200; ++i) step(quiet_frame());
  Frame bump = quiet_frame();
  bump.bump_left = true;
  step(bump);
  EXPECT_STREQ(last.doing, "turning along the edge");
}

TEST_F(ContactFrontierTest, SlowsDownBeforeWhatItSees) {
  ASSERT_TRUE(until("sweeping a lane"));
  for (int i = 0; i < 200; ++i) step(quiet_frame());
  const double fast = last.motion.linear;
  const double slow = step(lit_frame(LightSensor::CenterLeft, 0.05)).motion.linear;
  EXPECT_LT(slow, 0.8 * fast);
  EXPECT_GT(slow, 0.0);
}

TEST_F(ContactFrontierTest, BacksOffFromCliffsAndVirtualWallsAndDoesNotComeBack) {
  ASSERT_TRUE(until("sweeping a lane"));
  for (int i = 0; i < 200; ++i) step(quiet_frame());
  step(cliff_frame(CliffSensor::FrontLeft));
  EXPECT_STREQ(last.doing, "backing off");
  EXPECT_LT(last.motion.linear, 0.0);
  const Point2 cliff = estimate.pose * Point2(0.15, 0.04);
  double nearest = 1.0;
  for (int i = 0; i < 4000; ++i) {
    step(quiet_frame());
    if (last.motion.linear > 0.0) nearest = std::min(nearest, (estimate.pose.position() - cliff).norm());
  }
  EXPECT_GT(nearest, 0.14);
}

TEST_F(ContactFrontierTest, StandsStillWhileAWheelHangs) {
  ASSERT_TRUE(until("sweeping a lane"));
  Frame lifted = quiet_frame();
  lifted.wheel_drop_left = true;
  EXPECT_EQ(step(lifted).motion, Motion{});
  EXPECT_TRUE(until("sweeping a lane")) << "and goes on";
}

TEST_F(ContactFrontierTest, EndsWhereItCanSweepNothingMore) {
  ContactFrontierParams bounded;
  bounded.within = Bounds2{{-0.6, -0.6}, {0.6, 0.6}};
  ContactFrontier small{RobotModel{}, Random(1), bounded};
  Motion motion;
  bool done = false;
  for (int i = 0; i < 20000 && !done; ++i) {
    Frame frame = quiet_frame(0.015 * i);
    estimate.pose = estimate.pose * Pose2{0.015 * motion.linear, 0.0, 0.015 * motion.angular};
    mapper.update(frame, estimate);
    const Decision decision = small.decide({frame, estimate, mapper.map(), mapper.changed()});
    motion = decision.motion;
    done = decision.done;
    EXPECT_TRUE(std::fabs(estimate.pose.x) < 0.65 && std::fabs(estimate.pose.y) < 0.65);
  }
  ASSERT_TRUE(done);
  for (double y = -0.5; y < 0.55; y += 0.1) {
    for (double x = -0.5; x < 0.55; x += 0.1) {
      EXPECT_EQ(trinary(mapper.map()[mapper.map().geometry.cell_at({x, y})]), kFree) << x << ", " << y;
    }
  }
  ASSERT_FALSE(small.leftovers().empty());
  for (const Leftover& left : small.leftovers()) EXPECT_STREQ(left.why, "out of bounds");
}

}  // namespace
}  // namespace scrubjay::test
