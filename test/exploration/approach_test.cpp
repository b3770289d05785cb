#include <gtest/gtest.h>

#include <scrubjay/exploration/approach.hpp>
#include <string>

namespace scrubjay {
namespace {

// '.' free, '#' occupied, ' ' unknown; 'o': free, and the robot can be there. The highest row first; cells of 5 cm.
class ApproachTest : public testing::Test {
 protected:
  void draw(const std::vector<std::string>& rows, CellIndex robot) {
    geometry.width = static_cast<std::int32_t>(rows.front().size());
    geometry.height = static_cast<std::int32_t>(rows.size());
    for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
      for (const char c : *row) {
        cells.push_back(c == '.' || c == 'o' ? -50 : c == '#' ? 50 : 0);
        costs.push_back(c == 'o' ? 0 : kNoWay);
      }
    }
    ways.spread({geometry, costs.data()}, robot);
  }
  std::optional<CellIndex> nearest(CellIndex target, double disc = 0.0) {
    return approach.nearest_reached({geometry, cells.data()}, ways, target, disc);
  }

  GridGeometry geometry;
  std::vector<LogOdds> cells;
  std::vector<TravelCost> costs;
  PathSearch ways;
  Approach approach;
};

TEST_F(ApproachTest, FollowsTheFloorAroundWalls) {
  draw(
      {
          "#############",  //
          "#oooo#......#",  //
          "#oooo#......#",  //
          "#oooo#..    #",  //
          "#oooo...    #",  //
          "#############",  //
      },
      {1, 1});
  EXPECT_EQ(nearest({6, 4}), (CellIndex{4, 1}));  // though (4, 4) is next to it, behind the wall
  EXPECT_EQ(nearest({2, 2}), (CellIndex{2, 2}));
}

TEST_F(ApproachTest, FindsNoneWhereNoFloorConnects) {
  draw(
      {
          "##########",  //
          "#ooo#....#",  //
          "#ooo ....#",  //
          "##########",  //
      },
      {1, 1});
  EXPECT_EQ(nearest({6, 1}), std::nullopt);
  EXPECT_EQ(nearest({4, 1}), std::nullopt);  // unknown
}

TEST_F(ApproachTest, ADiscGoesThroughNoGapThatIsTooNarrow) {
  draw(
      {
          "##############",  //
          "#......#.....#",  //
          "#.ooo..#.....#",  //
          "#.ooo........#",  //
          "#.ooo..#.....#",  //
          "#......#.....#",  //
          "##############",  //
      },
      {3, 3});
  EXPECT_EQ(nearest({11, 3}), (CellIndex{4, 3}));
  EXPECT_EQ(nearest({11, 3}, 0.07), std::nullopt);
  EXPECT_EQ(nearest({5, 3}, 0.07), (CellIndex{4, 3}));
}

TEST_F(ApproachTest, FollowsMapsThatGrow) {
  draw({"###", "#o#", "###"}, {1, 1});
  EXPECT_EQ(nearest({1, 1}), (CellIndex{1, 1}));
  cells.clear();
  costs.clear();
  draw({"#####", "#oo.#", "#####"}, {1, 1});
  EXPECT_EQ(nearest({3, 1}), (CellIndex{2, 1}));
}

}  // namespace
}  // namespace scrubjay
