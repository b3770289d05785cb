#include <gmock/gmock.h>

#include <algorithm>
#include <scrubjay/behavior/edge_sense.hpp>

#include "situations.hpp"

namespace scrubjay::test {
namespace {

const RobotModel kRobot;
constexpr double kPointRange = 0.115;

/// What a robot senses in the mirror.
Frame mirrored(Frame frame) {
  std::reverse(frame.light_signal.begin(), frame.light_signal.end());
  std::swap(frame.bump_left, frame.bump_right);
  std::uint8_t flags = 0;
  for (int i = 0; i < kCliffSensorCount; ++i) {
    if ((frame.cliff_flags >> i & 1) != 0) flags = static_cast<std::uint8_t>(flags | 1 << (kCliffSensorCount - 1 - i));
  }
  frame.cliff_flags = flags;
  return frame;
}

TEST(EdgeViewTest, TheFollowedSideComesFirst) {
  const Frame frame = lit_frame(LightSensor::FrontLeft, 0.05);
  EXPECT_NEAR(edge_view(frame, Side::Left, kRobot, kPointRange).front_side, 0.05, 0.001);
  EXPECT_NEAR(edge_view(frame, Side::Right, kRobot, kPointRange).other_front_side, 0.05, 0.001);
  EXPECT_GT(edge_view(frame, Side::Right, kRobot, kPointRange).front_side, kRobot.light.max_range);
}

TEST(EdgeViewTest, RightIsLeftInTheMirror) {
  Frame frame = quiet_frame();
  frame.light_signal = {900, 700, 500, 300, 200, 100};
  frame.bump_left = true;
  frame.cliff_flags = 0;
  const EdgeView left = edge_view(frame, Side::Left, kRobot, kPointRange);
  const EdgeView right = edge_view(mirrored(frame), Side::Right, kRobot, kPointRange);
  EXPECT_EQ(left.side, right.side);
  EXPECT_EQ(left.front, right.front);
  EXPECT_EQ(left.other_front, right.other_front);
  EXPECT_EQ(left.other_side, right.other_side);
  EXPECT_EQ(left.bump_side, right.bump_side);
  EXPECT_EQ(left.bump_other, right.bump_other);
  ASSERT_TRUE(left.point && right.point);
  EXPECT_NEAR(left.point->x(), right.point->x(), 1e-12);
  EXPECT_NEAR(left.point->y(), -right.point->y(), 1e-12);
}

TEST(EdgeViewTest, ThePointLiesOnTheBeamOfTheHindmostSensorThatSeesSomething) {
  Frame frame = lit_frame(LightSensor::CenterLeft, 0.03);
  frame.light_signal[1] = light_signal_at(0.06, kRobot);
  const EdgeView view = edge_view(frame, Side::Left, kRobot, kPointRange);
  ASSERT_TRUE(view.point);
  // All sensors sit on a circle around the middle and look outwards.
  EXPECT_NEAR(view.point->norm(), 0.154 + 0.06, 0.001);
  EXPECT_NEAR(atan2(view.point->y(), view.point->x()), radians(37.5), 1e-9);
}

TEST(EdgeViewTest, FarReturnsAndTheOtherHalfAreNoPoints) {
  EXPECT_FALSE(edge_view(lit_frame(LightSensor::Left, 0.13), Side::Left, kRobot, kPointRange).point);
  EXPECT_FALSE(edge_view(lit_frame(LightSensor::CenterRight, 0.03), Side::Left, kRobot, kPointRange).point);
}

TEST(EdgeViewTest, CliffsCountAsTouched) {
  for (const CliffSensor sensor : {CliffSensor::Left, CliffSensor::FrontLeft}) {
    const Frame frame = cliff_frame(sensor);
    EXPECT_TRUE(edge_view(frame, Side::Left, kRobot, kPointRange).bump_side);
    EXPECT_FALSE(edge_view(frame, Side::Left, kRobot, kPointRange).bump_other);
    EXPECT_TRUE(edge_view(mirrored(frame), Side::Right, kRobot, kPointRange).bump_side);
  }
}

TEST(EdgeViewTest, WithoutLightSensorsSignalsSayNothing) {
  RobotModel blind;
  blind.has_light_sensors = false;
  const EdgeView view = edge_view(lit_frame(LightSensor::Left, 0.03), Side::Left, blind, kPointRange);
  EXPECT_GT(view.side, blind.light.max_range);
  EXPECT_FALSE(view.point);
}

TEST(ObstacleBearingTest, LightTellsBetterThanTheBumper) {
  Frame frame = lit_frame(LightSensor::FrontRight, 0.03);
  frame.bump_left = frame.bump_right = true;
  EXPECT_NEAR(obstacle_bearing(frame, kRobot), radians(-37.5), 1e-9);
}

TEST(ObstacleBearingTest, WithoutLightTheBumpersHalfTells) {
  Frame frame = quiet_frame();
  EXPECT_EQ(obstacle_bearing(frame, kRobot), 0.0);
  frame.bump_left = true;
  EXPECT_GT(obstacle_bearing(frame, kRobot), 0.0);
  EXPECT_EQ(obstacle_bearing(frame, kRobot), -obstacle_bearing(mirrored(frame), kRobot));
  frame.bump_right = true;
  EXPECT_EQ(obstacle_bearing(frame, kRobot), 0.0);
}

TEST(NearerSideTest, TheBumperDecidesThenTheLight) {
  Frame frame = lit_frame(LightSensor::FrontRight, 0.03);
  EXPECT_EQ(nearer_side(frame, Side::Left), Side::Right);
  frame.bump_left = true;
  EXPECT_EQ(nearer_side(frame, Side::Right), Side::Left);
}

TEST(NearerSideTest, APreferenceDecidesWhereBothWouldDo) {
  for (const Side side : {Side::Left, Side::Right}) {
    EXPECT_EQ(nearer_side(quiet_frame(), side), side);
    Frame head_on = quiet_frame();
    head_on.bump_left = head_on.bump_right = true;
    EXPECT_EQ(nearer_side(head_on, side), side);
  }
}

}  // namespace
}  // namespace scrubjay::test
