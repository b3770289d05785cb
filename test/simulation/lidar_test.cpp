#include <gmock/gmock.h>

#include <algorithm>

#include "burger.hpp"

namespace scrubjay::test {
namespace {

constexpr float kNothing = std::numeric_limits<float>::infinity();

/// From `origin` along `bearing` to the walls of a room with its lower left corner at the origin [m].
double range_in_room(double width, double height, const Point2& origin, double bearing) {
  const Point2 along = direction(bearing);
  const double x = along.x() > 0.0 ? (width - origin.x()) / along.x() : -origin.x() / along.x();
  const double y = along.y() > 0.0 ? (height - origin.y()) / along.y() : -origin.y() / along.y();
  return std::min(x, y);
}

TEST(LidarTest, MeasuresARoomFromWhereItIsMounted) {
  Burger burger(room(4.0, 3.0), {1.5, 1.0, 0.3});
  const LaserScan scan = burger.scan();
  const Pose2 sensor = burger.pose() * Pose2{-0.032, 0.0, 0.0};
  ASSERT_EQ(scan.ranges.size(), 360u);
  for (std::size_t i = 0; i < 360; ++i) {
    const double bearing = sensor.yaw + radians(static_cast<double>(i));
    EXPECT_NEAR(scan.ranges[i], range_in_room(4.0, 3.0, sensor.position(), bearing), 1e-6) << i;
  }
}

TEST(LidarTest, BeginsStraightAheadAndTurnsLeft) {
  Burger burger(with_walls({facing({-0.032, 0.0}, 0.0, 1.0, 0.005), facing({-0.032, 0.0}, 0.5 * kPi, 2.0, 0.005),
                            facing({-0.032, 0.0}, radians(-90.0), 3.0, 0.005)}));
  const LaserScan scan = burger.scan();
  for (std::size_t i = 0; i < 360; ++i) {
    const float expected = i == 0 ? 1.0f : i == 90 ? 2.0f : i == 270 ? 3.0f : kNothing;
    EXPECT_FLOAT_EQ(scan.ranges[i], expected) << i;
  }
}

TEST(LidarTest, DescribesItsScans) {
  Burger burger(room(4.0, 3.0), {2.0, 1.5, 0.0});
  for (int turn = 1; turn <= 3; ++turn) {
    for (int tick = 1; tick <= 10; ++tick) {
      const std::optional<Frame> frame = burger.robot.next();
      ASSERT_EQ(frame->scan.has_value(), tick == 10);
      if (!frame->scan) continue;
      EXPECT_DOUBLE_EQ(frame->stamp, 0.2 * turn);
      EXPECT_EQ(frame->scan->stamp, frame->stamp) << "all beams at once";
      EXPECT_EQ(frame->scan->time_increment, 0.0);
      EXPECT_EQ(frame->scan->angle_min, 0.0);
      EXPECT_NEAR(frame->scan->angle_increment, radians(1.0), 1e-15);
      EXPECT_EQ(frame->scan->range_min, 0.12);
      EXPECT_EQ(frame->scan->range_max, 3.5);
    }
  }
}

TEST(LidarTest, SeesNothingFartherThanItsRange) {
  const auto ahead = [](double distance) {
    return Burger(with_walls({facing({-0.032, 0.0}, 0.0, distance, 0.5)})).scan().ranges[0];
  };
  EXPECT_NEAR(ahead(3.49), 3.49, 1e-6);
  EXPECT_EQ(ahead(3.51), kNothing);
}

TEST(LidarTest, TellsWhatIsTooNearFromWhatIsNotThere) {
  // Behind, where the lidar is nearer to the shell: 73 mm.
  const auto behind = [](double distance) {
    Burger burger(with_walls({facing({-0.032, 0.0}, kPi, distance, 0.5)}));
    const LaserScan scan = burger.scan();
    return std::pair(scan.ranges[180], scan.returned(scan.ranges[180]));
  };
  EXPECT_NEAR(behind(0.121).first, 0.121, 1e-6);
  EXPECT_TRUE(behind(0.121).second);
  EXPECT_EQ(behind(0.119).first, -kNothing);
  EXPECT_FALSE(behind(0.119).second);
}

TEST(LidarTest, SeesNeitherDocksNorCliffsNorCarpets) {
  World world;
  world.dock = Dock{{1.0, 0.0, kPi}};
  world.cliffs = {box({0.0, 1.0}, {1.0, 1.0}, 0.0)};
  world.carpets = {{box({0.0, 0.0}, {3.0, 3.0}, 0.0), 0.1}};
  Burger burger(world);
  EXPECT_THAT(burger.scan().ranges, ::testing::Each(kNothing));
}

TEST(LidarTest, SeesTheLegsOfATableAndWhatIsBetweenThem) {
  World world = room(4.0, 4.0);
  world.furniture.push_back({"table", {box({3.0, 1.8}, {0.05, 0.05}, 0.0), box({3.0, 2.2}, {0.05, 0.05}, 0.0)}});
  Burger burger(world, {1.032, 2.0, 0.0});
  const LaserScan scan = burger.scan();
  EXPECT_NEAR(scan.ranges[0], 3.0, 1e-6) << "between them";
  EXPECT_NEAR(scan.ranges[6], 1.975 / direction(radians(6.0)).x(), 1e-6);
  EXPECT_NEAR(scan.ranges[354], 1.975 / direction(radians(6.0)).x(), 1e-6);
}

/// A robot that has moved steadily, and the scan that it took last. Motion is known, so is every beam's own pose.
struct Moving {
  Moving(const Motion& steady, bool motion_distortion)
      : motion(steady), burger(room(5.0, 5.0), {2.5, 2.5, 0.7}, {}, 1, {motion_distortion}) {
    burger.drive(motion, 1.0);  // up to speed, and at the end of a turn
    scan = burger.scan();
  }
  /// The range of beam `i`, had it been measured `ago` [s] before the frame.
  double expected(std::size_t i, double ago) const {
    const Pose2 back{-motion.linear * ago, 0.0, -motion.angular * ago};
    const Pose2 sensor = burger.pose() * back * Pose2{-0.032, 0.0, 0.0};
    const double range = range_in_room(5.0, 5.0, sensor.position(), sensor.yaw + radians(static_cast<double>(i)));
    return range <= 3.5 ? range : std::numeric_limits<double>::infinity();
  }

