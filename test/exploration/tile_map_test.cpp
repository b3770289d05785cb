#include <gmock/gmock.h>

#include <scrubjay/exploration/tile_map.hpp>
#include <scrubjay/geometry/random.hpp>
#include <scrubjay/mapping/growing_map.hpp>
#include <string_view>

#include "behavior/situations.hpp"

namespace scrubjay::test {
namespace {

using ::testing::Contains;
using ::testing::IsEmpty;

TileMap tiles_of(const DrawnMap& map, const TileParams& params = {}) {
  TileMap tiles(params);
  tiles.update(map.view(), cells_of(map.view().geometry));
  return tiles;
}

/// A map with one sign a tile: tiles of one cell.
TileMap drawn_tiles(std::initializer_list<std::string_view> rows) {
  return tiles_of(DrawnMap(rows), {.side = 1});
}

/// The tile that holds a point [m].
CellIndex tile_at(const TileMap& tiles, double x, double y) {
  return tiles.geometry().cell_at({x, y});
}

TEST(TileMapTest, CountsTheCellsOfATile) {
  const DrawnMap map({"     .....", "    .....#", "   .......", "  ........", " ........."});
  const TileMap tiles = tiles_of(map);
  EXPECT_DOUBLE_EQ(tiles.geometry().resolution, 0.25);
  const CellIndex left = tile_at(tiles, 0.1, 0.1);
  const CellIndex right = tile_at(tiles, 0.3, 0.1);
  EXPECT_DOUBLE_EQ(tiles.undecided_share(left), 15.0 / 25.0);
  EXPECT_DOUBLE_EQ(tiles.undecided_share(right), 0.0);
  EXPECT_FALSE(tiles.open(left)) << "10 of 25 free";
  EXPECT_FALSE(tiles.wall(left));
  EXPECT_TRUE(tiles.wall(right));
  EXPECT_FALSE(tiles.open(right)) << "a wall, for all its free cells";
  EXPECT_EQ(tiles.undecided_around(left), 15 + 7 * 25);
}

TEST(TileMapTest, AnyCellOverTheThresholdMakesAWall) {
  GrowingMap map(0.05);
  map.cover({0.5, 0.5}, 0.5);
  GridView<LogOdds> cells = map.view();
  const auto is_wall = [&](LogOdds cell, double threshold) {
    cells[cells.geometry.cell_at({0.52, 0.52})] = cell;
    TileMap tiles({.wall = threshold});
    tiles.update(cells, cells_of(cells.geometry));
    return tiles.wall(tile_at(tiles, 0.52, 0.52));
  };
  EXPECT_FALSE(is_wall(log_odds(0.68), 0.70));
  EXPECT_TRUE(is_wall(log_odds(0.72), 0.70));
  EXPECT_FALSE(is_wall(log_odds(0.72), 0.80));
}

TEST(TileMapTest, AFrontierBordersOnKnownFloor) {
  // Two tiles of known floor, two of which nothing is known, and two behind a wall.
  const DrawnMap map({"#####.....          ",  //
                      "     .....          ",  //
                      "     .....          ",  //
                      "     .....          ",  //
                      "     .....          "});
  const TileMap tiles = tiles_of(map);
  const CellIndex floor = tile_at(tiles, 0.3, 0.1);
  EXPECT_TRUE(tiles.open(floor));
  EXPECT_FALSE(tiles.frontier(floor)) << "all of it is known";
  EXPECT_TRUE(tiles.frontier({floor.x + 1, floor.y})) << "unknown beside open";
  EXPECT_FALSE(tiles.frontier({floor.x + 2, floor.y})) << "unknown beside unknown";
  EXPECT_FALSE(tiles.frontier({floor.x - 1, floor.y})) << "a wall, though most of it is unknown";
  EXPECT_FALSE(tiles.frontier({floor.x - 2, floor.y})) << "behind a wall";
  // Beyond the map's border all is unknown, on every side.
  EXPECT_THAT(tiles.frontiers(), Contains(CellIndex{floor.x, floor.y + 1}));
  EXPECT_THAT(tiles.frontiers(), Contains(CellIndex{floor.x, floor.y - 1}));
}

TEST(TileMapTest, AFrontierNeedsItsShareOfUndecidedCells) {
  // 11 of 25 are 44 %, 12 are 48 %.
  const DrawnMap few({"     ", "     ", ".... ", ".....", "....."});
  const DrawnMap many({"     ", "     ", "...  ", ".....", "....."});
  EXPECT_FALSE(tiles_of(few).frontier(tile_at(tiles_of(few), 0.1, 0.1)));
  EXPECT_TRUE(tiles_of(many).frontier(tile_at(tiles_of(many), 0.1, 0.1)));
  const TileMap strict = tiles_of(many, {.frontier_share = 0.5});
  EXPECT_FALSE(strict.frontier(tile_at(strict, 0.1, 0.1)));
}

TEST(TileMapTest, CellsThatAreHardlyKnownAreUndecided) {
  GrowingMap map(0.05);
  map.cover({0.0, 0.0}, 0.5);
  GridView<LogOdds> cells = map.view();
  for (std::size_t i = 0; i < cells.geometry.size(); ++i) cells.cells[i] = log_odds(0.3);
  TileMap tiles;
  tiles.update(cells, cells_of(cells.geometry));
  EXPECT_DOUBLE_EQ(tiles.undecided_share(tile_at(tiles, 0.1, 0.1)), 1.0);
}

TEST(TileMapTest, WallsBlockTheStraightLine) {
  const TileMap tiles = drawn_tiles({".......",  //
                                     "...#...",  //
                                     "...#...",  //
                                     "......."});
  const CellIndex low = tile_at(tiles, 0.01, 0.01);
  const auto at = [&](int x, int y) { return CellIndex{low.x + x, low.y + y}; };
  EXPECT_TRUE(tiles.sees(at(0, 0), at(6, 0)));
  EXPECT_FALSE(tiles.sees(at(0, 1), at(6, 1)));
  EXPECT_FALSE(tiles.sees(at(0, 0), at(6, 3))) << "the diagonal meets it";
  EXPECT_TRUE(tiles.sees(at(0, 1), at(3, 1))) << "a wall itself is seen";
  EXPECT_TRUE(tiles.sees(at(3, 1), at(6, 1))) << "and doesn't blind who stands in its tile";
  EXPECT_TRUE(tiles.sees(at(2, 1), at(2, 1)));
}

TEST(TileMapTest, NoLineSlipsBetweenWallsThatTouchAtACorner) {
  const TileMap tiles = drawn_tiles({".#.",  //
                                     "#..",  //
                                     "..."});
  const CellIndex low = tile_at(tiles, 0.01, 0.01);
  EXPECT_FALSE(tiles.sees({low.x, low.y + 2}, {low.x + 1, low.y + 1}));
}

/// A random map as it grows: pieces of floor, walls and the unknown.
class GrowingScenery {
 public:
  explicit GrowingScenery(std::uint64_t seed) : random_(seed), map_(0.05) {}

