#include <gmock/gmock.h>

#include <cmath>
#include <scrubjay/exploration/tile_goals.hpp>
#include <string_view>

#include "behavior/situations.hpp"

namespace scrubjay::test {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

/// Tiles of one cell, drawn; `at` counts from the lowest left one that is drawn.
struct Drawing {
  explicit Drawing(std::initializer_list<std::string_view> rows, double resolution = 0.25) : map({.side = 1}) {
    const DrawnMap drawn(rows, resolution);
    map.update(drawn.view(), cells_of(drawn.view().geometry));
    low = map.geometry().cell_at(drawn.view().geometry.center({0, 0}));
  }
  CellIndex at(int x, int y) const { return {low.x + x, low.y + y}; }
  Point2 center(int x, int y) const { return map.geometry().center(at(x, y)); }
  /// A goal whose priority is known already.
  TileGoal goal(int x, int y, double priority) const { return {at(x, y), 0.0, priority}; }

  TileMap map;
  CellIndex low;
};

TEST(TilePriorityTest, IsAGaussOfTheDistanceTimesTheShare) {
  EXPECT_DOUBLE_EQ(tile_priority(1.5, 0.6, 1.5), 0.6);
  EXPECT_NEAR(tile_priority(2.5, 1.0, 1.5), 0.36787944117144233, 1e-15);
  EXPECT_NEAR(tile_priority(0.5, 0.5, 1.5), 0.5 * 0.36787944117144233, 1e-15);
  EXPECT_NEAR(tile_priority(3.5, 0.8, 1.5), 0.8 * 0.018315638888734179, 1e-15);
}

TEST(RankedGoalsTest, TheBestComesFirst) {
  const Drawing tiles({"...................."}, 0.5);
  // From the middle of tile 0, the others are 0.5 m apart; all have the same share. 2 is 1.0 m away, 3 is 1.5 m.
  const std::vector<CellIndex> some{tiles.at(1, 0), tiles.at(2, 0), tiles.at(3, 0), tiles.at(5, 0), tiles.at(0, 1)};
  const std::vector<TileGoal> goals = ranked_goals(tiles.map, some, tiles.center(0, 0), 1.5);
  ASSERT_THAT(goals, SizeIs(5));
  // (0, 1) is unknown: F = 1. The others are free: F = 0, so that the nearer comes first.
  EXPECT_EQ(goals[0].tile, tiles.at(0, 1));
  EXPECT_NEAR(goals[0].priority, 0.36787944117144233, 1e-15);
  EXPECT_NEAR(goals[0].distance, 0.5, 1e-12);
  EXPECT_EQ(goals[1].tile, tiles.at(1, 0));
  EXPECT_EQ(goals[4].tile, tiles.at(5, 0));
}

TEST(RankedGoalsTest, TheIdealDistanceDecidesAmongEqualShares) {
  const Drawing tiles({"."}, 0.5);
  const std::vector<CellIndex> unknown{tiles.at(1, 0), tiles.at(0, 1)};
  const Point2 robot = tiles.center(0, 0) + Point2(-1.0, 0.0);  // 1.5 m and 1.118 m away
  EXPECT_EQ(ranked_goals(tiles.map, unknown, robot, 1.5)[0].tile, tiles.at(1, 0));
  EXPECT_EQ(ranked_goals(tiles.map, unknown, robot, 1.0)[0].tile, tiles.at(0, 1));
}

TEST(RankedGoalsTest, TiesAreBrokenByPlace) {
  const Drawing tiles({".", "."}, 0.5);
  const std::vector<CellIndex> same{tiles.at(1, 0), tiles.at(-1, 0)};
  const std::vector<TileGoal> goals = ranked_goals(tiles.map, same, tiles.center(0, 0), 1.5);
  EXPECT_EQ(goals[0].priority, goals[1].priority);
  EXPECT_EQ(goals[0].tile, tiles.at(-1, 0));
}

TEST(ChooseGoalTest, AGoalBehindAWallIsPutOff) {
  const Drawing tiles({"...#...",  //
                       "...#...",  //
                       "......."});
  const std::vector<TileGoal> ranked{tiles.goal(6, 2, 0.9), tiles.goal(0, 0, 0.1)};
  const auto way = choose_goal(tiles.map, tiles.at(0, 2), ranked, kAnyNumber);
  ASSERT_TRUE(way);
  EXPECT_EQ(way->goal.tile, tiles.at(0, 0)) << "in sight, though it promises less";
  EXPECT_THAT(way->way_points, IsEmpty());
}

TEST(ChooseGoalTest, OfGoalsInSightTheBestIsTaken) {
  const Drawing tiles({"......."});
  const std::vector<TileGoal> ranked{tiles.goal(6, 0, 0.9), tiles.goal(2, 0, 0.1)};
  EXPECT_EQ(choose_goal(tiles.map, tiles.at(0, 0), ranked, 0)->goal.tile, tiles.at(6, 0));
}

TEST(ChooseGoalTest, TheWayPointIsTheTileNearestToTheGoalThatSeesBoth) {
  const Drawing tiles({"...#...",  //
                       "...#...",  //
                       "......."});
  const std::vector<TileGoal> ranked{tiles.goal(6, 2, 0.9)};
  const CellIndex robot = tiles.at(0, 1);
  EXPECT_FALSE(choose_goal(tiles.map, robot, ranked, 0)) << "without way points";
  const auto way = choose_goal(tiles.map, robot, ranked, 1);
  ASSERT_TRUE(way);
  ASSERT_THAT(way->way_points, SizeIs(1));
  // By hand: of the lower row, the robot sees all up to column 6 past the wall's lower end; (6, 0) is straight below.
  const CellIndex chosen = way->way_points[0];
  EXPECT_TRUE(tiles.map.sees(robot, chosen));
  EXPECT_TRUE(tiles.map.sees(chosen, tiles.at(6, 2)));
  const auto distance = [&](CellIndex tile) {
    return std::hypot(tile.x - tiles.at(6, 2).x, tile.y - tiles.at(6, 2).y);
  };
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 7; ++x) {
      const CellIndex tile = tiles.at(x, y);
      if (!tiles.map.open(tile) || !tiles.map.sees(robot, tile) || !tiles.map.sees(tile, tiles.at(6, 2))) continue;
      EXPECT_LE(distance(chosen), distance(tile));
    }
  }
}