  Motion motion;
  Burger burger;
  LaserScan scan;
};

class LidarMotionTest : public ::testing::TestWithParam<Motion> {};

TEST_P(LidarMotionTest, MeasuresEachBeamAtItsOwnTimeWhenAskedTo) {
  const Moving moving(GetParam(), true);
  const double stamp = 20 * static_cast<double>(moving.burger.robot.truth().ticks) / 1000.0;
  EXPECT_NEAR(moving.scan.time_increment, 0.2 / 360.0, 1e-15);
  EXPECT_NEAR(moving.scan.stamp, stamp - 359.0 * 0.2 / 360.0, 1e-12);
  double skew = 0.0;
  for (std::size_t i = 0; i < 360; ++i) {
    const double ago = static_cast<double>(359 - i) * 0.2 / 360.0;
    const double expected = moving.expected(i, ago);
    if (std::fabs(expected - 3.5) < 1e-3) continue;  // just in range or just out of it
    if (std::isinf(expected)) {
      EXPECT_EQ(moving.scan.ranges[i], kNothing) << i;
    } else {
      EXPECT_NEAR(moving.scan.ranges[i], expected, 2e-6) << i;
      const double still = moving.expected(i, 0.0);
      if (std::isfinite(still)) skew = std::max(skew, std::fabs(still - expected));
    }
  }
  EXPECT_GT(skew, 0.02) << "too slow to tell";
}

TEST_P(LidarMotionTest, MeasuresAllBeamsAtOnceOtherwise) {
  const Moving moving(GetParam(), false);
  for (std::size_t i = 0; i < 360; ++i) {
    const double expected = moving.expected(i, 0.0);
    if (std::fabs(expected - 3.5) < 1e-3) continue;
    if (std::isinf(expected)) {
      EXPECT_EQ(moving.scan.ranges[i], kNothing) << i;
    } else {
      EXPECT_NEAR(moving.scan.ranges[i], expected, 1e-6) << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Motions, LidarMotionTest,
                         ::testing::Values(Motion{0.22, 0.0}, Motion{-0.2, 0.0}, Motion{0.0, 0.55}, Motion{0.0, -2.5}));

TEST(LidarTest, SeesAWallTiltedByTheTurnThatItMadeMeanwhile) {
  // At 0.55 rad/s, a turn of the lidar takes 6.3 degrees of the robot's. The beams 45 degrees to either side of the
  // wall's normal are a quarter of a turn apart: seen from one pose, the wall leans.
  const double rate = 0.55;
  Burger burger(with_walls({{{{-9.0, 1.0}, {9.0, 1.0}}}}), {0.0, 0.0, 0.0}, {}, 1, {true});
  burger.drive({0.0, rate}, 0.98);
  while (std::fabs(angle_difference(burger.pose().yaw, 0.0)) > 0.03) burger.scan();
  LaserScan scan = burger.scan();
  const Pose2 sensor = burger.pose() * Pose2{-0.032, 0.0, 0.0};
  const auto point = [&](std::size_t i) {
    return Point2(sensor * (static_cast<double>(scan.ranges[i]) * direction(radians(static_cast<double>(i)))));
  };
  const Point2 right = point(45);
  const Point2 left = point(135);
  const double tilt = std::atan2(right.y() - left.y(), right.x() - left.x());
  // To first order each end is turned about the robot by rate * age; a wall at distance 1 between -1 and 1 leans by the
  // mean of both ends' turns.
  const double expected = rate * (0.5 * (359.0 - 45.0) + 0.5 * (359.0 - 135.0)) * 0.2 / 360.0;
  EXPECT_NEAR(tilt, expected, 0.15 * expected);
}

struct Moments {
  double mean = 0.0;
  double deviation = 0.0;
};

Moments moments(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  const double mean = sum / static_cast<double>(values.size());
  double squares = 0.0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return {mean, std::sqrt(squares / static_cast<double>(values.size()))};
}

/// Ranges to a wall 0.4 m ahead and one 2 m to the left, scan by scan.
struct Readings {
  std::vector<double> near;
  std::vector<double> far;
};

Readings readings(const sim::NoiseProfile& profile, int scans) {
  Burger burger(with_walls({facing({-0.032, 0.0}, 0.0, 0.4, 0.05), facing({-0.032, 0.0}, 0.5 * kPi, 2.0, 0.05)}), {},
                profile);
  Readings got;
  for (int i = 0; i < scans; ++i) {
    const LaserScan scan = burger.scan();
    got.near.push_back(scan.ranges[0]);
    got.far.push_back(scan.ranges[90]);
    EXPECT_EQ(scan.ranges[180], kNothing);
  }
  return got;
}

TEST(LidarNoiseTest, IsWhatTheProfileSays) {
  constexpr int kScans = 2000;
  sim::NoiseProfile profile;
  profile.lidar_noise = 0.01;
  const Readings got = readings(profile, kScans);
  const Moments at_far = moments(got.far);
  EXPECT_NEAR(at_far.mean, 2.0, 4.0 * 0.01 / std::sqrt(kScans));
  EXPECT_NEAR(at_far.deviation, 0.01, 0.001);
  double product = 0.0;
  for (std::size_t i = 0; i < got.far.size(); ++i) product += (got.near[i] - 0.4) / 0.01 * (got.far[i] - 2.0) / 0.01;
  EXPECT_NEAR(product / kScans, 0.0, 4.0 / std::sqrt(kScans)) << "beams err independently";
}

TEST(LidarNoiseTest, GrowsWithTheRangeWhereTheProfileSaysSo) {
  const Readings got = readings(Burger::noise("carpet"), 2000);
  EXPECT_NEAR(moments(got.near).deviation, 0.4 * 0.0167, 0.0006);
  EXPECT_NEAR(moments(got.far).deviation, 2.0 * 0.0167, 0.003);
}

TEST(LidarNoiseTest, StaysWithinTheDataSheetsAccuracy) {
  for (const char* profile : {"hard-floor", "carpet"}) {
    const Readings got = readings(Burger::noise(profile), 3000);
    const auto [nearest, near_most] = std::ranges::minmax(got.near);
    EXPECT_GE(nearest, 0.4 - 0.015 - 1e-6) << profile;
    EXPECT_LE(near_most, 0.4 + 0.015 + 1e-6) << profile;
    const auto [far_least, far_most] = std::ranges::minmax(got.far);
    EXPECT_GE(far_least, 1.9 - 1e-6) << profile;
    EXPECT_LE(far_most, 2.1 + 1e-6) << profile;
  }
}

TEST(LidarNoiseTest, IsNoneOnAPerfectRobot) {
  Burger burger(room(3.0, 3.0), {1.5, 1.5, 0.2}, Burger::noise("none"));
  const LaserScan scan = burger.scan();
  const std::vector<float> first(scan.ranges.begin(), scan.ranges.end());
  EXPECT_THAT(burger.scan().ranges, ::testing::ElementsAreArray(first));
}

TEST(LidarNoiseTest, OfABeamDoesNotDependOnWhatTheOthersSee) {
  const World alone = with_walls({facing({-0.032, 0.0}, kPi, 1.0, 0.05)});
  World crowded = alone;
  crowded.walls.push_back(facing({-0.032, 0.0}, 0.0, 1.0, 2.0));
  Burger one(alone, {}, Burger::noise("carpet"));
  Burger two(crowded, {}, Burger::noise("carpet"));
  for (int i = 0; i < 20; ++i) {
    const float seen = one.scan().ranges[180];
    EXPECT_EQ(seen, two.scan().ranges[180]);
    EXPECT_NE(seen, 1.0f);
  }
}

}  // namespace
}  // namespace scrubjay::test
