#include <gtest/gtest.h>

#include <scrubjay/simulation/scan_caster.hpp>

#include "stage.hpp"
#include "world/generated.hpp"

namespace scrubjay::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Compares all beams with single rays, and says how many of them met something.
int expect_single_rays(sim::ScanCaster& caster, const SegmentIndex& index, const Pose2& sensor, double max_range) {
  const std::span<const double> ranges = caster.cast(sensor);
  const SinCos turn = sin_cos(sensor.yaw);
  int hits = 0;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const Point2& beam = caster.beams()[i];
    const Point2 along(turn.cos * beam.x() - turn.sin * beam.y(), turn.sin * beam.x() + turn.cos * beam.y());
    EXPECT_EQ(ranges[i], index.cast(sensor.position(), along, max_range).range)
        << "beam " << i << " at " << sensor.x << ", " << sensor.y << ", " << sensor.yaw;
    hits += ranges[i] < kInfinity;
  }
  return hits;
}

LidarModel lidar(int beams, double angle_min, double angle_increment) {
  LidarModel model;
  model.beams = beams;
  model.angle_min = angle_min;
  model.angle_increment = angle_increment;
  return model;
}

class ScanCasterTest : public ::testing::TestWithParam<LidarModel> {};

TEST_P(ScanCasterTest, SeesWhatSingleRaysSee) {
  Random random(1);
  const SegmentIndex index(random_segments(random, 400, 20.0, 2.0));
  sim::ScanCaster caster(index, GetParam());
  int hits = 0;
  for (int i = 0; i < 300; ++i) {
    const Point2 p = random_point(random, -2.0, 22.0);
    hits += expect_single_rays(caster, index, {p.x(), p.y(), random.uniform(-kPi, kPi)}, 3.5);
  }
  EXPECT_GT(hits, 100 * GetParam().beams) << "too empty to tell";
  EXPECT_LT(hits, 290 * GetParam().beams);
}

TEST_P(ScanCasterTest, SeesWhatSingleRaysSeeOnItsWay) {
  Random random(2);
  const SegmentIndex index(solid_segments(random_house(random, 5, 4.0)));
  sim::ScanCaster caster(index, GetParam());
  Pose2 pose{2.0, 2.0, 0.0};
  for (int i = 0; i < 300; ++i) {
    pose = pose * Pose2{0.05, 0.0, 0.05 * std::floor(random.uniform(-1.0, 2.0))};
    expect_single_rays(caster, index, pose, 3.5);
  }
}

TEST_P(ScanCasterTest, SeesWhatSingleRaysSeeInLineWithWalls) {
  Random random(3);
  const SegmentIndex index(solid_segments(random_house(random, 3, 4.0)));
  sim::ScanCaster caster(index, GetParam());
  for (int i = 0; i < 100; ++i) {
    const double yaw = 0.5 * kPi * (i % 4) - kPi;
    expect_single_rays(caster, index, {4.0 * (i % 4), 0.5 * (i / 4), yaw}, 3.5);
    expect_single_rays(caster, index, {0.5 * (i / 4), 4.0 * (i % 4), yaw}, 3.5);
  }
}

INSTANTIATE_TEST_SUITE_P(Lidars, ScanCasterTest,
                         ::testing::Values(lidar(360, 0.0, radians(1.0)), lidar(360, -kPi, radians(1.0)),
                                           lidar(541, radians(-135.0), radians(0.5)), lidar(97, 1.0, 0.0647),
                                           lidar(361, 0.0, radians(1.0)), lidar(1, 2.0, 1.0), lidar(50, 0.3, 1e-6)));

TEST(ScanCasterCrowdTest, SeesWhatSingleRaysSeeInACrowd) {
  Random random(4);
  const SegmentIndex index(random_segments(random, 12'000, 12.0, 0.1));
  sim::ScanCaster caster(index, {});
  int hits = 0;
  for (int i = 0; i < 30; ++i) {
    const Point2 p = random_point(random, 0.0, 12.0);
    hits += expect_single_rays(caster, index, {p.x(), p.y(), random.uniform(-kPi, kPi)}, 3.5);
  }
  EXPECT_GT(hits, 10'000);
}

TEST(ScanCasterCrowdTest, SeesNothingInAnEmptyWorld) {
  const SegmentIndex index({});
  sim::ScanCaster caster(index, {});
  EXPECT_EQ(expect_single_rays(caster, index, {1.0, 2.0, 3.0}, 3.5), 0);
}

TEST(ScanCasterCrowdTest, SeesDotsAndWallsSeenFromTheirEnds) {
  const Segment2 dot{{1.0, 0.0}, {1.0, 0.0}};
  const Segment2 end_on{{0.0, 1.0}, {0.0, 2.0}};
  const Segment2 under{{-0.5, -0.5}, {-0.5, -0.5}};
  const SegmentIndex index({{dot, 0}, {end_on, 1}, {under, 2}});
  sim::ScanCaster caster(index, {});
  expect_single_rays(caster, index, {0.0, 0.0, 0.0}, 3.5);
  EXPECT_EQ(caster.cast({0.0, 0.0, 0.0})[0], 1.0);
  expect_single_rays(caster, index, {0.0, 1.5, 0.3}, 3.5);
}

}  // namespace
}  // namespace scrubjay::test
