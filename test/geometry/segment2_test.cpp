#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <scrubjay/geometry/random.hpp>
#include <scrubjay/geometry/segment2.hpp>

namespace scrubjay {
namespace {

constexpr double kMiss = std::numeric_limits<double>::infinity();

Point2 random_point(Random& random) {
  return {random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0)};
}

TEST(Segment2Test, NearestPointIsAsNearAsAnyOfTheSegment) {
  Random random(1);
  for (int i = 0; i < 500; ++i) {
    const Segment2 s{random_point(random), random_point(random)};
    const Point2 p = random_point(random);
    double nearest = kMiss;
    constexpr int kSteps = 1000;
    for (int k = 0; k <= kSteps; ++k) {
      nearest = std::min(nearest, (s.a + (s.b - s.a) * k / kSteps - p).norm());
    }
    const double distance = (nearest_point(s, p) - p).norm();
    EXPECT_LE(distance, nearest + 1e-12);
    EXPECT_NEAR(distance, nearest, s.length() / kSteps);
    EXPECT_NEAR(squared_distance(s, p), distance * distance, 1e-12);
    const Point2 q = nearest_point(s, p);
    EXPECT_NEAR((q - s.a).norm() + (q - s.b).norm(), s.length(), 1e-12);  // it lies on the segment
  }
}

TEST(Segment2Test, NearestPointOfASegmentWithoutLengthIsItsEnd) {
  const Segment2 s{{1.0, 2.0}, {1.0, 2.0}};
  EXPECT_EQ(nearest_point(s, {5.0, 5.0}), s.a);
}

TEST(Segment2Test, RayHitsWhatTheRaySideTestSaysAndAtThatDistance) {
  Random random(2);
  int hits = 0;
  for (int i = 0; i < 20000; ++i) {
    const Segment2 s{random_point(random), random_point(random)};
    const Point2 origin = random_point(random);
    const Point2 heading = direction(random.uniform(-kPi, kPi));
    // In the ray's frame, x along it: the segment must cross the x axis at a positive x.
    const auto in_ray_frame = [&](const Point2& p) {
      const Point2 d = p - origin;
      return Point2{d.dot(heading), heading.x() * d.y() - heading.y() * d.x()};
    };
    const Point2 a = in_ray_frame(s.a);
    const Point2 b = in_ray_frame(s.b);
    const double crossing = a.x() - a.y() * (b.x() - a.x()) / (b.y() - a.y());
    const bool expected = (a.y() < 0.0) != (b.y() < 0.0) && crossing >= 0.0;
    const double distance = ray_hit(s, origin, heading);
    ASSERT_EQ(std::isfinite(distance), expected);
    if (!expected) continue;
    ++hits;
    EXPECT_NEAR(distance, crossing, 1e-9 * (1.0 + crossing));
    EXPECT_LT(squared_distance(s, origin + distance * heading), 1e-18);
    EXPECT_EQ(ray_hit({s.b, s.a}, origin, heading) < kMiss, true);
  }
  EXPECT_GT(hits, 2000);
}

TEST(Segment2Test, RayAlongTheSegmentMeetsItsNearerEnd) {
  const Segment2 s{{1.0, 0.0}, {3.0, 0.0}};
  EXPECT_EQ(ray_hit(s, {0.0, 0.0}, {1.0, 0.0}), 1.0);
  EXPECT_EQ(ray_hit(s, {5.0, 0.0}, {-1.0, 0.0}), 2.0);
  EXPECT_EQ(ray_hit(s, {2.0, 0.0}, {1.0, 0.0}), 0.0);
  EXPECT_EQ(ray_hit(s, {5.0, 0.0}, {1.0, 0.0}), kMiss);
}

TEST(Segment2Test, RayBesideAParallelSegmentMisses) {
  EXPECT_EQ(ray_hit({{1.0, 0.5}, {3.0, 0.5}}, {0.0, 0.0}, {1.0, 0.0}), kMiss);
}

TEST(Segment2Test, RayHitsTheVeryEndsAndWhereItStands) {
  const Segment2 s{{1.0, -1.0}, {1.0, 1.0}};
  EXPECT_EQ(ray_hit(s, {0.0, 1.0}, {1.0, 0.0}), 1.0);
  EXPECT_EQ(ray_hit(s, {0.0, -1.0}, {1.0, 0.0}), 1.0);
  EXPECT_EQ(ray_hit(s, {1.0, 0.0}, {1.0, 0.0}), 0.0);
  EXPECT_EQ(ray_hit(s, {1.5, 0.0}, {1.0, 0.0}), kMiss);
}

}  // namespace
}  // namespace scrubjay
