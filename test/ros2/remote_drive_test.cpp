#include <gtest/gtest.h>

#include <cmath>
#include <scrubjay/ros2/remote_drive.hpp>
#include <string>

#include "planning/house.hpp"
#include "ros2/told.hpp"

namespace scrubjay::ros {
namespace {

using test::House;
using test::IdealDrive;
using test::MapDrawing;

constexpr int kScale = 10;  // characters of half a metre

MapDrawing drawn(const std::vector<std::string>& rows) {
  return MapDrawing(rows, 0.05, kScale);
}

const std::vector<std::string> kTwoRooms{"############",  //
                                         "#....#.....#",  //
                                         "#.a..#..b..#",  //
                                         "#....#.....#",  //
                                         "#.......c..#",  //
                                         "#....#.....#",  //
                                         "############"};

/// A robot that stands in a room, at any moment.
class RemoteDriveTest : public ::testing::Test {
 protected:
  Decision decide_at(double stamp, bool bumped = false) {
    Frame frame;
    frame.stamp = stamp;
    frame.bump_left = bumped;
    PoseEstimate estimate;
    estimate.pose = {room.point('a').x(), room.point('a').y(), 0.0};
    return drive.decide({frame, estimate, std::as_const(room).view(), room.all()});
  }
  std::string doing_at(double stamp) { return decide_at(stamp).doing; }
  void tell(double linear, double angular) { commands.take_twist(told_velocity(linear, angular)); }
  void send_to(const Pose2& pose) { commands.take_goal(told_goal(pose)); }
  Pose2 mark(char name, double yaw = 0.0) const { return {room.point(name).x(), room.point(name).y(), yaw}; }

