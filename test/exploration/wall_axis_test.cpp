#include <gtest/gtest.h>

#include <scrubjay/exploration/wall_axis.hpp>

namespace scrubjay {
namespace {

void drive(WallAxis& walls, double heading, double length, double turn = 0.0) {
  const Pose2 from{0.0, 0.0, heading};
  const Point2 to = length * direction(heading);
  walls.add(from, {to.x(), to.y(), wrap_angle(heading + turn)});
}

TEST(WallAxisTest, KnowsNothingAtFirst) {
  EXPECT_EQ(WallAxis().heading(1.2), 1.2);
}

TEST(WallAxisTest, TakesAllFourSidesOfARoomForOneDirection) {
  for (const double turned : {-0.7, -0.2, 0.0, 0.3, 0.75}) {
    WallAxis walls;
    for (int side = 0; side < 4; ++side) drive(walls, wrap_angle(turned + 0.5 * kPi * side), 0.1);
    EXPECT_NEAR(walls.heading(9.0), turned, 1e-9);
  }
}

TEST(WallAxisTest, LongWallsWeighMore) {
  WallAxis walls;
  drive(walls, 0.0, 9.0);
  drive(walls, 0.3, 1.0);
  EXPECT_NEAR(walls.heading(9.0), 0.0, 0.05);
}

TEST(WallAxisTest, LeavesBendsOut) {
  WallAxis walls;
  drive(walls, 0.0, 0.1);
  drive(walls, 0.5, 0.1, 0.1);
  EXPECT_NEAR(walls.heading(9.0), 0.0, 1e-12);
}

}  // namespace
}  // namespace scrubjay
