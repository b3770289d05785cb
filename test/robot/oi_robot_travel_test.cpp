#include <gtest/gtest.h>

#include <cmath>
#include <scrubjay/odometry/odometry.hpp>
#include <scrubjay/robot/oi_robot.hpp>

#include "scripted_channel.hpp"

namespace scrubjay {
namespace {

const DifferentialDrive kDrive;

/// A robot that sends one frame a tick.
struct Session {
  explicit Session(oi::Model dialect = oi::Model::Create2, const oi::FirmwareQuirks& quirks = {})
      : protocol(dialect), robot(channel, model_of(dialect), quirks) {}

  static RobotModel model_of(oi::Model dialect) {
    RobotModel model;
    model.protocol = dialect;
    return model;
  }
  Frame next(const oi::Sensors& sensors) { return next(sensors, stamp + kTick); }
  Frame next(const oi::Sensors& sensors, double at) {
    channel.give(stamp = at, stream_frame(sensors, protocol));
    return robot.next().value();
  }

  oi::Model protocol;
  ScriptedChannel channel;
  OiRobot robot;
  double stamp = 0.0;
};

TEST(OiRobotTravelTest, BeginsWithTheFirstCount) {
  Session session;
  const Frame frame = session.next(counted(12000, -500));
  EXPECT_EQ(frame.left_travel, 0.0);
  EXPECT_EQ(frame.right_travel, 0.0);
}

TEST(OiRobotTravelTest, ReversesThroughZero) {
  Session session;
  session.next(counted(5, 3));
  const Frame frame = session.next(counted(-4, -7));
  EXPECT_DOUBLE_EQ(frame.left_travel, -9 * kDrive.metres_per_count());
  EXPECT_DOUBLE_EQ(frame.right_travel, -10 * kDrive.metres_per_count());
}

TEST(OiRobotTravelTest, WrapsForwardsAndBackwards) {
  Session session;
  session.next(counted(32765, -32766));
  const Frame frame = session.next(counted(-32766, 32764));
  EXPECT_DOUBLE_EQ(frame.left_travel, 5 * kDrive.metres_per_count());
  EXPECT_DOUBLE_EQ(frame.right_travel, -6 * kDrive.metres_per_count());
}

TEST(OiRobotTravelTest, IgnoresTheJumpOfACounterThatBeganAnew) {
  Session session;
  session.next(counted(20000, 21000));
  const Frame jump = session.next(counted(0, 0));
  EXPECT_EQ(jump.left_travel, 0.0);
  EXPECT_EQ(jump.right_travel, 0.0);
  EXPECT_DOUBLE_EQ(session.next(counted(7, 8)).right_travel, 8 * kDrive.metres_per_count());
}

TEST(OiRobotTravelTest, KeepsTheWayOfALateFrame) {
  Session session;
  session.next(counted(0, 0));
  // A second at full speed is 1125 counts.
  EXPECT_DOUBLE_EQ(session.next(counted(1125, 1125), 1.015).left_travel, 1125 * kDrive.metres_per_count());
}

TEST(OiRobotTravelTest, SwapsEncodersWhereTheFirmwareDoes) {
  Session session(oi::Model::Create2, {.swapped_encoders = true});
  session.next(counted(0, 0));
  const Frame frame = session.next(counted(2, 9));
  EXPECT_DOUBLE_EQ(frame.left_travel, 9 * kDrive.metres_per_count());
  EXPECT_DOUBLE_EQ(frame.right_travel, 2 * kDrive.metres_per_count());
}

TEST(OiRobotTravelTest, TakesDistanceAndAngleFromACreate1) {
  Session session(oi::Model::Create1);
  session.next(measured(0, 0));
  const Frame frame = session.next(measured(6, -2));
  EXPECT_NEAR(0.5 * (frame.left_travel + frame.right_travel), 0.006, 1e-15);
  EXPECT_NEAR((frame.right_travel - frame.left_travel) / kDrive.wheel_separation, radians(-2.0), 1e-15);
}

TEST(OiRobotTravelTest, ScalesTheAngleOfOldFirmware) {
  Session session(oi::Model::Create1, {.angle_divisor = 0.324056});
  session.next(measured(0, 0));
  const Frame frame = session.next(measured(0, 1));
  EXPECT_NEAR((frame.right_travel - frame.left_travel) / kDrive.wheel_separation, radians(1.0 / 0.324056), 1e-15);
}

TEST(OiRobotTravelTest, IgnoresTheWayThatACreate1RolledBeforeItWasFirstAsked) {
  Session session(oi::Model::Create1);
  const Frame first = session.next(measured(40, 5));
  EXPECT_EQ(first.left_travel, 0.0);
  EXPECT_EQ(first.right_travel, 0.0);
  EXPECT_GT(session.next(measured(5, 0)).left_travel, 0.0);
}

TEST(OiRobotTravelTest, IgnoresADistanceThatNoWheelCanRoll) {
  Session session(oi::Model::Create1);
  session.next(measured(0, 0));
  EXPECT_EQ(session.next(measured(30000, 0)).left_travel, 0.0);
  EXPECT_EQ(session.next(measured(0, -20000)).right_travel, 0.0);
  EXPECT_NEAR(session.next(measured(-7, 0)).left_travel, -0.007, 1e-15);
}

TEST(OiRobotTravelTest, DrivesAClosedSquareInCounts) {
  Session session;
  Odometry odometry(kDrive);
  int left = 65000 - 65536;
  int right = 32000;
  const auto tick = [&](int left_step, int right_step) {
    left += left_step;
    right += right_step;
    const Frame frame = session.next(counted(left, right));
    odometry.update({frame.left_travel, frame.right_travel}, frame.stamp);
  };
  tick(0, 0);
  // A quarter turn takes separation * pi / 4 a wheel, 415.2 counts.
  for (int side = 0; side < 4; ++side) {
    for (int i = 0; i < 200; ++i) tick(10, 10);
    for (int i = 0; i < 83; ++i) tick(-5, 5);
  }
  const PoseEstimate& end = odometry.estimate();
  EXPECT_LT(end.pose.position().norm(), 0.01);
  EXPECT_NEAR(end.pose.yaw, 0.0, 0.01);
  // The covariance stays that of four metres on a floor: millimetres and degrees.
  EXPECT_LT(std::sqrt(end.covariance(0, 0) + end.covariance(1, 1)), 0.05);
  EXPECT_LT(std::sqrt(end.covariance(2, 2)), radians(3.0));
}

TEST(OiRobotTravelTest, VelocityStaysRightWhenFramesArriveInBursts) {
  ScriptedChannel channel;
  OiRobot robot(channel, {});
  Odometry odometry(kDrive);
  int count = 0;
  for (int read = 0; read < 400; ++read) {
    // 45 ms of stream a read, as from a USB port with a latency timer; reads are late by up to 7 ms.
    Bytes burst;
    for (int i = 0; i < 3; ++i) {
      count += 7;
      burst = burst + stream_frame(counted(count, count));
    }
    channel.give(read * 0.045 + (read % 3) * 0.0035, burst);
  }
  const double speed = 7 * kDrive.metres_per_count() / kTick;
  double sum = 0.0;
  int frames = 0;
  while (const auto frame = robot.next()) {
    const Twist2 twist = odometry.update({frame->left_travel, frame->right_travel}, frame->stamp).twist;
    if (++frames <= 9) continue;
    EXPECT_NEAR(twist.linear, speed, 0.3 * speed);
    sum += twist.linear;
  }
  EXPECT_NEAR(sum / (frames - 9), speed, 0.02 * speed);
}

}  // namespace
}  // namespace scrubjay
