#include <gtest/gtest.h>

#include <limits>
#include <scrubjay/behavior/scan_outlook.hpp>
#include <vector>

namespace scrubjay::test {
namespace {

/// A lidar in the middle of the robot, 1 degree a beam.
LidarModel central_lidar() {
  LidarModel lidar;
  lidar.mount = {};
  return lidar;
}

/// A scan of 360 beams without returns, but those that are set.
struct HandmadeScan {
  explicit HandmadeScan(float everywhere = 0.0f) : ranges(360, everywhere) {
    scan.angle_increment = radians(1.0);
    scan.range_min = 0.12;
    scan.range_max = 3.5;
  }
  ScanOutlook seen(double radius, const Twist2& twist = {}, const LidarModel& lidar = central_lidar()) {
    scan.ranges = ranges;
    return ScanOutlook(scan, lidar, twist, 0.2, radius);
  }
  std::vector<float> ranges;
  LaserScan scan;
};

TEST(ScanOutlookTest, NothingIsClearBeforeAScan) {
  EXPECT_EQ(ScanOutlook().farthest(), 0.0);
}

TEST(ScanOutlookTest, NoReturnIsClearAsFarAsTheModelSays) {
  HandmadeScan scan;
  EXPECT_DOUBLE_EQ(scan.seen(0.1).clear(5), 3.4);
  LidarModel silent = central_lidar();
  silent.clear_range = 0.0;
  EXPECT_DOUBLE_EQ(scan.seen(0.1, {}, silent).farthest(), 0.0);
}

TEST(ScanOutlookTest, ADiscTouchesWhatIsBesideTheRay) {
  HandmadeScan scan;
  scan.ranges[0] = 1.0f;
  const ScanOutlook outlook = scan.seen(0.25);
  EXPECT_NEAR(outlook.clear(0), 0.75, 1e-6);
  // 10 degrees aside, the point is 0.1736 m beside the way: by hand, cos 10 - sqrt(0.25^2 - sin^2 10).
  EXPECT_NEAR(outlook.clear(2), 0.98480775 - 0.17988, 1e-4);
  EXPECT_NEAR(outlook.clear(70), 0.98480775 - 0.17988, 1e-4) << "on the other side, too";
  EXPECT_DOUBLE_EQ(outlook.clear(3), 3.25) << "15 degrees aside it passes";
}

TEST(ScanOutlookTest, WhatTouchesAlreadyBlocksOnlyTheWaysTowardsIt) {
  HandmadeScan scan;
  scan.ranges[90] = 0.15f;
  const ScanOutlook outlook = scan.seen(0.2);
  EXPECT_DOUBLE_EQ(outlook.clear(18), 0.0) << "left";
  EXPECT_DOUBLE_EQ(outlook.clear(1), 0.0) << "5 degrees towards it";
  EXPECT_GT(outlook.clear(71), 3.0) << "5 degrees away from it";
  EXPECT_GT(outlook.clear(54), 3.0) << "right";
}

TEST(ScanOutlookTest, BetweenBearingsTheLessCounts) {
  HandmadeScan scan;
  scan.ranges[5] = 1.0f;
  const ScanOutlook outlook = scan.seen(0.05);
  EXPECT_NEAR(outlook.clear(1), 0.95, 1e-6);
  EXPECT_GT(outlook.clear(2), 3.0);
  EXPECT_NEAR(outlook.clear_along(radians(7.0)), 0.95, 1e-6);
  EXPECT_NEAR(outlook.clear_along(radians(3.0)), 0.95, 1e-6);
  EXPECT_GT(outlook.clear_along(radians(12.0)), 3.0);
  EXPECT_GT(outlook.clear_along(radians(-2.5)), 3.0) << "from the last bearing to the first";
}

TEST(ScanOutlookTest, TheSensorSitsWhereTheModelSays) {
  HandmadeScan scan;
  scan.ranges[0] = 1.0f;
  LidarModel behind = central_lidar();
  behind.mount = {-0.3, 0.0, 0.0};
  EXPECT_NEAR(scan.seen(0.1, {}, behind).clear(0), 0.6, 1e-6);
  behind.mount = {0.0, 0.0, radians(90.0)};
  EXPECT_NEAR(scan.seen(0.1, {}, behind).clear(18), 0.9, 1e-6);
}

TEST(ScanOutlookTest, BeamsStartFromWhereTheRobotWas) {
  HandmadeScan scan;
  scan.scan.time_increment = 0.2 / 360;
  scan.ranges[0] = 1.0f;  // measured 0.2 s before
  EXPECT_NEAR(scan.seen(0.1, {0.5, 0.0, 0.0}).clear(0), 0.8, 1e-6);
  // After a turn to the left by 20 degrees, what was ahead is to the right.
  const ScanOutlook turned = scan.seen(0.1, {0.0, 0.0, radians(100.0)});
  EXPECT_NEAR(turned.clear(68), 0.9, 1e-6);
  EXPECT_GT(turned.clear(0), 3.0);
  // A scan that was measured at once is as it is.
  scan.scan.time_increment = 0.0;
  EXPECT_NEAR(scan.seen(0.1, {0.5, 0.0, 0.0}).clear(0), 0.9, 1e-6);
}

TEST(ScanOutlookTest, WhatIsTooNearToBeMeasuredBlocks) {
  HandmadeScan scan;
  scan.ranges[0] = -std::numeric_limits<float>::infinity();
  EXPECT_DOUBLE_EQ(scan.seen(0.1).clear(0), scan.scan.range_min - 0.1);
}

TEST(ScanOutlookTest, WhatIsNoNumberIsNoReturn) {
  HandmadeScan scan(std::numeric_limits<float>::quiet_NaN());
  EXPECT_DOUBLE_EQ(scan.seen(0.1).farthest(), 3.4);
}

}  // namespace
}  // namespace scrubjay::test
