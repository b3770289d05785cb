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

TEST(FrontierExplorerTest, NeedsALidar) {
  EXPECT_THROW(FrontierExplorer(RobotModel{}), Error);
}

}  // namespace
}  // namespace scrubjay