/// Three walls from alternating sides: a goal at the far end is round three corners.
Drawing slalom() {
  return Drawing({"....#.........#....",  //
                  "....#....#....#....",  //
                  "....#....#....#....",  //
                  "....#....#....#....",  //
                  "....#....#....#....",  //
                  "....#....#....#....",  //
                  ".........#........."});
}

TEST(ChooseGoalTest, ExtendedVisibilityFindsAnyNumberOfWayPoints) {
  const Drawing tiles = slalom();
  const std::vector<TileGoal> ranked{tiles.goal(18, 6, 0.5)};
  const CellIndex robot = tiles.at(0, 6);
  EXPECT_FALSE(choose_goal(tiles.map, robot, ranked, 1)) << "no tile sees both: the original gives up";
  EXPECT_FALSE(choose_goal(tiles.map, robot, ranked, 2));
  const auto way = choose_goal(tiles.map, robot, ranked, kAnyNumber);
  ASSERT_TRUE(way);
  EXPECT_THAT(way->way_points, SizeIs(3)) << "one below each wall that hangs, one above the one that stands";
  CellIndex before = robot;
  for (const CellIndex tile : way->way_points) {
    EXPECT_TRUE(tiles.map.open(tile));
    EXPECT_TRUE(tiles.map.sees(before, tile));
    before = tile;
  }
  EXPECT_TRUE(tiles.map.sees(before, way->goal.tile));
}

TEST(ChooseGoalTest, FewerWayPointsGoFirstThenPriority) {
  const Drawing tiles = slalom();
  const std::vector<TileGoal> ranked{tiles.goal(18, 6, 0.9), tiles.goal(7, 6, 0.2), tiles.goal(6, 6, 0.1)};
  const auto way = choose_goal(tiles.map, tiles.at(0, 6), ranked, kAnyNumber);
  ASSERT_TRUE(way);
  EXPECT_EQ(way->goal.tile, tiles.at(7, 6));
  EXPECT_THAT(way->way_points, SizeIs(1));
}

TEST(ChooseGoalTest, OfChainsOfEqualNumberTheShortestIsTaken) {
  // The goal is round two corners on either side; the lower way is the shorter one by far.
  const Drawing tiles({".........",  //
                       ".#######.",  //
                       ".#.....#.",  //
                       ".#.....#.",  //
                       ".#.....#.",  //
                       ".#.....#.",  //
                       ".#.....#.",  //
                       ".#######.",  //
                       "........."});
  const auto way = choose_goal(tiles.map, tiles.at(0, 2), std::vector{tiles.goal(8, 2, 0.5)}, kAnyNumber);
  ASSERT_TRUE(way);
  ASSERT_THAT(way->way_points, SizeIs(2));
  EXPECT_EQ(way->way_points[0].y, tiles.at(0, 0).y) << "the lower way";
  EXPECT_EQ(way->way_points[1].y, tiles.at(0, 0).y);
  EXPECT_LE(way->way_points[0].x, tiles.at(1, 0).x) << "close to the corners";
  EXPECT_GE(way->way_points[1].x, tiles.at(7, 0).x);
}

