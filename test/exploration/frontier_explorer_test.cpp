#include <gtest/gtest.h>

#include <exploration/drawn_world.hpp>
#include <scrubjay/error.hpp>
#include <scrubjay/exploration/frontier_explorer.hpp>
#include <string_view>

namespace scrubjay {
namespace {

using test::DrawnRun;
using test::DrawnWorld;

const std::vector<std::string> kTwoRooms{
    "#########################",  //
    "#..........#............#",  //
    "#..........#............#",  //
    "#..........#............#",  //
    "#.......................#",  //
    "#...r...................#",  //
    "#.......................#",  //
    "#.......................#",  //
    "#..........#...###......#",  //
    "#..........#...###......#",  //
    "#..........#............#",  //
    "#########################",  //
};

std::size_t unknown_floor(const DrawnRun& run) {
  std::size_t count = 0;
  for (std::int32_t y = 0; y < run.world.grid().height; ++y) {
    for (std::int32_t x = 0; x < run.world.grid().width; ++x) {
      if (!run.world.blocks({x, y}) && run.known({x, y}) != kFree) ++count;
    }
  }
  return count;
}

std::size_t left_because(const Behavior& behavior, std::string_view why) {
  std::size_t count = 0;
  for (const Leftover& leftover : behavior.leftovers()) count += leftover.why == why ? 1 : 0;
  return count;
}

std::string reasons(const Behavior& behavior) {
  std::string list;
  for (const Leftover& leftover : behavior.leftovers()) {
    list += std::to_string(leftover.where.x()) + ", " + std::to_string(leftover.where.y()) + ": " + leftover.why + "\n";
  }
  return list;
}

TEST(FrontierExplorerTest, SeesAllThatItCanReachAndIsDone) {
  DrawnWorld world(kTwoRooms);
  FrontierExplorer explorer(DrawnRun::robot());
  DrawnRun run(world, explorer);
  ASSERT_TRUE(run.run(300.0));
  EXPECT_LE(unknown_floor(run), 2u);  // a corner may be too small to count
  EXPECT_TRUE(explorer.leftovers().empty()) << reasons(explorer);
  EXPECT_EQ(run.touches, 0);
  EXPECT_STREQ(run.decision.doing, "done");
  EXPECT_EQ(run.decision.motion, Motion{});
}

TEST(FrontierExplorerTest, DoesTheSameThingTwice) {
  Pose2 ends[2];
  for (Pose2& end : ends) {
    DrawnWorld world(kTwoRooms);
    FrontierExplorer explorer(DrawnRun::robot());
    DrawnRun run(world, explorer);
    ASSERT_TRUE(run.run(300.0));
    end = run.estimate.pose;
  }
  EXPECT_EQ(ends[0], ends[1]);
}

TEST(FrontierExplorerTest, IsNotDoneBeforeItHasSeenAnything) {
  FrontierExplorer explorer(DrawnRun::robot());
  const GrowingMap nothing(0.1);
  const PoseEstimate estimate;
  for (int tick = 0; tick < 1000; ++tick) {
    Frame frame;
    frame.stamp = 0.02 * tick;
    const Decision decision = explorer.decide({frame, estimate, nothing.view(), {}});
    ASSERT_FALSE(decision.done);
    ASSERT_EQ(decision.motion, Motion{});
  }
}

TEST(FrontierExplorerTest, TellsOfAGapThatIsTooNarrow) {
  DrawnWorld world({
      "####################",  //
      "#........#.........#",  //
      "#........#.........#",  //
      "#..................#",  //
      "#...r..............#",  //
      "#........#.........#",  //
      "#........#.........#",  //
      "####################",  //
  });
  FrontierExplorer explorer(DrawnRun::robot());
  DrawnRun run(world, explorer);
  ASSERT_TRUE(run.run(300.0));
  EXPECT_GT(unknown_floor(run), 0u);
  EXPECT_GT(left_because(explorer, "too narrow for the robot"), 0u);
  EXPECT_EQ(left_because(explorer, "too narrow for the robot"), explorer.leftovers().size()) << reasons(explorer);
  EXPECT_EQ(run.touches, 0);
}

TEST(FrontierExplorerTest, LeavesWhatIsOutOfBounds) {
  DrawnWorld world(kTwoRooms);
  FrontierExplorerParams params;
  params.within = Bounds2{{0.0, 0.0}, {1.1, 1.2}};  // the left room
  FrontierExplorer explorer(DrawnRun::robot(), params);
  DrawnRun run(world, explorer);
  ASSERT_TRUE(run.run(300.0));
  EXPECT_GT(left_because(explorer, "out of bounds"), 0u);
  EXPECT_EQ(left_because(explorer, "out of bounds"), explorer.leftovers().size()) << reasons(explorer);
  EXPECT_EQ(run.known({3, 9}), kFree);
  EXPECT_EQ(run.known({22, 3}), kUnknown);
}

TEST(FrontierExplorerTest, SaysThatThereIsNoWayIntoARoomThatWasClosed) {
  DrawnWorld world(kTwoRooms);
  FrontierExplorer explorer(DrawnRun::robot());
  DrawnRun run(world, explorer);
  run.run(1.0);  // it has seen the opening, and a bit of what is behind it
  ASSERT_EQ(run.known({12, 6}), kFree);
  for (std::int32_t y = 4; y <= 7; ++y) world.at({11, y}) = '#';
  ASSERT_TRUE(run.run(300.0));
  EXPECT_GT(left_because(explorer, "no way there"), 0u);
  EXPECT_EQ(left_because(explorer, "no way there"), explorer.leftovers().size()) << reasons(explorer);
  EXPECT_EQ(run.known({3, 9}), kFree);
}

const std::vector<std::string> kGlassDoor{
    "##############################",  //
    "#.........#..................#",  //
    "#.........#..................#",  //
    "#.........#..................#",  //
    "#.........g..................#",  //
    "#...r.....g..................#",  //
    "#.........g..................#",  //
    "#.........g..................#",  //
    "#.........#..................#",  //
    "#.........#..................#",  //
    "##############################",  //
};

TEST(FrontierExplorerTest, GivesUpWhatItCanNotGetTo) {
  DrawnWorld world(kGlassDoor);
  FrontierExplorer explorer(DrawnRun::robot());
  DrawnRun run(world, explorer);
  ASSERT_TRUE(run.run(600.0));
  EXPECT_GT(left_because(explorer, "given up"), 0u);
  EXPECT_EQ(left_because(explorer, "not reached yet"), 0u) << reasons(explorer);
  EXPECT_EQ(run.known({28, 9}), kUnknown);
}

TEST(FrontierExplorerTest, ForgivesWhenTheMapChangesWhereItGaveUp) {
  DrawnWorld world(kGlassDoor);
  FrontierExplorer explorer(DrawnRun::robot());
  DrawnRun run(world, explorer);
  while (left_because(explorer, "given up") == 0) ASSERT_TRUE(run.step());
  world.replace('g', '.');                 // the door opens ...
  for (std::int32_t y = 1; y <= 3; ++y) {  // ... and its frame goes, too
    world.at({10, y}) = world.at({10, 11 - 1 - y}) = '.';
  }
  ASSERT_TRUE(run.run(600.0));
  EXPECT_LE(unknown_floor(run), 2u);
  EXPECT_TRUE(explorer.leftovers().empty()) << reasons(explorer);
}

/// Free floor in an unknown world, painted by hand; the robot stands at the origin and looks along x.
class PaintedFloor {
 public:
  PaintedFloor() { map_.cover({0.0, 0.0}, 6.0); }
  void paint(const Point2& low, const Point2& high, LogOdds value) {
    const CellIndex from = map_.view().geometry.cell_at(low);
    const CellIndex to = map_.view().geometry.cell_at(high);
    for (std::int32_t y = from.y; y < to.y; ++y) {
      for (std::int32_t x = from.x; x < to.x; ++x) map_.view()[{x, y}] = value;
    }
  }
  /// Which way the robot turns at first: to the left is positive.
  double first_turn(const FrontierExplorerParams& params) {
    FrontierExplorer explorer(DrawnRun::robot(), params);
    const PoseEstimate estimate;
    for (int tick = 0; tick < 200; ++tick) {
      Frame frame;
      frame.stamp = 0.2 * tick;
      frame.scan = LaserScan{};
      const Decision decision =
          explorer.decide({frame, estimate, map_.view(), tick == 0 ? cells_of(map_.view().geometry) : CellRect{}});
      if (decision.motion.angular != 0.0) return decision.motion.angular;
    }
    return 0.0;
  }

