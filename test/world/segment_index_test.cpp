#include <gtest/gtest.h>

#include <scrubjay/world/segment_index.hpp>
#include <thread>
#include <world/generated.hpp>

namespace scrubjay {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

RayHit cast_at_all(std::span<const SolidSegment> segments, const Point2& origin, const Point2& direction,
                   double max_range) {
  RayHit best;
  for (std::uint32_t i = 0; i < segments.size(); ++i) {
    const double range = ray_hit(segments[i].segment, origin, direction);
    if (range <= max_range && range < best.range) best = {range, i};
  }
  return best;
}

double distance_to_all(std::span<const SolidSegment> segments, const Point2& p, double max_distance) {
  double squared = kInfinity;
  for (const SolidSegment& solid : segments) squared = std::min(squared, squared_distance(solid.segment, p));
  return std::sqrt(squared) <= max_distance ? std::sqrt(squared) : kInfinity;
}

std::vector<std::uint32_t> within_of_all(std::span<const SolidSegment> segments, const Point2& p, double radius) {
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = 0; i < segments.size(); ++i) {
    if (squared_distance(segments[i].segment, p) <= radius * radius) found.push_back(i);
  }
  return found;
}

/// Every tenth ray runs along an axis, and some look from a segment's own end.
struct Ray {
  Point2 origin, direction;
};