TEST(ChooseGoalTest, WayPointsAreOpenTiles) {
  // What lies between is unknown: it hides nothing, but nobody can be sent there.
  const Drawing tiles({"...   ...",  //
                       "..#   #..",  //
                       "..#   #..",  //
                       "..#####.."});
  const auto way = choose_goal(tiles.map, tiles.at(0, 1), std::vector{tiles.goal(4, 1, 0.5)}, kAnyNumber);
  ASSERT_TRUE(way);
  ASSERT_THAT(way->way_points, SizeIs(1));
  EXPECT_TRUE(tiles.map.open(way->way_points[0]));
}

TEST(ChooseGoalTest, ASealedGoalIsNone) {
  const Drawing tiles({"...#####",  //
                       "...#...#",  //
                       "...#...#",  //
                       "...#####"});
  EXPECT_FALSE(choose_goal(tiles.map, tiles.at(0, 0), std::vector{tiles.goal(5, 1, 0.5)}, kAnyNumber));
  EXPECT_FALSE(choose_goal(tiles.map, tiles.at(0, 0), {}, kAnyNumber));
}

TEST(ConnectedTilesTest, HangTogetherOverOpenTiles) {
  const Drawing tiles({"...#..",  //
                       "...#..",  //
                       "..#...",  //
                       ".. ..."});
  const std::vector<bool> connected = connected_tiles(tiles.map, tiles.at(0, 0));
  const auto is = [&](int x, int y) { return connected[tiles.map.geometry().index(tiles.at(x, y))]; };
  EXPECT_TRUE(is(0, 0));
  EXPECT_TRUE(is(2, 3));
  EXPECT_FALSE(is(2, 0)) << "unknown";
  EXPECT_FALSE(is(3, 0)) << "beyond the unknown";
  EXPECT_FALSE(is(4, 3)) << "behind walls that touch at a corner";
  const std::vector<bool> from_wall = connected_tiles(tiles.map, tiles.at(3, 2));
  EXPECT_TRUE(from_wall[tiles.map.geometry().index(tiles.at(3, 2))]) << "the tile itself, whatever it is";
  EXPECT_TRUE(from_wall[tiles.map.geometry().index(tiles.at(5, 0))]);
}

TEST(GoalHistoryTest, GoesToTheNearestAndThenBackThroughTime) {
  GoalHistory history;
  for (const double x : {0.0, 1.0, 2.0, 3.0, 4.0}) history.remember({x, 0.0});
  // The nearest is that of x = 2: those after it are dropped.
  EXPECT_EQ(history.step_back({2.2, 1.0}), Point2(2.0, 0.0));
  EXPECT_EQ(history.step_back({2.0, 0.0}), Point2(1.0, 0.0));
  EXPECT_EQ(history.step_back({1.0, 0.0}), Point2(0.0, 0.0));
  EXPECT_EQ(history.step_back({0.0, 0.0}), std::nullopt);
}

TEST(GoalHistoryTest, WalkingBackIsInOrderWhateverIsNearer) {
  GoalHistory history;
  for (const double x : {5.0, 0.1, 9.0, 0.0}) history.remember({x, 0.0});
  EXPECT_EQ(history.step_back({0.0, 0.0}), Point2(0.0, 0.0));
  EXPECT_EQ(history.step_back({0.0, 0.0}), Point2(9.0, 0.0)) << "the one before, not the nearest";
}

TEST(GoalHistoryTest, ANewGoalEndsTheWayBack) {
  GoalHistory history;
  for (const double x : {0.0, 1.0, 2.0, 3.0}) history.remember({x, 0.0});
  history.step_back({3.0, 0.0});
  history.step_back({3.0, 0.0});
  history.remember({8.0, 0.0});
  EXPECT_EQ(history.step_back({1.2, 0.0}), Point2(1.0, 0.0)) << "0, 1 and 8 are left, and 8 came last";
  EXPECT_EQ(history.step_back({1.2, 0.0}), Point2(0.0, 0.0));
}

TEST(GoalHistoryTest, AnEmptyHistoryIsExhausted) {
  GoalHistory history;
  EXPECT_EQ(history.step_back({0.0, 0.0}), std::nullopt);
}

}  // namespace
}  // namespace scrubjay::test
