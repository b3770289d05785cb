#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <io/packed.hpp>
#include <scrubjay/io/carmen_robot.hpp>

namespace scrubjay {
namespace {

const char* const kLog =
    "FLASER 3 1 2 90 0 0 0 0 0 0 1 host 1\n"
    "ODOM 0.5 0 0 0 0 0 1.5 host 1.5\n"
    "FLASER 3 4 5 6 9 9 0 1 0 0 2 host 2\n";

TEST(CarmenRobotTest, GivesAFrameForEachRecord) {
  const CarmenLog log = parse_carmen_log(unpacked(kLog), "a.log");
  CarmenRobot robot(log);
  const auto first = robot.next();
  ASSERT_TRUE(first && first->scan && first->odometry);
  EXPECT_EQ(first->stamp, 1.0);
  EXPECT_EQ(*first->odometry, Pose2{});
  EXPECT_THAT(first->scan->ranges, testing::ElementsAre(1.f, 2.f, 90.f));
  EXPECT_EQ(first->scan->time_increment, 0.0);
  EXPECT_TRUE(first->scan->returned(2.f));
  EXPECT_FALSE(first->scan->returned(90.f)) << "farther than the laser measures";
  EXPECT_FALSE(first->scan->returned(0.f)) << "no range at all";
  robot.drive({});
  const auto between = robot.next();
  ASSERT_TRUE(between && between->odometry);
  EXPECT_FALSE(between->scan);
  EXPECT_EQ(between->odometry->x, 0.5);
  const auto last = robot.next();
  ASSERT_TRUE(last && last->scan);
  EXPECT_EQ(last->odometry->x, 1.0) << "by the wheels, not by the log's poses";
  EXPECT_FALSE(robot.next());
  EXPECT_FALSE(robot.next());
}

TEST(CarmenRobotTest, HasALidarAndNoBumper) {
  const CarmenLog log = parse_carmen_log(unpacked(kLog), "a.log");
  const RobotModel model = robot_of(log, 0.3);
  EXPECT_FALSE(model.open_interface);
  EXPECT_FALSE(model.has_light_sensors);
  EXPECT_EQ(model.radius, 0.3);
  ASSERT_TRUE(model.lidar);
  EXPECT_EQ(model.lidar->beams, 3);
  EXPECT_EQ(model.lidar->clear_range, 0.0) << "what doesn't come back says nothing";
}

}  // namespace
}  // namespace scrubjay
