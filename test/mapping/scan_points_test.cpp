#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <scrubjay/error.hpp>
#include <scrubjay/geometry/random.hpp>
#include <scrubjay/mapping/scan_points.hpp>

namespace scrubjay {
namespace {

constexpr float kNoEcho = std::numeric_limits<float>::infinity();
constexpr float kNoRange = std::numeric_limits<float>::quiet_NaN();

LidarModel lidar() {
  LidarModel model;
  model.mount = {0.1, 0.0, 0.0};
  model.clear_range = 3.0;
  return model;
}

LaserScan scan_of(const std::vector<float>& ranges, double increment = radians(90.0)) {
  LaserScan scan;
  scan.angle_increment = increment;
  scan.range_min = 0.12;
  scan.range_max = 3.5;
  scan.ranges = ranges;
  return scan;
}

std::vector<Beam> beams(ScanPoints& points, const LaserScan& scan, double stamp = 0.0, const Twist2& twist = {}) {
  const auto found = points.beams(scan, stamp, twist);
  return {found.begin(), found.end()};
}

void expect_near(const Point2& a, const Point2& b, double tolerance = 1e-12) {
  EXPECT_LT((a - b).norm(), tolerance) << a.transpose() << " against " << b.transpose();
}

TEST(ScanPointsTest, PutsEndsAtBearingAndRangeFromTheSensor) {
  ScanPoints points(lidar());
  const std::vector<float> ranges{1.0F, 2.0F, 3.0F, 0.5F};
  const auto found = beams(points, scan_of(ranges));
  ASSERT_EQ(found.size(), 4u);
  const Point2 ends[] = {{1.1, 0.0}, {0.1, 2.0}, {-2.9, 0.0}, {0.1, -0.5}};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_TRUE(found[i].hit);
    expect_near(found[i].origin, {0.1, 0.0});
    expect_near(found[i].end, ends[i]);
  }
}

TEST(ScanPointsTest, TurnsWithTheSensorsMount) {
  LidarModel model = lidar();
  model.mount.yaw = radians(90.0);
  ScanPoints points(model);
  const std::vector<float> ranges{1.0F};
  expect_near(beams(points, scan_of(ranges))[0].end, {0.1, 1.0});
}

TEST(ScanPointsTest, TellsReturnsFromClearWaysAndFromNothingSaid) {
  ScanPoints points(lidar());
  // Farther than is measured, no echo, LDS-01's word for it; then what says nothing: no number, too near, nonsense.
  const std::vector<float> ranges{3.6F, kNoEcho, 0.0F, kNoRange, -kNoEcho, -1.0F, 0.1F, 3.5F, 0.12F};
  LaserScan scan = scan_of(ranges, radians(10.0));
  scan.range_min = static_cast<double>(0.12F);
  const auto found = beams(points, scan);
  ASSERT_EQ(found.size(), 5u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_FALSE(found[i].hit);
    EXPECT_NEAR((found[i].end - found[i].origin).norm(), 3.0, 1e-12);
  }
  EXPECT_TRUE(found[3].hit);
  EXPECT_TRUE(found[4].hit);
}

TEST(ScanPointsTest, WithoutClearRangeABeamWithoutReturnSaysNothing) {
  LidarModel model = lidar();
  model.clear_range = 0.0;
  ScanPoints points(model);
  const std::vector<float> ranges{kNoEcho, 3.6F, 0.0F, 1.0F};
  EXPECT_EQ(beams(points, scan_of(ranges)).size(), 1u);
}

TEST(ScanPointsTest, ReturnsBeyondMaxRangeAreClearUpToThere) {
  ScanPoints points(lidar(), {.max_range = 2.0});
  const std::vector<float> ranges{2.5F, kNoEcho, 1.5F};
  const auto found = beams(points, scan_of(ranges));
  ASSERT_EQ(found.size(), 3u);
  EXPECT_FALSE(found[0].hit);
  expect_near(found[0].end, {2.1, 0.0});
  EXPECT_FALSE(found[1].hit);
  expect_near(found[1].end, {0.1, 2.0});
  EXPECT_TRUE(found[2].hit);
}

TEST(ScanPointsTest, UsesBeamsWithinTheForwardConeAlone) {
  LidarModel model = lidar();
  model.mount.yaw = radians(180.0);  // a sensor that looks backwards: ahead is ahead of the robot
  ScanPoints points(model, {.forward_cone = radians(10.5)});
  const std::vector<float> ranges(360, 1.0F);
  const auto found = beams(points, scan_of(ranges, radians(1.0)));
  EXPECT_EQ(found.size(), 21u);
  for (const Beam& beam : found) {
    const Point2 way = beam.end - beam.origin;
    EXPECT_LE(std::fabs(atan2(way.y(), way.x())), radians(10.5));
  }
}

TEST(ScanPointsTest, FollowsScansThatChangeTheirShape) {
  ScanPoints points(lidar());
  const std::vector<float> four(4, 1.0F);
  const std::vector<float> eight(8, 1.0F);
  beams(points, scan_of(four));
  EXPECT_EQ(beams(points, scan_of(eight, radians(45.0))).size(), 8u);
  expect_near(beams(points, scan_of(four, radians(45.0)))[2].end, {0.1, 1.0});
  LaserScan turned = scan_of(four, radians(45.0));
  turned.angle_min = radians(90.0);
  expect_near(beams(points, turned)[0].end, {0.1, 1.0});
}

TEST(ScanPointsTest, ABeamStartsFromWhereTheSensorWas) {
  // A wall at x = 2, seen by a robot that drives an arc while the lidar turns once. The truth is worked out beam by
  // beam, by small steps back along the motion.
  const Twist2 twist{0.3, 0.0, 1.5};
  const double time_increment = 0.2 / 90.0;
  std::vector<float> ranges(90);
  std::vector<Pose2> then(90);
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    constexpr int kSteps = 2000;
    const double dt = -(static_cast<double>(89 - i)) * time_increment / kSteps;
    Pose2 robot;
    for (int k = 0; k < kSteps; ++k) {
      const Pose2 half{0.5 * twist.linear * dt, 0.0, 0.0};
      robot = robot * half * Pose2{0.0, 0.0, twist.angular * dt} * half;
    }
    then[i] = robot;
    const Pose2 sensor = robot * lidar().mount;
    ranges[i] =
        static_cast<float>((2.0 - sensor.x) / direction(sensor.yaw + radians(-45.0 + static_cast<double>(i))).x());
  }
  LaserScan scan = scan_of(ranges, radians(1.0));
  scan.angle_min = radians(-45.0);
  scan.stamp = 10.0 - 89 * time_increment;
  scan.time_increment = time_increment;
  scan.range_max = 10.0;
  ScanPoints points(lidar());
  const auto found = beams(points, scan, 10.0, twist);
  ASSERT_EQ(found.size(), 90u);
  for (std::size_t i = 0; i < found.size(); ++i) {
    expect_near(found[i].origin, (then[i] * lidar().mount).position(), 1e-6);
    EXPECT_NEAR(found[i].end.x(), 2.0, 1e-6);
  }
  // Had it been standing still, the first beam would be off.
  EXPECT_GT(std::fabs(beams(points, scan, 10.0, {})[0].end.x() - 2.0), 0.1);
}

