#include <gtest/gtest.h>

#include <cmath>
#include <scrubjay/behavior/wander.hpp>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "lidar_world.hpp"
#include "situations.hpp"

namespace scrubjay::test {
namespace {

int ticks_in(double seconds) {
  return static_cast<int>(std::lround(seconds / LidarWorld::kTick));
}

void add(std::vector<Segment2>& walls, const std::vector<Segment2>& more) {
  walls.insert(walls.end(), more.begin(), more.end());
}

/// Two rooms with a doorway of 0.8 m, a dead end 0.45 m wide, a cupboard, a table's legs, and a corner under 45
/// degrees.
std::vector<Segment2> flat() {
  std::vector<Segment2> walls = box_segments({0.0, 0.0}, {6.0, 3.5});
  add(walls, {{{3.0, 0.0}, {3.0, 1.2}}, {{3.0, 2.0}, {3.0, 3.5}}});
  add(walls, {{{4.5, 3.05}, {6.0, 3.05}}});
  add(walls, box_segments({0.0, 2.9}, {1.2, 3.5}));
  for (const Point2& leg : {Point2(1.2, 1.0), Point2(1.9, 1.0), Point2(1.2, 1.6), Point2(1.9, 1.6)}) {
    add(walls, box_segments(leg - Point2(0.02, 0.02), leg + Point2(0.02, 0.02)));
  }
  add(walls, {{{5.2, 0.0}, {6.0, 0.8}}});
  return walls;
}

// Three times 40 minutes.
TEST(WanderTest, DrivesForHoursWithoutContactAndSeesEveryPlace) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    LidarWorld world(flat(), {0.5, 0.5, 0.3}, seed);
    Wander wander(world.robot(), Random(seed));
    std::set<std::pair<int, int>> visited;
    double least = 1.0;
    for (int i = 0; i < ticks_in(2400.0); ++i) {
      world.step(wander);
      least = std::min(least, world.clearance());
      visited.insert({static_cast<int>(world.pose().x / 0.5), static_cast<int>(world.pose().y / 0.5)});
    }
    EXPECT_GT(least, 0.01) << "seed " << seed;
    EXPECT_GT(world.distance(), 200.0) << "of the 528 m that it could have driven";
    // 12 x 7 squares of half a metre; the cupboard takes two and a half.
    EXPECT_GT(visited.size(), 72u) << "seed " << seed;
  }
}

TEST(WanderTest, GetsOutOfADeadEnd) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    // A blind alley 0.4 m wide and 1.5 m deep; the robot looks into it.
    LidarWorld world({{{0.0, 0.0}, {1.5, 0.0}},
                      {{0.0, 0.4}, {1.5, 0.4}},
                      {{1.5, 0.0}, {1.5, 0.4}},
                      {{0.0, 0.4}, {0.0, 2.0}},
                      {{0.0, 0.0}, {0.0, -2.0}},
                      {{0.0, 2.0}, {-2.0, 2.0}},
                      {{0.0, -2.0}, {-2.0, -2.0}},
                      {{-2.0, -2.0}, {-2.0, 2.0}}},
                     {1.2, 0.2, 0.0}, seed);
    Wander wander(world.robot(), Random(seed));
    int ticks = 0;
    while (world.pose().x > -0.3 && ticks < ticks_in(60.0)) {
      world.step(wander);
      ASSERT_GT(world.clearance(), 0.0);
      ++ticks;
    }
    EXPECT_LT(ticks, ticks_in(60.0)) << "seed " << seed;
  }
}

TEST(WanderTest, ATurnKeepsItsSide) {
  LidarWorld world(flat(), {0.5, 0.5, 0.3}, 4);
  Wander wander(world.robot(), Random(4));
  std::string_view before;
  int turns = 0;
  for (int i = 0; i < ticks_in(900.0); ++i) {
    const std::string_view doing = world.step(wander).doing;
    const bool other_side = (before == "turning left" && doing == "turning right") ||
                            (before == "turning right" && doing == "turning left");
    EXPECT_FALSE(other_side) << "at " << i * LidarWorld::kTick << " s";
    turns += before == "forward" && doing != "forward";
    before = doing;
  }
  EXPECT_GT(turns, 75);
}

TEST(WanderTest, StopsBeforeAWallThatWasntThere) {
  LidarWorld world(box_segments({0.0, 0.0}, {6.0, 2.0}), {0.5, 1.0, 0.0}, 1);
  Wander wander(world.robot(), Random(1));
  // Whenever it drives at full speed, a wall is put a third of a metre before its nose: a lidar's turn and braking.
  int times = 0;
  for (int i = 0; i < ticks_in(600.0); ++i) {
    const Decision decision = world.step(wander);
    EXPECT_GT(world.clearance(), 0.0);
    const Point2 ahead = direction(world.pose().yaw);
    const Point2 middle = world.pose().position() + (world.robot().radius + 0.33) * ahead;
    const bool inside = middle.x() > 0.5 && middle.x() < 5.5 && middle.y() > 0.5 && middle.y() < 1.5;
    if (i % 500 == 0) {
      world.put_walls(box_segments({0.0, 0.0}, {6.0, 2.0}));
    } else if (i % 500 > 250 && decision.motion.linear > 0.21 && inside && times < 1 + i / 500) {
      std::vector<Segment2> walls = box_segments({0.0, 0.0}, {6.0, 2.0});
      const Point2 aside = 0.2 * Point2(-ahead.y(), ahead.x());
      walls.push_back({middle - aside, middle + aside});
      world.put_walls(walls);
      ++times;
    }
  }
  EXPECT_GT(times, 10);
}

