#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <limits>
#include <scrubjay/error.hpp>
#include <scrubjay/localization/scan_matching.hpp>

#include "lidar_room.hpp"

namespace scrubjay {
namespace {

double distance(const Pose2& a, const Pose2& b) {
  return (a.position() - b.position()).norm();
}

double turn(const Pose2& a, const Pose2& b) {
  return std::fabs(angle_difference(a.yaw, b.yaw));
}

/// A robot, its localizer and its mapper, among walls.
struct Stage {
  explicit Stage(Walls walls, double noise = 0.0, const RobotModel& model = lidar_robot(),
                 const ScanMatchingParams& params = {})
      : robot(model), localizer(robot, mapper, params), drive(std::move(walls), localizer, mapper, noise) {}

  RobotModel robot;
  LidarMapper mapper{robot, 0.05};
  ScanMatching localizer;
  LidarDrive drive;
};

/// A lidar that errs by a centimetre, near and far.
RobotModel exact_lidar_robot() {
  RobotModel robot = lidar_robot();
  robot.lidar->noise = 0.01;
  robot.lidar->noise_per_range = 0.0;
  return robot;
}

/// For wheels that may be off by a quarter of their way.
ScanMatchingParams for_poor_wheels() {
  ScanMatchingParams params;
  params.motion.turn_per_way = radians(3.0);
  params.motion.turn_per_turn = 0.1;
  return params;
}

/// Looks around in the room from a few places nearby, with odometry that is right: so the map is good.
void look_around(LidarDrive& drive) {
  for (int i = 0; i < 24; ++i) {
    const double angle = radians(15.0) * i;
    const Pose2 pose{0.4 * sin_cos(angle).sin, 0.2 - 0.2 * sin_cos(angle).cos, 0.3 * sin_cos(angle).sin};
    drive.go(pose, pose);
  }
  drive.go({}, {});
}

TEST(ScanMatchingTest, WantsALidar) {
  RobotModel robot = lidar_robot();
  const LidarMapper mapper(robot, 0.05);
  robot.lidar.reset();
  EXPECT_THROW(ScanMatching(robot, mapper), Error);
}

TEST(ScanMatchingTest, IsDeadReckoningWithoutScans) {
  RobotModel robot = lidar_robot();
  LidarMapper mapper(robot, 0.05);
  ScanMatching matching(robot, mapper);
  DeadReckoning reckoning(robot.drive);
  Random random(3);
  for (int i = 0; i < 500; ++i) {
    Frame frame;
    frame.stamp = 0.02 * i;
    frame.left_travel = random.uniform(-0.002, 0.004);
    frame.right_travel = random.uniform(-0.002, 0.004);
    const PoseEstimate& estimate = matching.update(frame);
    const PoseEstimate& reckoned = reckoning.update(frame);
    ASSERT_LT(distance(estimate.pose, reckoned.pose), 1e-12);
    ASSERT_LT(turn(estimate.pose, reckoned.pose), 1e-12);
    ASSERT_EQ(estimate.twist, reckoned.twist);
  }
}

TEST(ScanMatchingTest, TakesTheFirstScanAsTheMap) {
  Stage stage(room_walls());
  const PoseEstimate estimate = stage.drive.go({}, {});
  EXPECT_EQ(estimate.pose, Pose2{});
  EXPECT_EQ(estimate.covariance.norm(), 0.0);
}

TEST(ScanMatchingTest, LearnsMoreOfTheRoomWhileItHasNotMovedYet) {
  const auto error_after = [](int scans) {
    Random random(3);
    double sum = 0.0;
    for (int i = 0; i < 40; ++i) {
      Stage stage(room_walls(), 0.03);
      for (int scan = 0; scan < scans; ++scan) stage.drive.go({}, {});
      const Pose2 truth{random.uniform(0.0, 0.1), random.uniform(-0.05, 0.05), random.uniform(-0.1, 0.1)};
      sum += distance(stage.drive.go(truth, truth).pose, truth);
    }
    return sum;
  };
  EXPECT_LT(error_after(20), 0.4 * error_after(1));
}

TEST(ScanMatchingTest, FindsOutHowFarOdometryIsOff) {
  Random random(5);
  for (int i = 0; i < 40; ++i) {
    Stage stage(room_walls(), 0.0, exact_lidar_robot(), for_poor_wheels());
    look_around(stage.drive);
    const Pose2 truth{random.uniform(-0.3, 0.3), random.uniform(-0.1, 0.3), random.uniform(-0.6, 0.6)};
    stage.drive.go(truth, truth);
    const Pose2 next = truth * Pose2{0.2, 0.0, random.uniform(-0.3, 0.3)};
    const Pose2 off{random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05), random.uniform(-0.1, 0.1)};
    const Pose2 found = stage.drive.go(next, next * off).pose;
    EXPECT_LT(distance(found, next), 0.01) << i;
    EXPECT_LT(turn(found, next), radians(0.5)) << i;
  }
}

TEST(ScanMatchingTest, IsFinerThanTheCellsOfItsMap) {
  Stage stage(room_walls(), 0.0, exact_lidar_robot(), for_poor_wheels());
  look_around(stage.drive);
  // Along a line in steps of no whole share of a cell, by odometry that is always 3 cm behind.
  double worst = 0.0;
  for (int i = 1; i <= 30; ++i) {
    const Pose2 truth{0.013 * i, 0.1, 0.0};
    worst = std::max(worst, distance(stage.drive.go(truth, {0.013 * i - 0.03, 0.1, 0.0}).pose, truth));
  }
  EXPECT_LT(worst, 0.005);
}

TEST(ScanMatchingTest, RecoversFromWheelsThatSlippedFar) {
  Stage stage(room_walls());
  look_around(stage.drive);
  const Pose2 truth{0.1, 0.1, 0.1};
  stage.drive.go(truth, truth);
  // It went on, and the wheels know of 2 cm of it.
  const Pose2 next = truth * Pose2{0.35, 0.1, 0.3};
  const Pose2 found = stage.drive.go(next, truth * Pose2{0.02, 0.0, 0.0}).pose;
  EXPECT_LT(distance(found, next), 0.01);
  EXPECT_LT(turn(found, next), radians(0.5));
}

TEST(ScanMatchingTest, TakesNoFewBeamsWordThatWheelsSlipped) {
  // A hall: all that is in reach is a piece of wall, some twenty beams wide, and ranges err as those of an LDS-01.
  Stage stage({{{-0.5, 2.5}, {0.5, 2.5}}}, 0.05);
  for (int i = 0; i < 10; ++i) stage.drive.go({}, {});
  Pose2 truth;
  Pose2 last;
  for (int i = 0; i < 400; ++i) {
    const Pose2 step{i / 20 % 2 == 0 ? 0.02 : -0.02, 0.0, radians(i / 50 % 2 == 0 ? 1.5 : -1.5)};
    truth = truth * step;
    const Pose2 found = stage.drive.go(truth, truth).pose;
    ASSERT_LT(distance(found, last * step), 0.02) << i;
    ASSERT_LT(turn(found, last * step), radians(1.0)) << i;
    last = found;
  }
}

TEST(ScanMatchingTest, BelievesOdometryAlongABareCorridor) {
  Stage stage(corridor_walls());
  PoseEstimate estimate;
  Pose2 odometry;
  for (int i = 0; i <= 100; ++i) {
    if (i > 0) odometry = odometry * Pose2{0.05, 0.0, 0.002};  // it drifts to the left
    estimate = stage.drive.go({0.05 * i, 0.0, 0.0}, odometry);
  }
  EXPECT_GT(odometry.y, 0.4);
  EXPECT_NEAR(estimate.pose.x, 5.0, 0.02);  // nothing but odometry knows
  EXPECT_NEAR(estimate.pose.y, 0.0, 0.01);  // the walls know better
  EXPECT_NEAR(estimate.pose.yaw, 0.0, radians(0.5));
  EXPECT_GT(estimate.covariance(0, 0), 25.0 * estimate.covariance(1, 1));
}

TEST(ScanMatchingTest, IsNotHeldBackWhereACorridorIsNew) {
  // Noise, and walls of which the map knows but the first metres.
  Stage stage(corridor_walls(), 0.01);
  PoseEstimate estimate;
  for (int i = 0; i <= 200; ++i) estimate = stage.drive.go({0.04 * i, 0.0, 0.0}, {0.04 * i, 0.0, 0.0});
  EXPECT_NEAR(estimate.pose.x, 8.0, 0.1);
  EXPECT_NEAR(estimate.pose.y, 0.0, 0.01);
}

TEST(ScanMatchingTest, IsNotHeldBackByNoiseInALongCorridor) {
  Stage stage(corridor_walls(), 0.01);
  PoseEstimate estimate;
  for (int i = 0; i <= 500; ++i) estimate = stage.drive.go({0.04 * i, 0.0, 0.0}, {0.04 * i, 0.0, 0.0});
  EXPECT_NEAR(estimate.pose.x, 20.0, 0.1);
}

/// The mean error of the heading [degrees] at the end of a row of rooms, over a few runs.
double heading_error_after_rooms(const ScanMatchingParams& params) {
  Walls rooms{{{-2.0, -2.0}, {42.0, -2.0}}, {{-2.0, 2.0}, {42.0, 2.0}}};
  for (int i = 0; i < 12; ++i) {
    const double x = -2.0 + 4.0 * i;
    rooms.push_back({{x, -2.0}, {x, -0.5}});
    rooms.push_back({{x, 0.5}, {x, 2.0}});
  }
  double sum = 0.0;
  for (int run = 0; run < 4; ++run) {
    Stage stage(rooms, 0.05, lidar_robot(), params);
    for (int i = 0; i < run; ++i) stage.drive.go({}, {});  // other noise
    Pose2 odometry;
    PoseEstimate estimate;
    for (int i = 1; i <= 800; ++i) {
      odometry = odometry * Pose2{0.05, 0.0, radians(0.05)};
      estimate = stage.drive.go({0.05 * i, 0.0, 0.0}, odometry);
    }
    sum += degrees(std::fabs(estimate.pose.yaw));
  }
  return sum / 4.0;
}

TEST(ScanMatchingTest, KeepsAHouseStraightByItsWalls) {
  ScanMatchingParams without;
  without.compass.trust = 1e-9;
  EXPECT_LT(heading_error_after_rooms({}), 0.3);
  EXPECT_GT(heading_error_after_rooms(without), 2.0 * heading_error_after_rooms({}));
}

TEST(ScanMatchingTest, HasASaneCovariance) {
  Stage stage(room_walls(), 0.01);
  for (int i = 0; i < 60; ++i) {
    const Pose2 truth{0.01 * i, 0.1, 0.02 * i};
    const Eigen::Matrix3d covariance = stage.drive.go(truth, truth).covariance;
    ASSERT_EQ(covariance, covariance.transpose());
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
    ASSERT_GE(solver.eigenvalues().minCoeff(), -1e-15);
    ASSERT_LT(covariance(0, 0), 0.02 * 0.02);
    ASSERT_LT(covariance(2, 2), radians(2.0) * radians(2.0));
  }
}

TEST(ScanMatchingTest, StandsStillWithoutDrift) {
  Stage stage(room_walls(), 0.05);
  look_around(stage.drive);
  const Pose2 pose = stage.drive.go({}, {}).pose;
  for (int i = 0; i < 200; ++i) ASSERT_EQ(stage.drive.go({}, {}).pose, pose);
}

TEST(ScanMatchingTest, GoesOnByOdometryWhenAScanSaysNothing) {
  Stage stage(room_walls());
  look_around(stage.drive);
  const Pose2 before = stage.drive.go({0.1, 0.0, 0.0}, {0.1, 0.0, 0.0}).pose;
  stage.drive.walls().clear();
  const PoseEstimate blind = stage.drive.go({0.3, 0.0, 0.0}, {0.3, 0.0, 0.0});
  EXPECT_LT(distance(blind.pose, before * Pose2{0.2, 0.0, 0.0}), 1e-4);
  EXPECT_GT(blind.covariance(0, 0), 0.005 * 0.005);
}

TEST(ScanMatchingTest, LetsAScanGoByThatFitsNowhere) {
  Stage stage(room_walls());
  look_around(stage.drive);
  const Pose2 before = stage.drive.go({0.1, 0.0, 0.0}, {0.1, 0.0, 0.0}).pose;
  stage.drive.walls() = {
      {{-2.6, 0.5}, {0.5, -2.1}}, {{0.5, -2.1}, {3.6, 0.5}}, {{3.6, 0.5}, {0.5, 3.1}}, {{0.5, 3.1}, {-2.6, 0.5}}};
  const Pose2 after = stage.drive.go({0.2, 0.0, 0.0}, {0.2, 0.0, 0.0}).pose;
  EXPECT_LT(distance(after, before * Pose2{0.1, 0.0, 0.0}), 1e-4);
}

TEST(ScanMatchingTest, TakesNoHarmFromRangesThatAreNone) {
  RobotModel robot = lidar_robot();
  LidarMapper mapper(robot, 0.05);
  ScanMatching matching(robot, mapper);
  LidarDrive drive(room_walls(), matching, mapper);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  PoseEstimate estimate;
  for (int i = 0; i < 30; ++i) {
    const Pose2 truth{0.02 * i, 0.0, 0.0};
    Frame frame;
    frame.stamp = 0.2 * i;
    frame.odometry = truth;
    frame.scan = drive.scan_at(truth);
    for (std::size_t beam = 0; beam < drive.ranges().size(); beam += 3)
      drive.ranges()[beam] = beam % 2 == 0 ? nan : -infinity;
    if (i == 0) std::fill(drive.ranges().begin(), drive.ranges().end(), nan);
    if (i == 1) frame.scan->ranges = {};
    estimate = matching.update(frame);
    mapper.update(frame, estimate);
  }
  EXPECT_LT(distance(estimate.pose, {0.58, 0.0, 0.0}), 0.01);
}

TEST(ScanMatchingTest, TakesLittleHarmFromWhatMoved) {
  Stage stage(room_walls());
  look_around(stage.drive);
  Walls& walls = stage.drive.walls();
  for (std::size_t i = 8; i < 12; ++i) {  // the pillar
    walls[i].a += Point2(-0.3, 0.2);
    walls[i].b += Point2(-0.3, 0.2);
  }
  walls.push_back({{-1.0, -1.5}, {-1.0, -0.9}});  // a door opened
  for (int i = 1; i <= 40; ++i) {
    const Pose2 truth{0.01 * i, 0.1, 0.01 * i};
    ASSERT_LT(distance(stage.drive.go(truth, {0.0102 * i, 0.1, 0.0095 * i}).pose, truth), 0.02) << i;
  }
}

TEST(ScanMatchingTest, TakesLittleHarmFromAPictureOnTheWall) {
  Stage stage(room_walls());
  look_around(stage.drive);
  stage.drive.walls().push_back({{2.9, -1.0}, {2.9, 1.0}});  // 7 cm before the only wall on that side
  const Pose2 truth{0.3, 0.1, 0.0};
  EXPECT_LT(distance(stage.drive.go(truth, truth).pose, truth), 0.015);
}

TEST(ScanMatchingTest, GivesTheSamePosesForTheSameFrames) {
  const auto run = [] {
    Stage stage(room_walls(), 0.02);
    std::vector<Pose2> poses;
    for (int i = 0; i < 40; ++i) {
      poses.push_back(stage.drive.go({0.01 * i, 0.0, 0.05 * i}, {0.0101 * i, 0.0, 0.051 * i}).pose);
    }
    return poses;
  };
  EXPECT_EQ(run(), run());
}

TEST(ScanMatchingTest, KeepsItsPoseThroughNoiseAndDriftingWheels) {
  Stage stage(room_walls(), 0.03);
  double worst = 0.0;
  Pose2 odometry;
  Pose2 truth;
  for (int i = 0; i < 600; ++i) {
    const Pose2 step{0.02, 0.0, radians(3.0)};
    truth = truth * step;
    odometry = odometry * Pose2{1.02 * step.x, 0.0, 1.03 * step.yaw};
    worst = std::max(worst, distance(stage.drive.go(truth, odometry).pose, truth));
  }
  EXPECT_GT(turn(odometry, truth), radians(30.0));
  EXPECT_LT(worst, 0.03);
}

TEST(ScanMatchingTest, GoesStraightInTheDarkOnceItKnowsItsWheels) {
  Stage stage(room_walls(), 0.01);
  Pose2 odometry;
  Pose2 truth;
  const auto go = [&](const Pose2& told) {
    odometry = odometry * told;
    truth = truth * Pose2{1.02 * told.x, 0.0, 0.97 * told.yaw + 0.05 * told.x};
    return stage.drive.go(truth, odometry).pose;
  };
  Pose2 found;
  for (int i = 0; i < 960; ++i) found = go({0.02, 0.0, radians(i / 120 % 2 == 0 ? 3.0 : -3.0)});  // figures of eight
  stage.drive.walls().clear();
  const Pose2 begin = truth;
  const Pose2 told_begin = odometry;
  const Pose2 found_begin = found;
  for (int i = 0; i < 100; ++i) found = go({0.03, 0.0, 0.0});
  const Pose2 way = inverse(begin) * truth;
  EXPECT_GT(distance(way, inverse(told_begin) * odometry), 0.2);
  EXPECT_LT(distance(way, inverse(found_begin) * found), 0.08);
}

}  // namespace
}  // namespace scrubjay
