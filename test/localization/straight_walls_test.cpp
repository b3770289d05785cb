#include <gmock/gmock.h>

#include <cmath>
#include <scrubjay/geometry/random.hpp>
#include <scrubjay/localization/straight_walls.hpp>

#include "lidar_room.hpp"

namespace scrubjay {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

/// What a lidar with 360 beams sees of walls from the origin, with ranges that err.
std::vector<ScanEnd> ends_on(const Walls& walls, double noise, Random& random) {
  std::vector<ScanEnd> ends;
  for (int i = 0; i < 360; ++i) {
    const Point2 way = direction(radians(i - 179.5));
    const double range = distance_to_wall(walls, {0.0, 0.0}, way);
    if (!std::isfinite(range)) continue;
    ends.push_back({(range + noise * random.normal()) * way, -way, noise, radians(1.0) * range, Point2(0.0, 0.0)});
  }
  return ends;
}

std::vector<StraightWall> walls_in(const std::vector<ScanEnd>& ends) {
  std::vector<StraightWall> walls;
  find_straight_walls(ends, walls);
  return walls;
}

/// A wall of this length, `away` from the origin, whose middle is straight ahead and which is turned by `angle`.
Walls wall(double length, double away, double angle) {
  const Point2 half = 0.5 * length * direction(angle + 0.5 * kPi);
  return {{Point2(away, 0.0) - half, Point2(away, 0.0) + half}};
}

double angle_between(const Point2& a, const Point2& b) {
  return std::acos(std::min(1.0, std::fabs(a.dot(b))));
}

TEST(StraightWallsTest, HaveTheirDirectionAndLength) {
  Random random(1);
  for (const double angle : {-1.0, -0.4, 0.0, 0.7}) {
    const std::vector<StraightWall> found = walls_in(ends_on(wall(2.0, 1.5, angle), 0.001, random));
    ASSERT_THAT(found, SizeIs(1));
    EXPECT_LT(angle_between(found[0].along, direction(angle + 0.5 * kPi)), radians(0.1));
    EXPECT_NEAR(found[0].length, 2.0, 0.35);
  }
}

TEST(StraightWallsTest, ErrByNoMoreThanTheySay) {
  Random random(2);
  double squares = 0.0;
  int count = 0;
  for (int i = 0; i < 400; ++i) {
    const double angle = random.uniform(-0.9, 0.9);
    for (const StraightWall& each : walls_in(ends_on(wall(2.0, 1.5, angle), 0.03, random))) {
      if (each.count < 40) continue;  // noise took it in two
      const double off = angle_between(each.along, direction(angle + 0.5 * kPi));
      squares += off * off / each.angle_variance;
      ++count;
    }
  }
  EXPECT_GT(count, 300);
  EXPECT_LT(squares / count, 1.5);
  EXPECT_GT(squares / count, 0.5);
}

TEST(StraightWallsTest, AreTurnedNeitherWayByNoise) {
  // Seen aslant: the noise of ranges alone would turn it towards the robot, always the same way.
  Random random(3);
  double sum = 0.0;
  int count = 0;
  for (int i = 0; i < 400; ++i) {
    for (const StraightWall& each : walls_in(ends_on(wall(1.2, 1.8, 0.8), 0.05, random))) {
      const Point2 expected = direction(0.8 + 0.5 * kPi);
      const Point2 along = each.along.dot(expected) < 0.0 ? Point2(-each.along) : each.along;
      sum += expected.x() * along.y() - expected.y() * along.x();
      ++count;
    }
  }
  EXPECT_GT(count, 200);
  EXPECT_NEAR(sum / count, 0.0, radians(0.5));
}

TEST(StraightWallsTest, AreFourInARoom) {
  const Walls room{{{-2, -1.5}, {3, -1.5}}, {{3, -1.5}, {3, 2}}, {{3, 2}, {-2, 2}}, {{-2, 2}, {-2, -1.5}}};
  Random random(4);
  const std::vector<ScanEnd> ends = ends_on(room, 0.01, random);
  double length = 0.0;
  std::size_t end = 0;
  for (const StraightWall& each : walls_in(ends)) {
    EXPECT_LT(std::min(angle_between(each.along, {1, 0}), angle_between(each.along, {0, 1})), radians(2.0));
    EXPECT_GE(each.first, end) << "an end is of one wall";
    end = each.first + each.count;
    length += each.length;
  }
  EXPECT_LE(end, ends.size());
  EXPECT_GT(length, 14.0) << "of 17 m";
}

TEST(StraightWallsTest, EndAtGaps) {
  const Walls posts{{{2.0, -1.0}, {2.0, -0.4}}, {{2.0, 0.4}, {2.0, 1.0}}};
  Random random(5);
  for (const StraightWall& each : walls_in(ends_on(posts, 0.01, random))) EXPECT_LT(each.length, 0.8);
}

TEST(StraightWallsTest, AreNeitherRoundNorShortNorRough) {
  Random random(6);
  Walls round;
  for (int i = 0; i < 60; ++i) {
    const Point2 middle(1.0, 0.0);
    round.push_back({middle + 0.4 * direction(radians(6.0 * i)), middle + 0.4 * direction(radians(6.0 * (i + 1)))});
  }
  EXPECT_THAT(walls_in(ends_on(round, 0.005, random)), IsEmpty());
  EXPECT_THAT(walls_in(ends_on(wall(0.4, 1.0, 0.0), 0.005, random)), IsEmpty());
  std::vector<ScanEnd> rough = ends_on(wall(2.0, 1.5, 0.0), 0.2, random);
  for (ScanEnd& end : rough) end.noise = 0.01;
  EXPECT_THAT(walls_in(rough), IsEmpty());
  EXPECT_THAT(walls_in({}), IsEmpty());
}

TEST(StraightWallsTest, AreFoundInTimeAmongAnyNumberOfEnds) {
  // A spiral of a hundred thousand ends, as a message may tell: no wall, and no gap either.
  std::vector<ScanEnd> ends;
  for (int i = 0; i < 100'000; ++i) {
    const double angle = 1e-3 * i;
    ends.push_back({(1.0 + 0.01 * angle) * direction(angle), -direction(angle), 1e-3, 1e-3, Point2(0.0, 0.0)});
  }
  EXPECT_THAT(walls_in(ends), IsEmpty());
}

}  // namespace
}  // namespace scrubjay