  RobotModel robot = test::roomba();
  MapDrawing room = drawn(kTwoRooms);
  Commands commands{{robot.max_linear_speed, robot.max_angular_speed}};
  RemoteDrive drive{robot, commands};
};

TEST_F(RemoteDriveTest, StandsUntilItIsTold) {
  const Decision decision = decide_at(0.0);
  EXPECT_EQ(decision.motion, Motion{});
  EXPECT_FALSE(decision.done);
  EXPECT_EQ(std::string(decision.doing), "waiting");
  EXPECT_TRUE(drive.plan().empty());
}

TEST_F(RemoteDriveTest, DrivesAsItIsToldForHalfASecondExactly) {
  decide_at(9.75);
  tell(0.2, -0.5);
  const Motion told{0.2, -0.5};
  EXPECT_EQ(decide_at(10.0).motion, told);
  EXPECT_EQ(decide_at(10.25).motion, told);
  EXPECT_EQ(decide_at(std::nextafter(10.5, 0.0)).motion, told);
  EXPECT_EQ(decide_at(10.5).motion, Motion{});
  EXPECT_EQ(decide_at(11.0).motion, Motion{}) << "nor does it begin again";
}

TEST_F(RemoteDriveTest, AVelocityThatIsToldAgainGoesOn) {
  for (int i = 0; i <= 20; ++i) {
    tell(0.1, 0.0);
    EXPECT_EQ(decide_at(0.25 * i).motion, (Motion{0.1, 0.0}));
  }
  EXPECT_EQ(decide_at(5.25).motion, (Motion{0.1, 0.0}));
  EXPECT_EQ(decide_at(5.5).motion, Motion{});
}

TEST_F(RemoteDriveTest, StopsAtOnceWhereItIsToldTo) {
  tell(0.2, 0.0);
  decide_at(1.0);
  tell(0.0, 0.0);
  EXPECT_EQ(decide_at(1.015).motion, Motion{});
}

TEST_F(RemoteDriveTest, GarbageRenewsNoVelocity) {
  tell(0.2, 0.0);
  decide_at(1.0);
  tell(std::nan(""), 0.0);
  tell(1e9, 0.0);
  commands.take_twist(Commands::Bytes());
  EXPECT_EQ(decide_at(1.25).motion, (Motion{0.2, 0.0}));
  EXPECT_EQ(decide_at(1.5).motion, Motion{});
}

TEST_F(RemoteDriveTest, TheTimeoutIsWhatItIsSetTo) {
  RemoteDrive patient(robot, commands, {.timeout = 2.0});
  tell(0.2, 0.0);
  Frame frame;
  const PoseEstimate estimate;
  const auto motion_at = [&](double stamp) {
    frame.stamp = stamp;
    return patient.decide({frame, estimate, std::as_const(room).view(), room.all()}).motion;
  };
  EXPECT_EQ(motion_at(0.0), (Motion{0.2, 0.0}));
  EXPECT_EQ(motion_at(1.75), (Motion{0.2, 0.0}));
  EXPECT_EQ(motion_at(2.0), Motion{});
}

TEST_F(RemoteDriveTest, TheNewerOfGoalAndVelocityHasTheSay) {
  tell(0.1, 0.0);
  EXPECT_EQ(decide_at(0.0).motion, (Motion{0.1, 0.0}));
  send_to(mark('b'));
  EXPECT_EQ(doing_at(0.015), "to a goal");
  EXPECT_FALSE(drive.plan().empty());
  tell(-0.1, 0.0);
  EXPECT_EQ(decide_at(0.03).motion, (Motion{-0.1, 0.0}));
  EXPECT_TRUE(drive.plan().empty());
  EXPECT_EQ(decide_at(2.0).motion, Motion{}) << "the goal is forgotten, not put off";
  send_to(mark('c'));
  EXPECT_EQ(doing_at(2.015), "to a goal");
}

TEST_F(RemoteDriveTest, TheNewerHasTheSayAlsoWhereBothComeWithinATick) {
  tell(0.1, 0.0);
  send_to(mark('b'));
  EXPECT_EQ(doing_at(0.0), "to a goal");
  send_to(mark('c'));
  tell(0.1, 0.0);
  EXPECT_EQ(doing_at(0.015), "driven by others");
}

TEST_F(RemoteDriveTest, ToBeToldToStandOutOfSilenceEndsTheWayToAGoal) {
  send_to(mark('b'));
  EXPECT_EQ(doing_at(2.0), "to a goal");
  tell(0.0, 0.0);
  EXPECT_EQ(decide_at(2.015).motion, Motion{});
  EXPECT_EQ(doing_at(2.03), "waiting");
}

TEST_F(RemoteDriveTest, ToBeToldToStandBehindAVelocityEndsTheWayToAGoal) {
  tell(0.1, 0.0);
  decide_at(2.0);
  send_to(mark('b'));
  EXPECT_EQ(doing_at(2.015), "to a goal");
  tell(0.0, 0.0);
  EXPECT_EQ(doing_at(2.03), "waiting");
}

TEST_F(RemoteDriveTest, AJoystickAtRestLeavesAGoalAlone) {
  for (double stamp = 1.0; stamp < 2.0; stamp += 0.4) {
    tell(0.0, 0.0);
    EXPECT_EQ(doing_at(stamp), "waiting");
  }
  send_to(mark('b'));
  for (double stamp = 2.0; stamp < 4.0; stamp += 0.4) {
    tell(0.0, 0.0);
    EXPECT_EQ(doing_at(stamp), "to a goal");
  }
  tell(0.1, 0.0);
  EXPECT_EQ(doing_at(4.0), "driven by others") << "moved, it takes over";
  tell(0.0, 0.0);
  EXPECT_EQ(doing_at(4.4), "waiting") << "and let go, the goal is forgotten";
}

TEST_F(RemoteDriveTest, ToBeToldToStandIsAWishAgainBehindASilence) {
  tell(0.0, 0.0);
  decide_at(1.0);
  send_to(mark('b'));
  EXPECT_EQ(doing_at(1.25), "to a goal");
  tell(0.0, 0.0);
  EXPECT_EQ(doing_at(1.5), "waiting") << "half a second is a silence";
}

TEST_F(RemoteDriveTest, ToBeSentToTheDockEndsWhatWasWantedBefore) {
  send_to(mark('b'));
  EXPECT_EQ(doing_at(0.0), "to a goal");
  commands.take_dock(encode(Empty{}));
  EXPECT_EQ(doing_at(0.015), "waiting");
  tell(0.1, 0.0);
  decide_at(0.03);
  commands.take_dock(encode(Empty{}));
  EXPECT_EQ(decide_at(0.045).motion, Motion{});
  commands.take_dock(encode(Empty{}));
  send_to(mark('b'));
  EXPECT_EQ(doing_at(0.06), "to a goal") << "what comes behind it counts";
}

TEST_F(RemoteDriveTest, AVelocityFromBeforeAGoalDoesNotComeBackAfterIt) {
  tell(0.2, 0.0);
  decide_at(0.0);
  send_to(mark('b'));
  decide_at(0.015);
  decide_at(0.03, /*bumped=*/true);
  EXPECT_EQ(decide_at(0.045).motion, Motion{});
}

TEST_F(RemoteDriveTest, AGoalIsGivenUpAtABump) {
  send_to(mark('b'));
  EXPECT_EQ(doing_at(0.0), "to a goal");
  const Decision bumped = decide_at(0.015, /*bumped=*/true);
  EXPECT_EQ(bumped.motion, Motion{});
  EXPECT_EQ(std::string(bumped.doing), "bumped on the way to a goal");
  EXPECT_TRUE(drive.plan().empty());
  const Decision after = decide_at(0.03);
  EXPECT_EQ(after.motion, Motion{});
  EXPECT_EQ(std::string(after.doing), "waiting");
}

TEST_F(RemoteDriveTest, ABumpDoesNotTakeTheWheelFromWhoDrives) {
  tell(-0.1, 0.0);
  EXPECT_EQ(decide_at(0.0, /*bumped=*/true).motion, (Motion{-0.1, 0.0})) << "back out of it";
}

TEST_F(RemoteDriveTest, SaysWhenThereIsNoWay) {
  send_to({room.point('#').x(), room.point('#').y(), 0.0});
  const Decision decision = decide_at(0.0);
  EXPECT_EQ(decision.motion, Motion{});
  EXPECT_EQ(std::string(decision.doing), "no way to the goal");
  EXPECT_EQ(doing_at(0.015), "waiting");
}

/// A map that covers more from call to call, of open floor nobody knows.
MapDrawing unknown(std::size_t width) {
  return drawn(std::vector<std::string>(3, std::string(width, '?')));
}

std::string drive_on(RemoteDrive& drive, const MapDrawing& map, const Pose2& pose, double stamp) {
  Frame frame;
  frame.stamp = stamp;
  PoseEstimate estimate;
  estimate.pose = pose;
  return drive.decide({frame, estimate, map.view(), map.all()}).doing;
}

TEST(RemoteDriveBeyondTheMapTest, OneThatFeelsItsWayGoesOnAsTheMapGrows) {
  const RobotModel robot = test::roomba();
  Commands commands({robot.max_linear_speed, robot.max_angular_speed});
  RemoteDrive drive(robot, commands);
  commands.take_goal(told_goal({3.0, 0.75, 0.0}));
  EXPECT_EQ(drive_on(drive, unknown(3), {0.75, 0.75, 0.0}, 0.0), "to a goal");
  EXPECT_LE(drive.plan().back().x(), 1.5) << "as far as the map goes";
  EXPECT_EQ(drive_on(drive, unknown(5), {1.3, 0.75, 0.0}, 1.0), "to a goal");
  EXPECT_GT(drive.plan().back().x(), 2.4);
  EXPECT_EQ(drive_on(drive, unknown(8), {2.3, 0.75, 0.0}, 2.0), "to a goal");
  EXPECT_EQ(drive.plan().back(), Point2(3.0, 0.75));
  EXPECT_EQ(drive_on(drive, unknown(8), {3.0, 0.75, 0.0}, 3.0), "at the goal");
}

TEST(RemoteDriveBeyondTheMapTest, ThereIsNoWayWhereTheMapDoesNotGrow) {
  const RobotModel robot = test::roomba();
  Commands commands({robot.max_linear_speed, robot.max_angular_speed});
  RemoteDrive drive(robot, commands);
  commands.take_goal(told_goal({3.0, 0.75, 0.0}));
  EXPECT_EQ(drive_on(drive, unknown(3), {0.75, 0.75, 0.0}, 0.0), "to a goal");
  EXPECT_EQ(drive_on(drive, unknown(3), {1.475, 0.75, 0.0}, 1.0), "no way to the goal");
  EXPECT_EQ(drive_on(drive, unknown(3), {1.475, 0.75, 0.0}, 1.1), "waiting");
}

TEST(RemoteDriveBeyondTheMapTest, OneThatSeesStaysOnTheMap) {
  RobotModel robot = test::burger();
  robot.lidar.emplace();
  Commands commands({robot.max_linear_speed, robot.max_angular_speed});
  RemoteDrive drive(robot, commands);
  const MapDrawing map = drawn({"...", "...", "..."});
  commands.take_goal(told_goal({3.0, 0.75, 0.0}));
  EXPECT_EQ(drive_on(drive, map, {0.75, 0.75, 0.0}, 0.0), "no way to the goal");
}

/// Ticks until it waits again, or a minute; says what it did last before.
std::string drive_until_it_waits(House& house, RemoteDrive& drive) {
  std::string last;
  for (std::string doing; doing != "waiting" && house.stamp() < 60.0;) {
    last = doing;
    house.tick([&](const Situation& now) {
      const Decision decision = drive.decide(now);
      EXPECT_FALSE(decision.done);
      doing = decision.doing;
      return decision.motion;
    });
  }
  return last;
}

TEST(RemoteDriveInAHouseTest, DrivesToAGoalThroughADoorAndStaysThere) {
  const MapDrawing map = drawn(kTwoRooms);
  for (RobotModel robot : {test::burger(), test::roomba()}) {
    if (!robot.open_interface) robot.lidar.emplace();
    Commands commands({robot.max_linear_speed, robot.max_angular_speed});
    RemoteDrive drive(robot, commands);
    House house(robot, map, map, {map.point('a').x(), map.point('a').y(), 2.0});
    const Pose2 goal{map.point('b').x(), map.point('b').y(), -1.0};
    commands.take_goal(told_goal(goal));
    EXPECT_EQ(drive_until_it_waits(house, drive), "at the goal");
    EXPECT_LE((house.pose().position() - goal.position()).norm(), 0.06);
    EXPECT_LE(std::fabs(angle_difference(house.pose().yaw, goal.yaw)), radians(4.0));
    EXPECT_GT(house.nearest(), robot.radius);
  }
}

TEST(RemoteDriveInAHouseTest, OnlyARobotWithoutALidarCrossesWhatNobodyKnows) {
  const MapDrawing truth = drawn(kTwoRooms);
  for (RobotModel robot : {test::burger(), test::roomba()}) {
    if (!robot.open_interface) robot.lidar.emplace();
    MapDrawing known = truth;
    known.set({{30, 0}, {120, 70}}, '?');
    Commands commands({robot.max_linear_speed, robot.max_angular_speed});
    RemoteDrive drive(robot, commands);
    House house(robot, truth, known, {truth.point('a').x(), truth.point('a').y(), 0.0}, 0.5);
    commands.take_goal(told_goal({truth.point('c').x(), truth.point('c').y(), 0.0}));
    EXPECT_EQ(drive_until_it_waits(house, drive), robot.lidar ? "no way to the goal" : "at the goal");
  }
}

TEST(RemoteDriveInAHouseTest, DrivesAsFarAsItIsTold) {
  const MapDrawing map = drawn(kTwoRooms);
  const RobotModel robot = test::roomba();
  Commands commands({robot.max_linear_speed, robot.max_angular_speed});
  RemoteDrive drive(robot, commands);
  const Pose2 start{map.point('a').x(), map.point('a').y(), 0.0};
  House house(robot, map, map, start);
  commands.take_twist(told_velocity(0.2, 0.0));
  while (house.stamp() < 3.0) house.tick([&](const Situation& now) { return drive.decide(now).motion; });
  // Half a second, and one tick in which it is found to be over; speeding up and braking are all but alike.
  EXPECT_NEAR(house.pose().x - start.x, 0.2 * 0.5, 0.02);
}

}  // namespace
}  // namespace scrubjay::ros
