#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <scrubjay/geometry/random.hpp>
#include <scrubjay/io/bag_robot.hpp>
#include <scrubjay/io/world_reader.hpp>

#include "bag_maker.hpp"
#include "temporary_folder.hpp"

namespace scrubjay::test {
namespace {

using testing::ElementsAre;

/// A frame that outlives its robot's next one.
struct KeptFrame {
  Frame frame;
  std::vector<float> ranges;
};

class BagRobotTest : public testing::Test {
 protected:
  BagMaker make() const { return BagMaker(bag_); }
  std::vector<KeptFrame> frames() {
    BagRobot robot(bag_, find_senses(bag_));
    std::vector<KeptFrame> kept;
    while (const auto frame = robot.next()) {
      kept.push_back({*frame, {}});
      if (frame->scan) kept.back().ranges.assign(frame->scan->ranges.begin(), frame->scan->ranges.end());
    }
    EXPECT_FALSE(robot.next()) << "the end is the end";
    EXPECT_FALSE(robot.cut());
    left_out_ = robot.left_out();
    return kept;
  }

  const TemporaryFolder folder_;
  const std::filesystem::path bag_ = folder_ / "run.mcap";
  std::size_t left_out_ = 0;
};

TEST_F(BagRobotTest, GivesAFrameForEachOdometry) {
  {
    BagMaker bag = make();
    bag.add("/scan", 1.0, scan_at(1.0));
    for (const double t : {1.0, 1.5, 2.0}) bag.add("/odom", t, odometry_at(t, {t, -t, 0.5 * t}));
  }
  const auto kept = frames();
  ASSERT_EQ(kept.size(), 3U);
  EXPECT_EQ(kept[0].frame.stamp, 1.0);
  EXPECT_EQ(kept[2].frame.stamp, 2.0);
  EXPECT_EQ(kept[1].frame.odometry->x, 1.5);
  EXPECT_EQ(kept[1].frame.odometry->y, -1.5);
  EXPECT_NEAR(kept[1].frame.odometry->yaw, 0.75, 1e-15);
  EXPECT_EQ(kept[0].frame.left_travel, 0.0);
  EXPECT_FALSE(kept[1].frame.scan);
}

TEST_F(BagRobotTest, GivesAScanWithTheOdometryOfItsLastBeam) {
  {
    BagMaker bag = make();
    ros::LaserScan scan = scan_at(0.5);
    scan.time_increment = 0.125F;
    bag.add("/odom", 0.5, odometry_at(0.5, {}));
    bag.add("/odom", 0.875, odometry_at(0.875, {1.0, 0.0, 0.0}));
    bag.add("/scan", 0.876, scan);
  }
  const auto kept = frames();
  ASSERT_EQ(kept.size(), 2U);
  ASSERT_TRUE(kept[1].frame.scan);
  const LaserScan& scan = *kept[1].frame.scan;
  EXPECT_EQ(scan.stamp, 0.5);
  EXPECT_EQ(scan.time_increment, 0.125);
  EXPECT_EQ(scan.angle_min, 0.0);
  EXPECT_EQ(scan.angle_increment, 0.5 * kPi) << "a quarter of a turn, which no float is";
  EXPECT_EQ(scan.range_min, 0.125);
  EXPECT_EQ(scan.range_max, 3.5);
  EXPECT_THAT(kept[1].ranges, ElementsAre(1.0F, 2.0F, 3.0F, 4.0F));
}

TEST_F(BagRobotTest, GivesAFrameToAScanThatEndsBetweenTwoOdometriesHoweverLateItIsTold) {
  {
    BagMaker bag = make();
    bag.add("/scan", 0.9, scan_at(0.9, {9.0F, 9.0F}));
    for (int i = 0; i < 40; ++i) {
      const double t = 1.0 + 0.05 * i;
      bag.add("/odom", t, odometry_at(t, {t, 0.0, kPi - 0.1 + 0.1 * i}));
      if (i == 10) bag.add("/scan", t, scan_at(1.0125));
    }
  }
  const auto kept = frames();
  ASSERT_EQ(kept.size(), 41U);
  EXPECT_EQ(kept[1].frame.stamp, 1.0125);
  EXPECT_TRUE(kept[1].frame.scan);
  EXPECT_NEAR(kept[1].frame.odometry->x, 1.0125, 1e-12);
  EXPECT_NEAR(kept[1].frame.odometry->yaw, kPi - 0.1 + 0.025, 1e-12);
  EXPECT_EQ(left_out_, 1U) << "the scan before any odometry";
}

TEST_F(BagRobotTest, TakesOdometryFromTransforms) {
  {
    BagMaker bag = make();
    for (const double t : {1.0, 1.5}) {
      bag.add("/tf", t,
              ros::TFMessage{{transform_at(t, "map", "odom", {7.0, 7.0, 1.0}),
                              transform_at(t, "/odom", "/base_footprint", {t, 0.0, 0.0})}});
    }
    bag.add("/scan", 1.5, scan_at(1.5));
  }
  const BagSenses senses = find_senses(bag_);
  EXPECT_EQ(senses.odometry, "/tf");
  EXPECT_EQ(senses.base, "base_footprint");
  const auto kept = frames();
  ASSERT_EQ(kept.size(), 2U);
  EXPECT_EQ(kept[1].frame.odometry->x, 1.5);
  EXPECT_TRUE(kept[1].frame.scan);
  EXPECT_EQ(left_out_, 0U);
}

TEST_F(BagRobotTest, TurnsTheBearingsOfALidarThatHangs) {
  {
    BagMaker bag = make();
    bag.add("/odom", 1.0, odometry_at(1.0, {}));
    ros::TransformStamped hanging = transform_at(0.0, "base_footprint", "base_scan", {});
    hanging.transform.rotation = {1.0, 0.0, 0.0, 0.0};  // half a turn about x
    bag.add("/tf_static", 1.0, ros::TFMessage{{hanging}});
    ros::LaserScan scan = scan_at(1.0);
    scan.angle_min = 0.25F;
    bag.add("/scan", 1.0, scan);
  }
  const BagSenses senses = find_senses(bag_);
  EXPECT_TRUE(senses.upside_down);
  EXPECT_EQ(senses.lidar->angle_min, -0.25);
  const auto kept = frames();
  EXPECT_EQ(kept[0].frame.scan->angle_min, -0.25);
  EXPECT_EQ(kept[0].frame.scan->angle_increment, -0.5 * kPi);
}

TEST_F(BagRobotTest, FeelsWhatTheBumperFelt) {
  {
    BagMaker bag = make();
    for (int i = 0; i < 5; ++i) {
      const double t = 1.0 + 0.015 * i;
      bag.add("/odom", t, odometry_at(t, {}));
      ros::Bumper bumper;
      bumper.header = header_at(t);
      bumper.is_left_pressed = i == 1 || i == 2;
      bumper.is_right_pressed = i == 2;
      bumper.is_light_front_left = i == 3;
      bumper.light_signal_right = static_cast<std::uint16_t>(100 * i);
      bag.add("/bumper", t, bumper);
      if (i != 2) continue;
      ros::Cliff cliff;
      cliff.header = header_at(t);
      cliff.is_cliff_right = true;
      bag.add("/cliff", t, cliff);
    }
  }
  const auto kept = frames();
  ASSERT_EQ(kept.size(), 5U);
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const Frame& frame = kept[i].frame;
    EXPECT_EQ(frame.bump_left, i == 1 || i == 2) << i;
    EXPECT_EQ(frame.bump_right, i == 2) << i;
    EXPECT_EQ(frame.sees(LightSensor::FrontLeft), i == 3) << i;
    EXPECT_EQ(frame.light_signal[5], 100 * i);
    EXPECT_EQ(frame.cliff_flags, i >= 2 ? 1 << static_cast<int>(CliffSensor::Right) : 0) << "until told otherwise";
  }
}

TEST_F(BagRobotTest, FeelsABumpThatWasOverBeforeTheOdometryCame) {
  {
    BagMaker bag = make();
    for (const double t : {1.0, 1.5, 2.0}) bag.add("/odom", t, odometry_at(t, {}));
    ros::Bumper bumper;
    for (const double t : {1.1, 1.2, 1.3}) {
      bumper.header = header_at(t);
      bumper.is_left_pressed = t == 1.2;
      bag.add("/bumper", t, bumper);
    }
  }
  const auto kept = frames();
  EXPECT_FALSE(kept[0].frame.bumped());
  EXPECT_TRUE(kept[1].frame.bump_left);
  EXPECT_FALSE(kept[2].frame.bumped());
}

TEST_F(BagRobotTest, TakesTheTimeOfRecordingWhereAMessageHasNone) {
  {
    BagMaker bag = make();
    for (const double t : {5.0, 5.5}) bag.add("/odom", t, odometry_at(0.0, {t, 0.0, 0.0}));
    bag.add("/scan", 5.5, scan_at(0.0));
  }
  const auto kept = frames();
  ASSERT_EQ(kept.size(), 2U);
  EXPECT_EQ(kept[1].frame.stamp, 5.5);
  EXPECT_TRUE(kept[1].frame.scan);
}

TEST_F(BagRobotTest, FollowsAClockThatWasSetAheadAndNotASingleStamp) {
  {
    BagMaker bag = make();
    bag.add("/scan", 1.0, scan_at(1.0));
    int recorded = 0;
    for (const double t : {1.0, 1.1, 9e8, 1.2, 1.3, 9e8, 9e8 + 0.1, 1.4, 9e8 + 0.2, 2e9}) {
      bag.add("/odom", ++recorded, odometry_at(t, {}));
    }
  }
  std::vector<double> stamps;
  for (const KeptFrame& kept : frames()) stamps.push_back(kept.frame.stamp);
  EXPECT_THAT(stamps, ElementsAre(1.0, 1.1, 1.2, 1.3, 9e8, 9e8 + 0.1, 9e8 + 0.2));
  EXPECT_EQ(left_out_, 3U);
}

TEST_F(BagRobotTest, LeavesOutWhatCannotBeTrueAndCountsIt) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  {
    BagMaker bag = make();
    bag.add("/scan", 1.0, scan_at(1.0));
    bag.add("/odom", 1.0, odometry_at(1.0, {}));
    bag.add("/odom", 1.1, odometry_at(1.1, {kNan, 0.0, 0.0}));
    bag.add("/odom", 1.2, odometry_at(1.2, {1e300, 0.0, 0.0}));
    ros::Odometry lost = odometry_at(1.3, {});
    lost.pose.pose.orientation = {0.0, 0.0, 0.0, 0.0};
    bag.add("/odom", 1.3, lost);
    bag.add("/odom", 1.4, odometry_at(0.9, {}));
    bag.add_bytes<ros::Odometry>("/odom", 1.5, ros::Bytes(30));
    bag.add_bytes<ros::LaserScan>("/scan", 1.5, {});
    ros::LaserScan scan = scan_at(1.0);
    scan.angle_increment = std::numeric_limits<float>::infinity();
    bag.add("/scan", 1.5, scan);
    bag.add_bytes<ros::Bumper>("/bumper", 1.5, ros::Bytes(3));
  }
  EXPECT_EQ(frames().size(), 1U);
  EXPECT_EQ(left_out_, 8U);
}

