#include <gtest/gtest.h>

#include <cmath>
#include <scrubjay/localization/wall_compass.hpp>

namespace scrubjay {
namespace {

/// Walls of 1 m at these angles [degrees] of the house, as a robot sees them that heads `yaw` [rad].
std::vector<StraightWall> walls_at(const std::vector<double>& angles, double yaw) {
  std::vector<StraightWall> walls;
  for (const double angle : angles) {
    walls.push_back({0, 20, direction(radians(angle) - yaw), 1.0, radians(0.5) * radians(0.5)});
  }
  return walls;
}

/// In a house that stands at 20 degrees.
class WallCompassTest : public ::testing::Test {
 protected:
  WallCompassTest() {
    for (int i = 0; i < 10; ++i) compass_.read(walls_at({20, 110, -70, 200}, 0.0), 0.0);
  }

  WallCompass compass_;
};

TEST_F(WallCompassTest, TellsWhatAHeadingIsOffBy) {
  for (const double yaw : {-3.1, -0.5, 0.0, 1.0, 3.1}) {
    for (const double off : {radians(-4.0), radians(-0.3), 0.0, radians(2.0)}) {
      WallCompass compass = compass_;
      const auto error = compass.read(walls_at({20, -70}, yaw), yaw - off);
      ASSERT_TRUE(error);
      EXPECT_NEAR(error->off, off, 1e-9);
      EXPECT_GT(error->information, 0.0);
    }
  }
}

TEST_F(WallCompassTest, HasNothingToSayAtFirst) {
  WallCompass fresh;
  EXPECT_FALSE(fresh.read({}, 0.3));
  EXPECT_FALSE(fresh.read(walls_at({20, 110}, 0.3), 0.3));
  EXPECT_TRUE(fresh.read(walls_at({20, 110}, 0.3), 0.3));
}

TEST_F(WallCompassTest, IsSurerOfManyWallsThanOfOne) {
  WallCompass other = compass_;
  EXPECT_GT(compass_.read(walls_at({20, 20, 110, 110}, 0.0), 0.0)->information,
            3.0 * other.read(walls_at({20}, 0.0), 0.0)->information);
}

TEST_F(WallCompassTest, SaysNothingWhereWallsAreOfAnotherKind) {
  EXPECT_FALSE(compass_.read(walls_at({65, 65, -25}, 0.0), 0.0));
  EXPECT_FALSE(compass_.read(walls_at({20, 30, 50, 80}, 0.0), 0.0)) << "most of them";
  EXPECT_FALSE(compass_.read({}, 0.0));
}

TEST_F(WallCompassTest, LeavesOutAFewOfAnotherKind) {
  const auto error = compass_.read(walls_at({20, 110, 20, 65}, 0.0), radians(-1.0));
  ASSERT_TRUE(error);
  EXPECT_NEAR(error->off, radians(1.0), 1e-9);
}

TEST_F(WallCompassTest, IsHardlyMovedByAWallThatStandsAskew) {
  const auto error = compass_.read(walls_at({20, 110, 20, 20, 110, 24}, 0.0), 0.0);
  ASSERT_TRUE(error);
  EXPECT_LT(std::fabs(error->off), radians(0.35)) << "the mean is 0.67";
}

TEST_F(WallCompassTest, StaysWithTheFirstWallsWhenHeadingsDrift) {
  // 200 scans of a robot that doesn't listen, and turns by a fiftieth of a degree from each to the next.
  std::optional<HeadingError> error;
  for (int i = 0; i < 200; ++i) {
    const double drift = radians(0.02) * i;
    error = compass_.read(walls_at({20, 110}, 0.0), drift);
  }
  EXPECT_LT(error->off, radians(-1.8)) << "half of the four degrees";
}

}  // namespace
}  // namespace scrubjay
