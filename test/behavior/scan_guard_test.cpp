#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <scrubjay/behavior/scan_guard.hpp>
#include <scrubjay/geometry/segment2.hpp>
#include <vector>

namespace scrubjay {
namespace {

RobotModel burger() {
  RobotModel robot;
  robot.radius = 0.105;
  robot.max_linear_speed = 0.22;
  robot.lidar = LidarModel{};
  return robot;
}

// A scan of straight walls, given in the robot's frame.
class ScanGuardTest : public testing::Test {
 protected:
  Frame frame_that_sees(const std::vector<Segment2>& walls) {
    const LidarModel& lidar = *robot.lidar;
    ranges.assign(static_cast<std::size_t>(lidar.beams), 0.0f);
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      const Point2 beam = direction(static_cast<double>(i) * lidar.angle_increment);
      double nearest = 100.0;
      for (const Segment2& wall : walls) nearest = std::min(nearest, ray_hit(wall, lidar.mount.position(), beam));
      ranges[i] = static_cast<float>(nearest);
    }
    Frame frame;
    frame.scan = LaserScan{.angle_increment = lidar.angle_increment,
                           .range_min = lidar.min_range,
                           .range_max = lidar.max_range,
                           .ranges = ranges};
    return frame;
  }
  static Segment2 wall_ahead(double x) { return {{x, -1.0}, {x, 1.0}}; }

  RobotModel robot = burger();
  ScanGuardParams params;
  ScanGuard guard{robot, params};
  std::vector<float> ranges;
  const Motion full{0.22, 0.5};
};

TEST_F(ScanGuardTest, LetsARobotDriveThatSeesNothingNear) {
  EXPECT_EQ(guard.limit(full), full);
  guard.sense(frame_that_sees({wall_ahead(0.3)}));
  EXPECT_EQ(guard.limit(full), full);
}

TEST_F(ScanGuardTest, StopsTheDiscBeforeAWallAndLetsItTurn) {
  guard.sense(frame_that_sees({wall_ahead(robot.radius + params.margin)}));
  EXPECT_NEAR(guard.limit(full).linear, 0.0, 1e-3);
  EXPECT_EQ(guard.limit(full).angular, full.angular);
  EXPECT_EQ(guard.limit({-0.2, 0.0}).linear, -0.2);
}

TEST_F(ScanGuardTest, NeedsTheReactionTimeAtLeastToGetThere) {
  guard.sense(frame_that_sees({wall_ahead(robot.radius + params.margin + 0.03)}));
  EXPECT_NEAR(guard.limit(full).linear, 0.03 / params.reaction, 0.01);
}

TEST_F(ScanGuardTest, LooksBackwardsForARobotThatBacksUp) {
  guard.sense(frame_that_sees({wall_ahead(-0.155)}));  // nearer, this lidar sees nothing
  EXPECT_NEAR(guard.limit({-0.2, 0.0}).linear, -(0.155 - robot.radius - params.margin) / params.reaction, 0.01);
  EXPECT_EQ(guard.limit(full), full);
}

TEST_F(ScanGuardTest, WallsBesideItsWayAreNotInIt) {
  const Segment2 left{{-1.0, 0.1}, {1.0, 0.1}};  // 5 mm nearer than the disc is wide: a reading's noise
  const Segment2 right{{-1.0, -0.12}, {1.0, -0.12}};
  guard.sense(frame_that_sees({left, right}));
  EXPECT_EQ(guard.limit(full), full);
}

TEST_F(ScanGuardTest, SeesAThinLegAheadThatABeamHits) {
  guard.sense(frame_that_sees({{{0.16, -0.01}, {0.16, 0.01}}}));
  EXPECT_LT(guard.limit(full).linear, 0.22);
}

TEST_F(ScanGuardTest, CountsTheWayDrivenSinceTheScan) {
  guard.sense(frame_that_sees({wall_ahead(0.2)}));
  const double before = guard.limit(full).linear;
  Frame rolling;
  rolling.left_travel = rolling.right_travel = 0.05;
  guard.sense(rolling);
  EXPECT_NEAR(guard.limit(full).linear, std::min(before, (0.2 - 0.05 - robot.radius - params.margin) / 0.3), 0.01);
  EXPECT_LT(guard.limit(full).linear, before);
}

TEST_F(ScanGuardTest, TakesBeamsOfATurningLidarForAsOldAsTheTurn) {
  Frame rolling;
  rolling.left_travel = rolling.right_travel = 0.04;
  guard.sense(rolling);
  Frame frame = frame_that_sees({wall_ahead(0.18)});
  frame.scan->time_increment = 0.2 / 360;
  guard.sense(frame);
  EXPECT_NEAR(guard.limit(full).linear, (0.18 - 0.04 - robot.radius - params.margin) / params.reaction, 0.01);
}

TEST_F(ScanGuardTest, StopsBeforeWhatIsTooNearToBeMeasured) {
  Frame frame = frame_that_sees({});
  ranges[0] = -std::numeric_limits<float>::infinity();
  guard.sense(frame);
  EXPECT_EQ(guard.limit(full).linear, 0.0);
}

TEST_F(ScanGuardTest, ReadingsThatAreNoReturnsAreNothing) {
  for (const float nothing : {0.0f, 4.0f, std::numeric_limits<float>::quiet_NaN()}) {
    const Frame frame = frame_that_sees({});
    std::fill(ranges.begin(), ranges.end(), nothing);
    guard.sense(frame);
    EXPECT_EQ(guard.limit(full), full) << nothing;
  }
}

}  // namespace
}  // namespace scrubjay