TEST(WanderTest, SlowsDownTowardsAWall) {
  const std::vector<Segment2> walls = box_segments({0.0, 0.0}, {1.2, 1.2});
  LidarWorld world(walls, {0.4, 0.5, 0.0}, 2, 0.0);
  double nearest = 10.0;
  Wander wander(world.robot(), Random(2));
  for (int i = 0; i < ticks_in(300.0); ++i) {
    const Decision decision = world.step(wander);
    double to_wall = 10.0;  // before its nose
    for (const Segment2& wall : walls) {
      to_wall = std::min(to_wall, ray_hit(wall, world.pose().position(), direction(world.pose().yaw)));
    }
    to_wall -= world.robot().radius;
    if (to_wall < 0.12) {
      EXPECT_LT(decision.motion.linear, 0.19);
    }
    nearest = std::min(nearest, to_wall);
  }
  EXPECT_LT(nearest, 0.12);
}

TEST(WanderTest, StandsWithoutScans) {
  const RobotModel robot = burger();
  Wander wander(robot, Random(1));
  for (int i = 0; i < 500; ++i) EXPECT_EQ(decide(wander, quiet_frame(0.02 * i)).motion, Motion{});
}

TEST(WanderTest, StandsWhenTheLidarFallsSilent) {
  LidarWorld world(box_segments({0.0, 0.0}, {6.0, 6.0}), {3.0, 3.0, 0.0}, 1);
  Wander wander(world.robot(), Random(1));
  while (world.step(wander).motion.linear < 0.2) {
  }
  const double silent_from = 1000.0;  // the next frame comes long after the last scan
  EXPECT_EQ(decide(wander, quiet_frame(silent_from), world.pose()).motion, Motion{});
}

TEST(WanderTest, StandsWhereItIsBoxedIn) {
  LidarWorld world(box_segments({0.0, 0.0}, {0.26, 0.26}), {0.13, 0.13, 0.0}, 1, 0.0);
  Wander wander(world.robot(), Random(1));
  for (int i = 0; i < ticks_in(20.0); ++i) {
    EXPECT_EQ(world.step(wander).motion.linear, 0.0);
    EXPECT_GT(world.clearance(), 0.0);
  }
}

TEST(WanderTest, LeavesATightPlaceByTheSlimMargin) {
  // A passage of 0.25 m, 2 cm on either side of the disc.
  LidarWorld world({{{0.0, 0.0}, {1.0, 0.0}},
                    {{0.0, 0.25}, {1.0, 0.25}},
                    {{0.0, 0.0}, {0.0, 0.25}},
                    {{1.0, 0.0}, {1.0, -1.0}},
                    {{1.0, 0.25}, {1.0, 1.0}},
                    {{1.0, 1.0}, {3.0, 1.0}},
                    {{1.0, -1.0}, {3.0, -1.0}},
                    {{3.0, -1.0}, {3.0, 1.0}}},
                   {0.5, 0.125, 0.0}, 1, 0.0);
  Wander wander(world.robot(), Random(1));
  double farthest = 0.0;
  for (int i = 0; i < ticks_in(120.0); ++i) {
    world.step(wander);
    ASSERT_GT(world.clearance(), 0.0);
    farthest = std::max(farthest, world.pose().x);
  }
  EXPECT_GT(farthest, 1.3);
}

TEST(WanderTest, BacksOffFromATouchAndTurnsAway) {
  LidarWorld world(box_segments({0.0, 0.0}, {4.0, 4.0}), {2.0, 2.0, 0.0}, 1);
  Wander wander(world.robot(), Random(1));
  while (world.step(wander).motion.linear < 0.2) {
  }
  world.press_bumper(true);  // by something that the lidar looks over
  EXPECT_EQ(std::string_view(world.step(wander).doing), "backing off");
  world.press_bumper(false);
  double least = 0.0;
  std::string_view doing;
  for (int i = 0; i < ticks_in(1.0) && doing.substr(0, 7) != "turning"; ++i) {
    const Decision decision = world.step(wander);
    least = std::min(least, decision.motion.linear);
    doing = decision.doing;
  }
  EXPECT_LT(least, -0.05);
  EXPECT_EQ(doing.substr(0, 7), "turning");
}