Ray random_ray(Random& random, std::span<const SolidSegment> segments, int i) {
  const Point2 origin = i % 7 == 0 ? segments[random.below(static_cast<std::uint32_t>(segments.size()))].segment.a
                                   : test::random_point(random, -5.0, 25.0);
  if (i % 10 != 0) return {origin, direction(random.uniform(-kPi, kPi))};
  constexpr std::array<std::array<double, 2>, 4> kAxes{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  const auto& axis = kAxes[random.below(4)];
  return {origin, {axis[0], axis[1]}};
}

class RandomSegmentsTest : public testing::TestWithParam<int> {
 protected:
  Random random{static_cast<std::uint64_t>(GetParam())};
  SegmentIndex index{test::random_segments(random, 10u << GetParam(), 20.0, 3.0)};
};

TEST_P(RandomSegmentsTest, CastFindsWhatASearchThroughAllFinds) {
  for (int i = 0; i < 5000; ++i) {
    const Ray ray = random_ray(random, index.segments(), i);
    const double max_range = i % 5 == 0 ? kInfinity : random.uniform(0.1, 8.0);
    const RayHit expected = cast_at_all(index.segments(), ray.origin, ray.direction, max_range);
    const RayHit hit = index.cast(ray.origin, ray.direction, max_range);
    ASSERT_EQ(hit.range, expected.range) << "ray " << i;
    if (expected.range == kInfinity) continue;
    ASSERT_EQ(hit.segment, expected.segment) << "ray " << i;
  }
}

TEST_P(RandomSegmentsTest, DistanceIsThatOfASearchThroughAll) {
  for (int i = 0; i < 3000; ++i) {
    const Point2 p = test::random_point(random, -30.0, 50.0);
    const double limit = i % 2 == 0 ? kInfinity : random.uniform(0.0, 2.0);
    ASSERT_EQ(index.distance(p, limit), distance_to_all(index.segments(), p, limit)) << p.transpose();
  }
}

TEST_P(RandomSegmentsTest, WithinFindsEachNearSegmentOnce) {
  std::vector<std::uint32_t> found{99, 99};
  for (int i = 0; i < 3000; ++i) {
    const Point2 p = test::random_point(random, -5.0, 25.0);
    const double radius = random.uniform(0.0, 2.0);
    index.within(p, radius, found);
    ASSERT_EQ(found, within_of_all(index.segments(), p, radius)) << p.transpose() << " radius " << radius;
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomSegmentsTest, testing::Range(0, 10));

TEST(SegmentIndexTest, FindsNothingInAnEmptyWorld) {
  const SegmentIndex index({});
  std::vector<std::uint32_t> found{1};
  index.within({0, 0}, 10.0, found);
  EXPECT_TRUE(found.empty());
  EXPECT_EQ(index.cast({0, 0}, {1, 0}, 10.0).range, kInfinity);
  EXPECT_EQ(index.distance({0, 0}, 10.0), kInfinity);
}

TEST(SegmentIndexTest, HandlesAllSegmentsOnOneLine) {
  const SegmentIndex index({{{{0, 1}, {2, 1}}, 0}, {{{3, 1}, {50, 1}}, 0}});
  EXPECT_EQ(index.cast({1, 0}, {0, 1}, 5.0).range, 1.0);
  EXPECT_EQ(index.cast({2.5, 0}, {0, 1}, 5.0).range, kInfinity);
  EXPECT_EQ(index.cast({0.5, 1}, {1, 0}, 5.0).range, 0.0) << "a ray along a segment, from within";
  EXPECT_EQ(index.cast({2.5, 1}, {1, 0}, 5.0).range, 0.5) << "a ray along a segment, from before";
  EXPECT_EQ(index.distance({2.5, 1}, 5.0), 0.5);
}

TEST(SegmentIndexTest, SeesFromFarOutside) {
  const SegmentIndex index({{{{0, 0}, {0, 1}}, 0}, {{{1, 0}, {1, 1}}, 0}});
  const RayHit hit = index.cast({-1000, 0.5}, {1, 0}, 2000.0);
  EXPECT_EQ(hit.range, 1000.0);
  EXPECT_EQ(hit.segment, 0u);
  EXPECT_EQ(index.cast({-1000, 0.5}, {-1, 0}, 2000.0).range, kInfinity);
  EXPECT_EQ(index.cast({-1000, 0.5}, {1, 0}, 999.0).range, kInfinity);
  EXPECT_EQ(index.distance({-1000, 0.5}, kInfinity), 1000.0);
}

TEST(SegmentIndexTest, OfTwoThatMeetInACornerTheFirstCountsEvenIfTheRayComesByTheOtherBefore) {
  // The sloping one lies in cells along the ray that the other doesn't touch.
  const SolidSegment other{{{2, 0}, {3, -1}}, 0};
  const SolidSegment sloping{{{0.5, 1}, {2, 0}}, 0};
  for (const auto& segments : {std::vector{other, sloping}, std::vector{sloping, other}}) {
    const RayHit hit = SegmentIndex(segments).cast({0, 0}, {1, 0}, 5.0);
    EXPECT_EQ(hit.range, 2.0);
    EXPECT_EQ(hit.segment, 0u);
  }
}

TEST(SegmentIndexTest, MeetsAPointWithoutLength) {
  const SegmentIndex index({{{{1, 1}, {1, 1}}, 0}});
  EXPECT_EQ(index.distance({1, 3}, 5.0), 2.0);
  EXPECT_EQ(index.cast({0, 1}, {1, 0}, 5.0).range, 1.0);
}

TEST(SegmentIndexTest, ReachesExactlyToTheGivenRange) {
  const SegmentIndex index({{{{2, -1}, {2, 1}}, 0}});
  EXPECT_EQ(index.cast({0, 0}, {1, 0}, 2.0).range, 2.0);
  EXPECT_EQ(index.distance({0, 0}, 2.0), 2.0);
  std::vector<std::uint32_t> found;
  index.within({0, 0}, 2.0, found);
  EXPECT_EQ(found.size(), 1u);
}

TEST(SegmentIndexTest, StaysSmallWhenTwoSegmentsLieAKilometreApart) {
  const SegmentIndex index({{{{-1000, -1000}, {-999, -1000}}, 0}, {{{1000, 1000}, {1000, 999}}, 0}});
  EXPECT_NEAR(index.cast({-1000, -999}, {0, -1}, 10.0).range, 1.0, 0.0);
  EXPECT_EQ(index.distance({1000, 998}, 5.0), 1.0);
}

TEST(SegmentIndexTest, CopiesAndThreadsGiveTheSameAnswers) {
  Random random(3);
  const SegmentIndex index(test::random_segments(random, 300, 20.0, 2.0));
  const auto sum = [](const SegmentIndex& of) {
    double total = 0.0;
    for (int i = 0; i < 2000; ++i) total += std::min(9.0, of.cast({10, 10}, direction(i * 0.00314), 9.0).range);
    return total;
  };
  const double expected = sum(index);
  double in_thread = 0.0;
  std::jthread([&] { in_thread = sum(index); }).join();
  const SegmentIndex copy = index;
  EXPECT_EQ(sum(copy), expected);
  EXPECT_EQ(in_thread, expected);
}

}  // namespace
}  // namespace scrubjay
