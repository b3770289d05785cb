#include <gmock/gmock.h>

#include <scrubjay/localization/localizer.hpp>
#include <scrubjay/robot/oi_robot.hpp>
#include <scrubjay/simulation/simulated_roomba.hpp>

#include "stage.hpp"
#include "wire.hpp"

namespace scrubjay::test {
namespace {

/// Our own client, odometry and the simulated robot, joined by bytes alone.
class ClosedLoop {
 public:
  explicit ClosedLoop(oi::Model protocol, const sim::FirmwareOptions& options = {}, const World& scenery = {})
      : world(scenery),
        index(solid_segments(world)),
        spec(speaking(protocol)),
        roomba(world, index, spec, {}, Random(1), start, options),
        robot(roomba, spec.model, options.quirks),
        odometry(spec.model.drive) {}

  Frame step(const Motion& motion) {
    const auto frame = robot.next();
    EXPECT_TRUE(frame.has_value());
    if (!frame) return {};
    estimate = start * odometry.update(*frame).pose;
    robot.drive(motion);
    return *frame;
  }
  void run(const Motion& motion, double seconds) {
    for (int i = ticks_in(seconds); i > 0; --i) step(motion);
  }
  double position_error() const { return (estimate.position() - roomba.truth().pose.position()).norm(); }
  double heading_error() const { return std::fabs(angle_difference(estimate.yaw, roomba.truth().pose.yaw)); }

  Pose2 start{1.0, 2.0, 0.5};
  World world;
  SegmentIndex index;
  sim::RobotSpec spec;
  sim::SimulatedRoomba roomba;
  OiRobot robot;
  DeadReckoning odometry;
  Pose2 estimate = start;
};

void drive_square(ClosedLoop& loop) {
  for (int side = 0; side < 4; ++side) {
    loop.run({0.2, 0.0}, 5.0);
    loop.run({}, 1.0);
    loop.run({0.0, 0.5}, kPi);
    loop.run({}, 1.0);
  }
}

TEST(ClosedLoopTest, OdometryKnowsWhereASquareEnds) {
  ClosedLoop loop(oi::Model::Create2);
  drive_square(loop);
  EXPECT_GT(loop.roomba.truth().distance, 3.5);
  EXPECT_LT(loop.position_error(), 0.002);
  EXPECT_LT(loop.heading_error(), radians(0.2));
  EXPECT_EQ(loop.robot.counters().lost, 0u);
  EXPECT_EQ(loop.robot.counters().skipped, 0u);
  EXPECT_EQ(loop.robot.rejected_values(), 0u);
}

TEST(ClosedLoopTest, SoItDoesOverAnEncoderWrapAndBackwards) {
  ClosedLoop loop(oi::Model::Create2, {.encoder_start = 65000});
  loop.run({0.3, 0.2}, 6.0);
  loop.run({-0.3, 0.1}, 12.0);
  loop.run({}, 1.0);
  EXPECT_LT(loop.position_error(), 0.002);
  EXPECT_LT(loop.heading_error(), radians(0.2));
}

TEST(ClosedLoopTest, SoItDoesWithSwappedEncodersAndTheModeOneTooHigh) {
  ClosedLoop loop(oi::Model::Create2,
                  {.quirks = {.mode_one_too_high = true, .sign_from_command = false, .swapped_encoders = true}});
  drive_square(loop);
  EXPECT_LT(loop.position_error(), 0.002);
  EXPECT_LT(loop.heading_error(), radians(0.2));
  EXPECT_EQ(loop.step({}).mode, oi::OiMode::Safe);
}

TEST(ClosedLoopTest, RobotsWithoutEncodersAreKnownByDistanceAndAngle) {
  for (const oi::Model protocol : {oi::Model::Create1, oi::Model::Roomba400}) {
    ClosedLoop loop(protocol);
    drive_square(loop);
    EXPECT_GT(loop.roomba.truth().distance, 3.5);
    // Whole degrees and millimetres, at times late: what is left over comes with a later frame.
    EXPECT_LT(loop.position_error(), 0.03) << static_cast<int>(protocol);
    EXPECT_LT(loop.heading_error(), radians(1.0)) << static_cast<int>(protocol);
  }
}

TEST(ClosedLoopTest, FramesCarryWhatTheBodyFeels) {
  ClosedLoop loop(oi::Model::Create2, {}, with_walls({facing({1.0, 2.0}, 0.5, 0.5, 1.0)}));
  loop.run({0.2, 0.0}, 4.0);
  const Frame frame = loop.step({});
  EXPECT_TRUE(frame.bump_left && frame.bump_right);
  EXPECT_TRUE(frame.sees(LightSensor::CenterLeft) && frame.sees(LightSensor::CenterRight));
  EXPECT_GT(frame.light_signal[2], 1000);
  EXPECT_NEAR(frame.stamp, loop.roomba.now(), 1e-9);
  EXPECT_NEAR(frame.battery.capacity, 2.696, 1e-9);
}

TEST(ClosedLoopTest, ControlIsTakenUpAgainAfterAFrightAtACliff) {
  World world;
  world.cliffs = {box({2.0, 2.0}, {0.4, 6.0}, 0.0)};
  ClosedLoop loop(oi::Model::Create2, {}, world);
  loop.run({0.2, 0.0}, 6.0);
  EXPECT_NE(loop.step({}).cliff_flags, 0);
  loop.run({}, 1.0);
  EXPECT_EQ(loop.step({}).mode, oi::OiMode::Safe);
  const double before = loop.roomba.truth().pose.x;
  loop.run({-0.1, 0.0}, 2.0);
  EXPECT_LT(loop.roomba.truth().pose.x, before - 0.1);
}

TEST(ClosedLoopTest, AStoppedRobotStandsInPassive) {
  ClosedLoop loop(oi::Model::Create2);
  loop.run({0.2, 0.0}, 2.0);
  loop.robot.stop();
  Bytes buffer(256);
  for (int i = 0; i < 100; ++i) loop.roomba.read(buffer);
  const Pose2 stopped = loop.roomba.truth().pose;
  EXPECT_EQ(loop.roomba.firmware().mode(), oi::OiMode::Passive);
  for (int i = 0; i < 100; ++i) loop.roomba.read(buffer);
  EXPECT_EQ(loop.roomba.truth().pose, stopped);
}

}  // namespace
}  // namespace scrubjay::test
