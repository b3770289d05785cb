#include <gtest/gtest.h>

#include <scrubjay/exploration/feelers.hpp>

#include "behavior/situations.hpp"

namespace scrubjay::test {
namespace {

const RobotModel kRobot;

TEST(FeelersTest, NothingIsAheadInAQuietFrame) {
  const Ahead ahead = ahead_by_light(quiet_frame(), kRobot);
  EXPECT_GT(ahead.way, 10.0);
  EXPECT_FALSE(ahead.point);
}

TEST(FeelersTest, TellsHowFarItIsToWhatItWouldTouch) {
  // Straight before the sensor at 12.5 degrees; the disc touches it a little beside its foremost point.
  const double range = 0.1;
  const Ahead ahead = ahead_by_light(lit_frame(LightSensor::CenterLeft, range), kRobot);
  ASSERT_TRUE(ahead.point);
  const Point2 hit = kRobot.light.mount[2] * Point2(range, 0.0);
  const Point2 touching = Point2(ahead.way, 0.0);
  EXPECT_NEAR((hit - touching).norm(), kRobot.radius, 1e-3);
}

TEST(FeelersTest, WhatItPassesByIsNotAhead) {
  EXPECT_GT(ahead_by_light(lit_frame(LightSensor::Left, 0.08), kRobot).way, 10.0);
  EXPECT_LT(ahead_by_light(lit_frame(LightSensor::FrontLeft, 0.05), kRobot).way, 0.1);
  EXPECT_GT(ahead_by_light(lit_frame(LightSensor::FrontLeft, 0.15), kRobot).way, 10.0);
}

TEST(FeelersTest, RoomBesideIsLeftAndRightTogether) {
  Frame frame = lit_frame(LightSensor::Left, 0.0374 + 1.104 * 0.02);  // 2 cm
  EXPECT_GT(room_beside(frame, kRobot), 10.0) << "open on the right";
  frame.light_signal[5] = lit_frame(LightSensor::Right, 0.0374 + 1.104 * 0.01).light_signal[5];
  EXPECT_NEAR(room_beside(frame, kRobot), 0.03, 2e-3);
}

TEST(FeelersTest, FacesADockWhereBothBuoysMeetAhead) {
  Frame frame = quiet_frame();
  EXPECT_FALSE(faces_dock(frame));
  frame.infrared_omni = 173;  // red and green buoy, force field
  EXPECT_FALSE(faces_dock(frame)) << "it may be behind";
  frame.infrared_left = frame.infrared_right = 173;
  EXPECT_TRUE(faces_dock(frame));
  frame.infrared_omni = 172;
  EXPECT_FALSE(faces_dock(frame)) << "too far to matter";
  frame.infrared_omni = frame.infrared_left = frame.infrared_right = 162;
  EXPECT_FALSE(faces_dock(frame)) << "a virtual wall is no dock";
}

TEST(FeelersTest, KnownFloorAheadEndsWhereAnyOfItsWidthIsUnknown) {
  DrawnMap map({"..............................",  //
                "..............................",  //
                "..............................",  //
                "..............................",  //
                "..............................",  //
                "..............................",  //
                ".................?............",  //
                ".............................."});
  const Pose2 pose{0.2, 0.2, 0.0};
  // The unknown cell begins at x = 0.85.
  EXPECT_NEAR(known_ahead(map.view(), pose, 0.1735, 1.0), 0.85 - 0.2 - 0.1735, 0.05);
  EXPECT_EQ(known_ahead(map.view(), pose, 0.1735, 0.3), 0.3) << "no farther than it looks";
  EXPECT_NEAR(known_ahead(map.view(), {1.2, 0.2, 0.0}, 0.1735, 1.0), 1.5 - 1.2 - 0.1735, 0.05) << "the map ends";
}

TEST(FeelersTest, BrakingFromTheSpeedToStopTakesTheWay) {
  const double speed = speed_to_stop(0.3, 0.25);
  EXPECT_NEAR(speed * speed / (2.0 * 0.25), 0.3, 1e-12);
  EXPECT_EQ(speed_to_stop(-0.1, 0.25), 0.0);
}

}  // namespace
}  // namespace scrubjay::test
