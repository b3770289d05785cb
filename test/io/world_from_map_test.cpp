#include <gtest/gtest.h>

#include <scrubjay/geometry/random.hpp>
#include <scrubjay/io/world_reader.hpp>

namespace scrubjay {
namespace {

/// '.' is free, '#' occupied, '?' unknown; the first row is the top one. Cells of 1 m, the lowest left at the origin.
OccupancyGrid drawn_map(const std::vector<std::string>& rows) {
  OccupancyGrid map;
  map.geometry = {1.0, {0.0, 0.0}, static_cast<std::int32_t>(rows[0].size()), static_cast<std::int32_t>(rows.size())};
  for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
    for (const char c : *row) map.cells.push_back(c == '.' ? kFree : c == '#' ? kOccupied : kUnknown);
  }
  return map;
}

TEST(WorldFromMapTest, MergesStraightRunsOfTheBorder) {
  const World world = world_from_map(drawn_map({"#####",  //
                                                "#..##",  //
                                                "#...#",  //
                                                "#####"}));
  ASSERT_EQ(world.walls.size(), 1u);
  EXPECT_EQ(world.walls[0].points, (std::vector<Point2>{{1, 1}, {4, 1}, {4, 2}, {3, 2}, {3, 3}, {1, 3}, {1, 1}}));
}

TEST(WorldFromMapTest, UnknownCellsAndTheMapsEdgeAreSolid) {
  const World world = world_from_map(drawn_map({"?..",  //
                                                "..."}));
  ASSERT_EQ(world.walls.size(), 1u);
  EXPECT_EQ(world.walls[0].points, (std::vector<Point2>{{0, 0}, {3, 0}, {3, 2}, {1, 2}, {1, 1}, {0, 1}, {0, 0}}));
}

TEST(WorldFromMapTest, AnIslandIsAWallOfItsOwn) {
  const World world = world_from_map(drawn_map({".....",  //
                                                ".##..",  //
                                                "....."}));
  ASSERT_EQ(world.walls.size(), 2u);
  EXPECT_EQ(world.walls[0].points.size(), 5u);
  EXPECT_EQ(world.walls[1].points.size(), 5u);
}

TEST(WorldFromMapTest, FreeCellsThatMeetAtACornerStayApart) {
  const World world = world_from_map(drawn_map({"#.",  //
                                                ".#"}));
  ASSERT_EQ(world.walls.size(), 2u);
  EXPECT_EQ(world.walls[0].points, (std::vector<Point2>{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}));
}

TEST(WorldFromMapTest, AMapWithoutFreeCellsHasNoWalls) {
  EXPECT_TRUE(world_from_map(drawn_map({"##", "??"})).walls.empty());
  EXPECT_TRUE(world_from_map({}).walls.empty());
}

TEST(WorldFromMapTest, OnRandomMapsWallsAreExactlyTheBorder) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Random random(seed);
    OccupancyGrid map;
    map.geometry = {1.0, {0.0, 0.0}, 13, 9};
    for (std::size_t i = 0; i < map.geometry.size(); ++i) {
      map.cells.push_back(random.uniform() < 0.5 ? kFree : random.uniform() < 0.5 ? kOccupied : kUnknown);
    }
    const auto free = [&](int x, int y) {
      return map.geometry.contains({x, y}) && map.cells[map.geometry.index({x, y})] == kFree;
    };
    double expected = 0.0;
    for (int y = 0; y <= map.geometry.height; ++y) {
      for (int x = 0; x <= map.geometry.width; ++x) {
        expected += (free(x, y) != free(x - 1, y) ? 1 : 0) + (free(x, y) != free(x, y - 1) ? 1 : 0);
      }
    }
    const World world = world_from_map(map);
    double length = 0.0;
    for (const Wall& wall : world.walls) {
      EXPECT_EQ(wall.points.front(), wall.points.back());
      for (std::size_t i = 1; i < wall.points.size(); ++i) {
        const Point2 along = wall.points[i] - wall.points[i - 1];
        length += along.norm();
        // Free on the left, not free on the right, along all of the run.
        const Point2 step = along.normalized();
        for (double t = 0.5; t < along.norm(); t += 1.0) {
          const Point2 at = wall.points[i - 1] + t * step;
          const Point2 left = at + 0.5 * Point2(-step.y(), step.x());
          const Point2 right = at - 0.5 * Point2(-step.y(), step.x());
          EXPECT_TRUE(free(map.geometry.cell_at(left).x, map.geometry.cell_at(left).y));
          EXPECT_FALSE(free(map.geometry.cell_at(right).x, map.geometry.cell_at(right).y));
        }
      }
    }
    EXPECT_EQ(length, expected) << "seed " << seed;
  }
}

}  // namespace
}  // namespace scrubjay
