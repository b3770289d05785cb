#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <scrubjay/geometry/random.hpp>
#include <scrubjay/geometry/segment2.hpp>
#include <scrubjay/planning/path_tracker.hpp>
#include <string>

#include "planning/ideal_drive.hpp"

namespace scrubjay {
namespace {

using test::IdealDrive;

using Path = std::vector<Point2>;

double distance_to(const Path& path, const Point2& p) {
  double nearest = 1e9;
  for (std::size_t i = 1; i < path.size(); ++i) {
    nearest = std::min(nearest, squared_distance({path[i - 1], path[i]}, p));
  }
  return std::sqrt(nearest);
}

double length_of(const Path& path) {
  double length = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) length += (path[i] - path[i - 1]).norm();
  return length;
}

struct Ride {
  bool arrived = false;
  Pose2 end;
  double time = 0.0;       // [s]
  double farthest = 0.0;   // from the path [m]
  double overshoot = 0.0;  // how far from the end it was after it had been nearest [m]
};

Ride ride(const RobotModel& robot, const Pose2& start, const Path& path, std::optional<double> heading = std::nullopt,
          const PathTrackerParams& params = {}) {
  IdealDrive drive(robot, start);
  PathTracker tracker(robot, params);
  tracker.follow(path, heading);
  Ride result;
  while (!result.arrived && drive.stamp() < 300.0) {
    const PathTracker::Step step = tracker.track(drive.pose());
    EXPECT_LE(std::fabs(step.motion.linear), tracker.params().max_linear + 1e-12);
    EXPECT_LE(std::fabs(step.motion.angular), tracker.params().max_angular + 1e-12);
    EXPECT_GE(step.motion.linear, 0.0);
    const double across = 0.5 * robot.drive.wheel_separation * std::fabs(step.motion.angular);
    EXPECT_LE(step.motion.linear + across, robot.max_wheel_speed + 1e-3);
    result.arrived = step.arrived;
    drive.drive(step.motion);
    result.farthest = std::max(result.farthest, distance_to(path, drive.pose().position()));
  }
  result.time = drive.stamp();
  for (int i = 0; i < 200; ++i) drive.drive({});  // until it stands
  result.farthest = std::max(result.farthest, distance_to(path, drive.pose().position()));
  result.end = drive.pose();
  return result;
}

const std::vector<Path>& paths() {
  static const std::vector<Path> all{
      {{0, 0}, {3, 0}},                                                      // straight
      {{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 2}},                              // stairs
      {{0, 0}, {1, 0}, {1.9, 0.3}, {2.5, 1.0}, {2.7, 2.0}, {2.7, 4.0}},      // a wide turn
      {{0, 0}, {1, 0}, {0, 0.1}, {1, 0.2}},                                  // hairpins
      {{0, 0}, {0.3, 0.1}, {0.4, 0.4}, {0.7, 0.5}, {0.8, 0.8}, {1.1, 0.9}},  // short legs
      {{0, 0}, {1, 0}, {1, 1}, {0.5, 1}, {0.5, -1}},                         // crosses itself
      {{0, 0}, {0.04, 0}, {0.04, 0.0}, {0.6, 0.02}},                         // points that coincide
  };
  return all;
}

TEST(PathTrackerTest, StaysOnThePathAndArrives) {
  for (const RobotModel& robot : {test::burger(), test::roomba()}) {
    for (std::size_t i = 0; i < paths().size(); ++i) {
      const Path& path = paths()[i];
      const Ride result = ride(robot, {0, 0, 0}, path);
      SCOPED_TRACE("path " + std::to_string(i) + ", radius " + std::to_string(robot.radius));
      EXPECT_TRUE(result.arrived);
      EXPECT_LT(result.farthest, 0.05);
      EXPECT_LT((result.end.position() - path.back()).norm(), 0.06);
      EXPECT_LT(result.time, 6.0 + 4.0 * length_of(path) / robot.max_linear_speed);
    }
  }
}

TEST(PathTrackerTest, StartsWithAnyHeadingAndEndsWithTheWantedOne) {
  Random random(1);
  for (const RobotModel& robot : {test::burger(), test::roomba()}) {
    for (int i = 0; i < 40; ++i) {
      const double yaw = random.uniform(-kPi, kPi);
      const double wanted = random.uniform(-kPi, kPi);
      const Path& path = paths()[random.below(static_cast<std::uint32_t>(paths().size()))];
      const Pose2 start{random.uniform(-0.03, 0.03), random.uniform(-0.03, 0.03), yaw};
      const Ride result = ride(robot, start, path, wanted);
      EXPECT_TRUE(result.arrived);
      EXPECT_LT(result.farthest, 0.07);
      EXPECT_LT((result.end.position() - path.back()).norm(), 0.07);
      EXPECT_LT(std::fabs(angle_difference(result.end.yaw, wanted)), radians(5.0));
    }
  }
}

TEST(PathTrackerTest, StaysOnRandomPaths) {
  Random random(2);
  for (const RobotModel& robot : {test::burger(), test::roomba()}) {
    for (int i = 0; i < 60; ++i) {
      Path path{{0.0, 0.0}};
      double way = random.uniform(-kPi, kPi);
      for (int leg = 0; leg < 8; ++leg) {
        path.push_back(path.back() + random.uniform(0.05, 1.0) * direction(way));
        way += random.uniform(-2.0, 2.0);
      }
      const Ride result = ride(robot, {0, 0, random.uniform(-kPi, kPi)}, path);
      EXPECT_TRUE(result.arrived) << i;
      EXPECT_LT(result.farthest, 0.065) << i;
      EXPECT_LT((result.end.position() - path.back()).norm(), 0.06) << i;
    }
  }
}

TEST(PathTrackerTest, DrivesAStraightPathAtItsSpeed) {
  for (const RobotModel& robot : {test::burger(), test::roomba()}) {
    const Ride result = ride(robot, {0, 0, 0}, {{0, 0}, {5, 0}});
    EXPECT_LT(result.time, 5.0 / robot.max_linear_speed + 4.0);
  }
  PathTrackerParams slow;
  slow.max_linear = 0.1;
  EXPECT_GT(ride(test::roomba(), {0, 0, 0}, {{0, 0}, {1, 0}}, std::nullopt, slow).time, 9.0);
}

TEST(PathTrackerTest, NeverCommandsMoreThanTheRobotCan) {
  PathTrackerParams rash;
  rash.max_linear = 10.0;
  rash.max_angular = 100.0;
  const PathTracker tracker(test::burger(), rash);
  EXPECT_EQ(tracker.params().max_linear, 0.22);
  EXPECT_EQ(tracker.params().max_angular, 2.84);
}

TEST(PathTrackerTest, KnowsWhatIsStillToBeDriven) {
  PathTracker tracker(test::burger());
  const Path path{{0, 0}, {1, 0}, {1, 1}};
  tracker.follow(path);
  tracker.track({0.4, 0.02, 0.0});
  ASSERT_EQ(tracker.ahead().size(), 3u);
  EXPECT_NEAR((tracker.ahead().front() - Point2(0.4, 0.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(tracker.remaining(), 1.6, 1e-12);
  EXPECT_NEAR(tracker.off_path({0.4, 0.02}), 0.02, 1e-12);
  tracker.track({1.0, 0.5, 0.0});
  ASSERT_EQ(tracker.ahead().size(), 2u);
  EXPECT_NEAR(tracker.remaining(), 0.5, 1e-12);
}

TEST(PathTrackerTest, HasArrivedWhereThereIsNothingToDrive) {
  PathTracker tracker(test::burger());
  EXPECT_TRUE(tracker.track({}).arrived);
  tracker.follow({});
  EXPECT_TRUE(tracker.track({}).arrived);
  tracker.follow({{0.01, 0.0}});
  EXPECT_TRUE(tracker.track({}).arrived);
  tracker.follow({{0.01, 0.0}}, 1.0);
  EXPECT_GT(tracker.track({}).motion.angular, 0.0);
  EXPECT_TRUE(tracker.track({0.0, 0.0, 1.0}).arrived);
}

}  // namespace
}  // namespace scrubjay