TEST_F(BagRobotTest, HasNoMoreMemoryForScansWithoutOdometryThanForSome) {
  {
    BagMaker bag = make();
    bag.add("/odom", 1.0, odometry_at(1.0, {}));
    for (int i = 0; i < 3'000; ++i) bag.add("/scan", 2.0 + i, scan_at(2.0 + i));
  }
  EXPECT_EQ(frames().size(), 1U);
  EXPECT_EQ(left_out_, 2'000U) << "the last thousand waits until the end";
}

TEST_F(BagRobotTest, GivesFramesInOrderThatCanBeTrueWhateverTheBytes) {
  Random random(1);
  const auto damaged = [&random](ros::Bytes bytes) {
    for (int flips = static_cast<int>(random.next() % 4); flips > 0; --flips) {
      bytes[random.next() % bytes.size()] ^= static_cast<std::byte>(1U << random.next() % 8);
    }
    if (random.next() % 8 == 0) bytes.resize(random.next() % bytes.size());
    return bytes;
  };
  {
    BagMaker bag = make();
    bag.add("/odom", 1.0, odometry_at(1.0, {}));
    bag.add("/scan", 1.0, scan_at(1.0));
    for (int i = 1; i < 3'000; ++i) {
      const double t = 1.0 + 0.015 * i;
      bag.add_bytes<ros::Odometry>("/odom", t, damaged(ros::encode(odometry_at(t, {0.01 * i, 0.0, 0.1 * i}))));
      bag.add_bytes<ros::LaserScan>("/scan", t, damaged(ros::encode(scan_at(t))));
      bag.add_bytes<ros::Bumper>("/bumper", t, damaged(ros::encode(ros::Bumper{})));
      bag.add_bytes<ros::Cliff>("/cliff", t, damaged(ros::encode(ros::Cliff{})));
    }
  }
  double last = -std::numeric_limits<double>::infinity();
  const auto kept = frames();
  EXPECT_GT(kept.size(), 100U);
  EXPECT_GT(left_out_, 100U);
  for (const KeptFrame& k : kept) {
    EXPECT_GE(k.frame.stamp, last);
    last = k.frame.stamp;
    const Pose2& pose = *k.frame.odometry;
    EXPECT_TRUE(std::abs(pose.x) <= kWorldExtent && std::abs(pose.y) <= kWorldExtent && std::abs(pose.yaw) <= kPi);
    if (!k.frame.scan) continue;
    EXPECT_GE(k.ranges.size(), 2U);
    EXPECT_TRUE(std::isfinite(k.frame.scan->angle_min + k.frame.scan->angle_increment + k.frame.scan->range_max));
  }
}

}  // namespace
}  // namespace scrubjay::test
