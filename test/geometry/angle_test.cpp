#include <gtest/gtest.h>

#include <cmath>
#include <scrubjay/geometry/angle.hpp>
#include <scrubjay/geometry/random.hpp>

namespace scrubjay {
namespace {

TEST(AngleTest, WrapsIntoOneTurnAndKeepsTheDirection) {
  Random random(1);
  for (int i = 0; i < 100000; ++i) {
    const double angle = random.uniform(-1000.0, 1000.0);
    const double wrapped = wrap_angle(angle);
    EXPECT_LE(std::fabs(wrapped), kPi);
    EXPECT_NEAR(std::remainder(angle - wrapped, 2.0 * kPi), 0.0, 1e-12);
  }
}

TEST(AngleTest, StaysInRangeNextToOddMultiplesOfPi) {
  for (int turns = -1001; turns <= 1001; turns += 2) {
    for (const double toward : {-1e9, 0.0, 1e9}) {
      const double angle = toward == 0.0 ? turns * kPi : std::nextafter(turns * kPi, toward);
      EXPECT_LE(std::fabs(wrap_angle(angle)), kPi) << turns << " turns";
      EXPECT_NEAR(std::fabs(wrap_angle(angle)), kPi, 1e-12) << turns << " turns";
    }
  }
}

TEST(AngleTest, LeavesAnglesInRangeAsTheyAreToTheBit) {
  for (const double angle : {-kPi, -1.0, -0.0, 1e-300, 3.0, kPi}) EXPECT_EQ(wrap_angle(angle), angle);
}

TEST(AngleTest, DifferenceIsTheShortestTurn) {
  EXPECT_NEAR(angle_difference(radians(-170.0), radians(170.0)), radians(20.0), 1e-15);
  EXPECT_NEAR(angle_difference(radians(170.0), radians(-170.0)), radians(-20.0), 1e-15);
  EXPECT_NEAR(angle_difference(0.3, 0.1), 0.2, 1e-15);
}

TEST(AngleTest, DegreesAndRadiansAreInverse) {
  EXPECT_DOUBLE_EQ(radians(180.0), kPi);
  for (const double angle : {-720.0, -12.5, 0.0, 37.5, 90.0}) EXPECT_DOUBLE_EQ(degrees(radians(angle)), angle);
}

}  // namespace
}  // namespace scrubjay