TEST(ScanPointsTest, FollowsARobotThatDrivesStraightOrAlmost) {
  ScanPoints points(lidar());
  const std::vector<float> ranges{1.0F, 1.0F, 1.0F};
  LaserScan scan = scan_of(ranges);
  scan.stamp = 9.8;
  scan.time_increment = 0.1;
  for (const double turn : {0.0, 1e-7}) {
    const auto found = beams(points, scan, 10.0, {0.5, 0.2, turn});
    ASSERT_EQ(found.size(), 3u);
    expect_near(found[0].origin, {0.1 - 0.1, -0.04}, 1e-6);
    expect_near(found[1].origin, {0.1 - 0.05, -0.02}, 1e-6);
    expect_near(found[2].origin, {0.1, 0.0}, 1e-6);
  }
}

TEST(ScanPointsTest, AScanMeasuredAtOnceNeedsNoTwist) {
  ScanPoints points(lidar());
  const std::vector<float> ranges{1.0F, 1.0F};
  LaserScan scan = scan_of(ranges);
  scan.stamp = 1.0;
  for (const double turn : {1.0, std::numeric_limits<double>::quiet_NaN()}) {
    expect_near(beams(points, scan, 2.0, {0.1, 0.0, turn})[1].end, {0.1, 1.0});
  }
}

TEST(ScanPointsTest, RefusesATwistThatWentAstray) {
  ScanPoints points(lidar());
  const std::vector<float> ranges{1.0F, 1.0F};
  LaserScan scan = scan_of(ranges);
  scan.time_increment = 0.1;
  for (const double speed : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(points.beams(scan, 0.1, {speed, 0.0, 0.0}), Error);
    EXPECT_THROW(points.beams(scan, 0.1, {0.0, 0.0, speed}), Error);
  }
}

}  // namespace
}  // namespace scrubjay
