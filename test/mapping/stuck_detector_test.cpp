#include <gtest/gtest.h>

#include <scrubjay/mapping/stuck_detector.hpp>

namespace scrubjay {
namespace {

constexpr double kTick = 0.015;

Frame at(double stamp, bool held) {
  Frame frame;
  frame.stamp = stamp;
  frame.bump_left = held;
  return frame;
}

/// When a detector first says that the robot is stuck, for a `held(t)` and a `pose(t)`; -1 if never within 100 s.
template <typename Held, typename Place>
double stuck_at(Held&& held, Place&& place, double begin = 0.0) {
  StuckDetector detector{{.patience = 30.0}};
  for (double t = 0.0; t < 100.0; t += kTick) {
    if (detector.update(at(begin + t, held(t)), place(t))) return t;
  }
  return -1.0;
}

Pose2 standing(double) {
  return {};
}

TEST(StuckDetectorTest, ARobotHeldForLongIsStuck) {
  for (const double begin : {0.0, 1.7e9}) {
    EXPECT_NEAR(stuck_at([](double) { return true; }, standing, begin), 30.0, 0.1);
  }
}

TEST(StuckDetectorTest, CountsFromWhenItWasFirstHeld) {
  EXPECT_NEAR(stuck_at([](double t) { return t > 20.0; }, standing), 50.0, 0.1);
}

TEST(StuckDetectorTest, WheelDropsAndCliffsHoldARobotToo) {
  for (int which = 0; which < 4; ++which) {
    StuckDetector detector{{.patience = 30.0}};
    bool stuck = false;
    for (double t = 0.0; t < 40.0; t += kTick) {
      Frame frame = at(t, false);
      frame.bump_right = which == 0;
      frame.wheel_drop_left = which == 1;
      frame.wheel_drop_right = which == 2;
      frame.cliff_flags = which == 3 ? 4 : 0;
      stuck = detector.update(frame, {});
    }
    EXPECT_TRUE(stuck) << "kind " << which;
  }
}

TEST(StuckDetectorTest, ARobotThatShakesItsBumperFreeForMomentsIsStuck) {
  // It backs off by a centimetre, is free for a second, and is held again.
  const auto held = [](double t) { return static_cast<int>(t) % 2 == 0; };
  const auto place = [](double t) { return Pose2{static_cast<int>(t) % 2 * -0.01, 0.0, 0.3 * t}; };
  EXPECT_NEAR(stuck_at(held, place), 30.0, 2.0);
}

TEST(StuckDetectorTest, ARobotThatTurnsFreeIsNot) {
  // Held for ten seconds, then free for three, all at one place.
  const auto held = [](double t) { return static_cast<int>(t) % 13 < 10; };
  EXPECT_EQ(stuck_at(held, [](double t) { return Pose2{0.0, 0.0, wrap_angle(t)}; }), -1.0);
}

TEST(StuckDetectorTest, ARobotThatStandsWithoutBeingHeldIsNot) {
  EXPECT_EQ(stuck_at([](double) { return false; }, standing), -1.0);
}

TEST(StuckDetectorTest, ARobotThatMovesOnIsNot) {
  // Scrapes along a wall with its bumper pressed, a centimetre a second.
  EXPECT_EQ(stuck_at([](double) { return true; }, [](double t) { return Pose2{0.01 * t, 0.0, 0.0}; }), -1.0);
}

TEST(StuckDetectorTest, IsNoLongerStuckWhenItHasMovedAway) {
  StuckDetector detector{{.patience = 30.0}};
  bool stuck = false;
  for (double t = 0.0; t < 40.0; t += kTick) stuck = detector.update(at(t, true), {});
  EXPECT_TRUE(stuck);
  EXPECT_FALSE(detector.update(at(40.1, true), {0.2, 0.0, 0.0}));
}

}  // namespace
}  // namespace scrubjay
