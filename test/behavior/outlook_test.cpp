#include <gtest/gtest.h>

#include <cmath>
#include <scrubjay/behavior/outlook.hpp>

#include "situations.hpp"

namespace scrubjay::test {
namespace {

// Cells of 0.1 m: a known room with a doorway to unknown floor on its right side.
const DrawnMap kRoom({"####################          ", "#..................#          ",
                      "#..................           ", "#..................           ",
                      "#..................           ", "#..................           ",
                      "#..................           ", "#..................           ",
                      "#..................           ", "#..................           ",
                      "#..................           ", "#..................#          ",
                      "####################          "},
                     0.1);
constexpr double kRadius = 0.1735;
const Point2 kMiddle{1.0, 0.65};

TEST(OutlookTest, UnknownFloorLiesThroughTheDoorway) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    const auto heading = heading_to_unknown(kRoom.view(), {kMiddle, kRadius, kPi}, random);
    ASSERT_TRUE(heading);
    EXPECT_LT(std::fabs(*heading), radians(25.0));
  }
}

TEST(OutlookTest, HeadingsTowardsTheObstacleAtHandAreNotTried) {
  Random random(1);
  EXPECT_FALSE(heading_to_unknown(kRoom.view(), {kMiddle, kRadius, 0.0}, random));
}

TEST(OutlookTest, ADiscWiderThanTheDoorwayDoesNotPass) {
  Random random(1);
  EXPECT_TRUE(heading_to_unknown(kRoom.view(), {kMiddle, 0.2, kPi}, random));
  EXPECT_FALSE(heading_to_unknown(kRoom.view(), {kMiddle, 0.5, kPi}, random));
}

TEST(OutlookTest, UnknownFloorTooShortIsNotWorthWhile) {
  OutlookParams params;
  Random random(1);
  params.worthwhile = 2.0;  // the map ends a metre behind the doorway
  EXPECT_FALSE(heading_to_unknown(kRoom.view(), {kMiddle, kRadius, kPi}, random, params));
}

TEST(OutlookTest, AllKnownNothingIsWorthWhile) {
  const DrawnMap closed({"######", "#....#", "#....#", "#....#", "######"}, 0.2);
  Random random(1);
  EXPECT_FALSE(heading_to_unknown(closed.view(), {{0.6, 0.5}, kRadius, kPi}, random));
}

TEST(OutlookTest, ALegAskewInFrontEndsADrive) {
  // Unknown floor to the right only, and a leg that the shoulder of the disc would hit.
  const DrawnMap map({"##################", "########         #", "#......#.        #", "#.......         #",
                      "#.......         #", "#......#.        #", "########         #", "##################"},
                     0.05);
  const Standpoint here{{0.2, 0.2}, kRadius, kPi};
  Random random(1);
  EXPECT_FALSE(heading_to_unknown(map.view(), here, random)) << "two cells are too narrow a gap";
}

TEST(OutlookTest, TheLongestHeadingRunsAlongTheRoom) {
  const DrawnMap hall({"########################################", "#......................................#",
                       "#......................................#", "#......................................#",
                       "#......................................#", "#......................................#",
                       "#......................................#", "########################################"},
                      0.1);
  Random random(2);
  const double heading = longest_heading(hall.view(), {{0.4, 0.4}, kRadius, kPi}, random);
  EXPECT_LT(std::fabs(heading), radians(12.0));
}

TEST(OutlookTest, WithoutAMapItLooksAwayFromTheObstacle) {
  Random random(2);
  EXPECT_FALSE(heading_to_unknown({}, {{0.0, 0.0}, kRadius, 1.0}, random));
  const double heading = longest_heading({}, {{0.0, 0.0}, kRadius, 1.0}, random);
  EXPECT_GE(std::fabs(angle_difference(heading, 1.0)), radians(75.0) - 1e-9);
}

// A wall on top, and below it the floor that a robot swept; cells of 0.05 m.
const DrawnMap kLane({"####################", "....................", "....................", "....................",
                      "....................", "....................", "....................", "....................",
                      "                    ", "                    ", "                    ", "                    "});
const DrawnMap kNewWall({"       ######       ", "       ......       ", "       ......       ", "       ......       ",
                         "       ......       ", "       ......       ", "       ......       ", "       ......       ",
                         "       ......       ", "       ......       ", "       ......       ",
                         "       ......       "});

TEST(OutlookTest, AnEdgeWithALaneOfKnownFloorIsKnown) {
  const Point2 at_wall{0.5, 0.36};
  EXPECT_TRUE(beside_known_floor(kLane.view(), {at_wall, kRadius, kPi / 2.0}, kPi / 2.0));
  EXPECT_FALSE(beside_known_floor(kNewWall.view(), {at_wall, kRadius, kPi / 2.0}, kPi / 2.0));
}

TEST(OutlookTest, AnEdgeMetAtAGrazingAngleIsKnownByTheFloorAhead) {
  const Point2 beside_wall{0.4, 0.36};
  EXPECT_TRUE(beside_known_floor(kLane.view(), {beside_wall, kRadius, radians(75.0)}, radians(10.0)));
  // New floor ahead: only what it has just driven over is known.
  const DrawnMap half({"##########          ", "..........          ", "..........          ", "..........          ",
                       "..........          ", "..........          ", "..........          ", "..........          ",
                       "..........          ", "                    ", "                    ", "                    "});
  EXPECT_FALSE(beside_known_floor(half.view(), {beside_wall, kRadius, radians(75.0)}, radians(10.0)));
}

}  // namespace
}  // namespace scrubjay::test