  /// Changes a patch somewhere, and says which cells that are.
  CellRect change() {
    const Point2 center{random_.uniform(-3.0, 3.0), random_.uniform(-3.0, 3.0)};
    map_.cover(center, 0.3);
    const CellRect patch = cells_around(map_.view().geometry, center, random_.uniform(0.05, 0.3));
    for (std::int32_t y = patch.low.y; y < patch.high.y; ++y) {
      for (std::int32_t x = patch.low.x; x < patch.high.x; ++x) {
        map_.view()[{x, y}] = static_cast<LogOdds>(static_cast<int>(random_.below(60)) - 42);
      }
    }
    return patch;
  }
  GridView<const LogOdds> view() const { return map_.view(); }

 private:
  Random random_;
  GrowingMap map_;
};

TEST(TileMapTest, FollowsAMapThatGrowsAsIfItHadSeenAllOfIt) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    GrowingScenery scenery(seed);
    TileMap followed;
    for (int i = 0; i < 60; ++i) {
      const CellRect patch = scenery.change();
      followed.update(scenery.view(), patch);
      TileMap fresh;
      fresh.update(scenery.view(), cells_of(scenery.view().geometry));
      ASSERT_EQ(followed.geometry(), fresh.geometry());
      ASSERT_EQ(followed.frontiers(), fresh.frontiers()) << "seed " << seed << ", change " << i;
      for (std::int32_t y = 0; y < fresh.geometry().height; ++y) {
        for (std::int32_t x = 0; x < fresh.geometry().width; ++x) {
          const CellIndex tile{x, y};
          ASSERT_EQ(followed.undecided_share(tile), fresh.undecided_share(tile));
          ASSERT_EQ(followed.wall(tile), fresh.wall(tile));
          ASSERT_EQ(followed.open(tile), fresh.open(tile));
        }
      }
    }
  }
}

TEST(TileMapTest, TilesStayWhereTheyAreWhenTheMapGrows) {
  GrowingMap map(0.05);
  map.cover({0.1, 0.1}, 0.2);
  TileMap tiles;
  tiles.update(map.view(), cells_of(map.view().geometry));
  const Point2 before = tiles.geometry().center(tile_at(tiles, 0.1, 0.1));
  map.cover({-2.33, 1.71}, 0.4);
  tiles.update(map.view(), {});
  const Point2 after = tiles.geometry().center(tile_at(tiles, 0.1, 0.1));
  EXPECT_NEAR((after - before).norm(), 0.0, 1e-12);
}

TEST(TileMapTest, SightIsMutual) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    GrowingScenery scenery(seed);
    TileMap tiles({.side = 2});
    for (int i = 0; i < 100; ++i) {
      const CellRect changed = scenery.change();  // may move the map, so before its view is taken
      tiles.update(scenery.view(), changed);
    }
    Random random(seed);
    const auto some = [&] {
      return CellIndex{static_cast<std::int32_t>(random.below(static_cast<std::uint32_t>(tiles.geometry().width))),
                       static_cast<std::int32_t>(random.below(static_cast<std::uint32_t>(tiles.geometry().height)))};
    };
    int seen = 0;
    for (int i = 0; i < 1000; ++i) {
      const CellIndex a = some();
      const CellIndex b = some();
      EXPECT_EQ(tiles.sees(a, b), tiles.sees(b, a));
      seen += tiles.sees(a, b);
    }
    EXPECT_GT(seen, 20);
    EXPECT_LT(seen, 980);
  }
}

TEST(TileMapTest, AnEmptyMapHasNoTilesOfInterest) {
  TileMap tiles;
  tiles.update(GrowingMap(0.05).view(), {});
  EXPECT_THAT(tiles.frontiers(), IsEmpty());
}

}  // namespace
}  // namespace scrubjay::test