 private:
  GrowingMap map_{0.05};
};

// A lane between walls: on the left it ends after 1.8 m with 0.4 m of frontier, on the right after 2.4 m with 2 m of
// it.
TEST(FrontierExplorerTest, GoesALittleFartherForALongerFrontier) {
  PaintedFloor floor;
  floor.paint({-1.2, -2.4}, {1.2, 1.8}, 80);
  floor.paint({-0.2, -0.5}, {0.2, 1.8}, -80);
  floor.paint({-1.0, -2.4}, {1.0, -0.5}, -80);
  FrontierExplorerParams params;
  params.gain = 0.0;
  EXPECT_GT(floor.first_turn(params), 0.0);
  params.gain = 1.0;
  EXPECT_LT(floor.first_turn(params), 0.0);
}

// A lane between walls half seen; its end on the right is farther off, but beside a wall.
TEST(FrontierExplorerTest, GoesRatherWhereItCanTellItsPose) {
  PaintedFloor floor;
  floor.paint({-0.5, -3.0}, {0.5, 2.5}, 5);
  floor.paint({-0.3, -3.0}, {0.3, 2.5}, -80);
  floor.paint({0.3, -3.0}, {0.4, -2.0}, 80);
  FrontierExplorerParams params;
  params.lost = 1.0;
  EXPECT_GT(floor.first_turn(params), 0.0);
  params.lost = 10.0;
  EXPECT_LT(floor.first_turn(params), 0.0);
}

TEST(FrontierExplorerTest, NeedsALidar) {
  EXPECT_THROW(FrontierExplorer(RobotModel{}), Error);
}

}  // namespace
}  // namespace scrubjay
