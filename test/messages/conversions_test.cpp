#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <scrubjay/messages/conversions.hpp>
#include <vector>

namespace scrubjay::ros {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::IsEmpty;

const Header kHeader{{3, 500'000'000}, "map"};

class YawTest : public testing::TestWithParam<double> {};

TEST_P(YawTest, ComesBackFromItsQuaternion) {
  const Quaternion q = quaternion(GetParam());
  EXPECT_NEAR(q.z * q.z + q.w * q.w, 1.0, 1e-12);
  EXPECT_NEAR(angle_difference(yaw_of(q), GetParam()), 0.0, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(AllRound, YawTest, testing::Values(0.0, 0.1, -0.1, 1.5, -1.5, 3.0, -3.0, 3.14159, 7.0));

TEST(YawTest, IsTheTurnAboutZOfARobotThatLeans) {
  // A turn of 90 degrees about z, and then one of 30 about the robot's own x.
  const double half = 0.5 * radians(30.0);
  const double c = std::sqrt(0.5);
  EXPECT_NEAR(yaw_of({c * sin(half), c * sin(half), c * cos(half), c * cos(half)}), radians(90.0), 1e-12);
}

TEST(OdometryMessageTest, HasThePlanesCovarianceInItsPlaces) {
  PoseEstimate estimate;
  estimate.pose = {1.0, 2.0, radians(90.0)};
  estimate.covariance << 1.0, 2.0, 3.0, 2.0, 5.0, 6.0, 3.0, 6.0, 9.0;
  estimate.twist = {0.25, 0.125, -0.5};
  const Odometry message = odometry_message(kHeader, "base_link", estimate);
  EXPECT_EQ(message.child_frame_id, "base_link");
  EXPECT_EQ(message.pose.pose.position, (Point{1.0, 2.0, 0.0}));
  const auto& c = message.pose.covariance;
  EXPECT_THAT((std::vector{c[0], c[1], c[5], c[6], c[7], c[11], c[30], c[31], c[35]}),
              ElementsAre(1.0, 2.0, 3.0, 2.0, 5.0, 6.0, 3.0, 6.0, 9.0));
  EXPECT_EQ(c[14], 0.0);  // of z
  EXPECT_EQ(message.twist.twist.linear, (Vector3{0.25, 0.125, 0.0}));
  EXPECT_EQ(message.twist.twist.angular.z, -0.5);
}

TEST(ScanMessageTest, NamesItsFirstAndLastBeam) {
  const std::vector<float> ranges{1.0F, std::numeric_limits<float>::infinity(), 0.0F, 2.0F};
  scrubjay::LaserScan scan;
  scan.angle_min = -1.0;
  scan.angle_increment = 0.5;
  scan.time_increment = 0.01;
  scan.range_min = 0.12;
  scan.range_max = 3.5;
  scan.ranges = ranges;
  const LaserScan message = scan_message(kHeader, scan);
  EXPECT_FLOAT_EQ(message.angle_min, -1.0F);
  EXPECT_FLOAT_EQ(message.angle_max, 0.5F);
  EXPECT_FLOAT_EQ(message.scan_time, 0.04F);
  EXPECT_EQ(message.ranges, ranges);
}

TEST(BumperMessageTest, HasWhatTheFrameHasFromLeftToRight) {
  Frame frame;
  frame.bump_right = true;
  frame.light_flags = 0b100010;
  frame.light_signal = {1, 2, 3, 4, 5, 6};
  const Bumper message = bumper_message(kHeader, frame);
  EXPECT_FALSE(message.is_left_pressed);
  EXPECT_TRUE(message.is_right_pressed);
  EXPECT_FALSE(message.is_light_left);
  EXPECT_TRUE(message.is_light_front_left);
  EXPECT_TRUE(message.is_light_right);
  EXPECT_EQ(message.light_signal_left, 1);
  EXPECT_EQ(message.light_signal_center_right, 4);
  EXPECT_EQ(message.light_signal_right, 6);
}

TEST(CliffMessageTest, TellsTheSensorsApart) {
  Frame frame;
  frame.cliff_flags = 0b0100;
  const Cliff message = cliff_message(kHeader, frame);
  EXPECT_TRUE(message.is_cliff_front_right);
  EXPECT_FALSE(message.is_cliff_left || message.is_cliff_front_left || message.is_cliff_right);
}

TEST(BatteryMessageTest, CountsCurrentAsRosDoes) {
  Battery battery{14.4, -0.3, 1.3, 2.6, 25.0, false};
  const BatteryState message = battery_message(kHeader, battery);
  EXPECT_FLOAT_EQ(message.current, -0.3F);
  EXPECT_FLOAT_EQ(message.percentage, 0.5F);
  EXPECT_EQ(message.power_supply_status, BatteryState::kStatusDischarging);
  battery.charging = true;
  EXPECT_EQ(battery_message(kHeader, battery).power_supply_status, BatteryState::kStatusCharging);
}

TEST(BatteryMessageTest, SaysWhatIsntKnown) {
  const BatteryState message = battery_message(kHeader, {});
  EXPECT_TRUE(std::isnan(message.percentage));
  EXPECT_TRUE(std::isnan(message.design_capacity));
  EXPECT_FALSE(message.present);
}

struct Cells {
  GridGeometry geometry{0.1, {-1.0, 2.0}, 3, 2};
  std::vector<LogOdds> cells{-100, 0, 100, 5, -100, 100};
  GridView<const LogOdds> view() const { return {geometry, cells.data()}; }
};

TEST(MapMessageTest, HasTheCellsRowByRowInTrinaryValues) {
  const OccupancyGrid message = map_message(kHeader, Cells{}.view(), {{0, 0}, {3, 2}});
  EXPECT_EQ(message.info.width, 3u);
  EXPECT_EQ(message.info.height, 2u);
  EXPECT_FLOAT_EQ(message.info.resolution, 0.1F);
  EXPECT_EQ(message.info.origin.position, (Point{-1.0, 2.0, 0.0}));
  EXPECT_THAT(message.data, ElementsAre(0, -1, 100, -1, 0, 100));
}

TEST(MapMessageTest, BeginsWhereItsCellsDo) {
  const OccupancyGrid message = map_message(kHeader, Cells{}.view(), {{1, 1}, {3, 2}});
  EXPECT_NEAR(message.info.origin.position.x, -0.9, 1e-12);
  EXPECT_NEAR(message.info.origin.position.y, 2.1, 1e-12);
  EXPECT_THAT(message.data, ElementsAre(0, 100));
}

TEST(MapUpdateMessageTest, CountsFromTheMapThatWasPublished) {
  const OccupancyGridUpdate message = map_update_message(kHeader, Cells{}.view(), {{1, 0}, {3, 2}}, {{2, 1}, {3, 2}});
  EXPECT_EQ(message.x, 1);
  EXPECT_EQ(message.y, 1);
  EXPECT_EQ(message.width, 1u);
  EXPECT_EQ(message.height, 1u);
  EXPECT_THAT(message.data, ElementsAre(100));
}

TEST(PathMessageTest, LooksAlongTheWay) {
  const std::vector<Point2> points{{0.0, 0.0}, {1.0, 0.0}, {1.0, 2.0}};
  const Path path = path_message(kHeader, points);
  ASSERT_EQ(path.poses.size(), 3u);
  std::vector<double> yaws;
  for (const PoseStamped& pose : path.poses) yaws.push_back(yaw_of(pose.pose.orientation));
  EXPECT_THAT(yaws,
              ElementsAre(DoubleNear(0.0, 1e-12), DoubleNear(radians(90.0), 1e-12), DoubleNear(radians(90.0), 1e-12)));
  EXPECT_EQ(path.poses[1].pose.position, (Point{1.0, 0.0, 0.0}));
}

TEST(PathMessageTest, MayBeOfOnePointOrNone) {
  const std::vector<Point2> point{{1.0, 2.0}};
  EXPECT_EQ(path_message(kHeader, point).poses.size(), 1u);
  EXPECT_THAT(path_message(kHeader, std::span<const Point2>()).poses, IsEmpty());
}

TEST(PointsMessageTest, TakesAwayWhatIsNoMore) {
  const std::vector<Point2> points{{1.0, 2.0}};
  const Marker shown = points_message(kHeader, "frontiers", points, 0.05).markers.at(0);
  EXPECT_EQ(shown.action, Marker::kAdd);
  EXPECT_EQ(shown.points, (std::vector<Point>{{1.0, 2.0, 0.0}}));
  EXPECT_EQ(points_message(kHeader, "frontiers", {}, 0.05).markers.at(0).action, Marker::kDelete);
}

}  // namespace
}  // namespace scrubjay::ros