TEST(WanderTest, TheSameSeedDrivesTheSameWay) {
  const auto end_of = [](std::uint64_t seed) {
    LidarWorld world(flat(), {0.5, 0.5, 0.3}, 9);
    Wander wander(world.robot(), Random(seed));
    for (int i = 0; i < ticks_in(60.0); ++i) world.step(wander);
    return world.pose();
  };
  EXPECT_EQ(end_of(1), end_of(1));
  EXPECT_NE(end_of(1), end_of(2));
}

/// A Roomba without a world: it turns as it wants, and senses what it is told.
struct BlindRun {
  Decision step(Frame frame) {
    frame.stamp = 0.015 * ticks++;
    const Decision decision = decide(wander, frame, pose);
    pose.yaw = wrap_angle(pose.yaw + 0.015 * decision.motion.angular);
    const Point2 moved = 0.015 * decision.motion.linear * direction(pose.yaw);
    pose = {pose.x + moved.x(), pose.y + moved.y(), pose.yaw};
    return decision;
  }
  /// Until it drives forward, sensing nothing.
  void set_off() {
    for (int i = 0; i < 2000 && step(quiet_frame()).motion.linear <= 0.0; ++i) {
    }
  }

  Wander wander{RobotModel{}, Random(3)};
  Pose2 pose;
  int ticks = 0;
};

TEST(WanderBlindTest, DrivesUntilItsLightSensorsTellOfSomething) {
  BlindRun run;
  run.set_off();
  for (int i = 0; i < 1000; ++i) EXPECT_GT(run.step(quiet_frame()).motion.linear, 0.0);
  const Decision decision = run.step(lit_frame(LightSensor::CenterLeft, 0.04));
  EXPECT_EQ(decision.motion.linear, 0.0);
  EXPECT_NE(decision.motion.angular, 0.0);
}

TEST(WanderBlindTest, TurnsAwayFromTheSideThatIsBlocked) {
  for (const auto& [sensor, sign] : {std::pair{LightSensor::FrontLeft, -1.0}, {LightSensor::FrontRight, 1.0}}) {
    BlindRun run;
    run.set_off();
    for (int i = 0; i < 30; ++i) EXPECT_GT(sign * run.step(lit_frame(sensor, 0.04)).motion.angular, 0.0);
  }
}

TEST(WanderBlindTest, ABumpIsBackedOffFromAndTurnedAwayFrom) {
  BlindRun run;
  run.set_off();
  Frame bump = quiet_frame();
  bump.bump_right = true;
  const Point2 before = run.pose.position();
  const Point2 ahead = direction(run.pose.yaw);
  EXPECT_LT(run.step(bump).motion.linear, 0.0);
  std::string_view doing;
  for (int i = 0; i < 100 && doing != "turning left"; ++i) doing = run.step(quiet_frame()).doing;
  EXPECT_EQ(doing, "turning left");
  EXPECT_NEAR((run.pose.position() - before).dot(ahead), -WanderParams{}.back_off, 0.01);
}

TEST(WanderBlindTest, ATouchThatLastsIsTurnedAwayFromNotPushed) {
  BlindRun run;
  run.set_off();
  Frame wedged = quiet_frame();
  wedged.bump_left = true;
  double turned = 0.0;
  int backwards = 0;
  for (int i = 0; i < 2000; ++i) {
    const Decision decision = run.step(wedged);
    EXPECT_LE(decision.motion.linear, 0.0);
    turned += 0.015 * std::fabs(decision.motion.angular);
    backwards += decision.motion.linear < 0.0;
  }
  EXPECT_GT(turned, 4.0 * kPi);
  EXPECT_GT(backwards, 3 * 25) << "it tries to back off now and then";
  EXPECT_LT(backwards, 1000);
}

TEST(WanderBlindTest, NeverDrivesOnAtACliff) {
  BlindRun run;
  run.set_off();
  for (int i = 0; i < 2000; ++i) EXPECT_LE(run.step(cliff_frame(CliffSensor::FrontLeft)).motion.linear, 0.0);
}

TEST(WanderBlindTest, LeavesATightPlaceByTouch) {
  BlindRun run;
  run.set_off();
  Frame tight = quiet_frame();
  tight.light_signal.fill(light_signal_at(0.03, RobotModel{}));
  bool forward = false;
  for (int i = 0; i < 2000; ++i) forward |= run.step(tight).motion.linear > 0.0;
  EXPECT_TRUE(forward) << "after a whole turn";
}

TEST(WanderBlindTest, AVirtualWallIsTurnedAwayFromAndLeftBehind) {
  BlindRun run;
  run.set_off();
  Frame fence = quiet_frame();
  fence.virtual_wall = true;
  const double before = run.pose.yaw;
  EXPECT_EQ(run.step(fence).motion.linear, 0.0);
  int ticks = 0;
  while (run.step(fence).motion.linear <= 0.0 && ticks < 2000) ++ticks;
  EXPECT_LT(ticks, 2000) << "its beam is seen all the while";
  EXPECT_GT(std::fabs(angle_difference(run.pose.yaw, before)), radians(110.0));
}

}  // namespace
}  // namespace scrubjay::test
