#include <gtest/gtest.h>

#include <cmath>
#include <scrubjay/exploration/lanes.hpp>

#include "planning/map_drawing.hpp"

namespace scrubjay::test {
namespace {

/// Each character is 4 x 4 cells of 5 cm; 'r' is where the robot stands.
class LaneTest : public testing::Test {
 protected:
  void draw(const std::vector<std::string>& rows) {
    map.emplace(rows, 0.05, 4);
    gain.emplace(SweepGainParams{});
    gain->update(map->view(), map->all());
    CostMapParams params;
    params.radius = 0.1735;
    params.margin = 0.0;
    params.comfort = 0.1;
    params.through_unknown = true;
    costs.emplace(params);
    costs->update(map->view(), map->all());
    const Point2 at = map->point('r');
    robot = {at.x(), at.y(), 0.0};
    // Nothing is known outside of the drawing, and nobody may go there.
    const GridGeometry& grid = map->view().geometry;
    within = Bounds2{{0.0, 0.0}, {grid.width * grid.resolution, grid.height * grid.resolution}};
  }
  std::optional<Lane> lane(double reach = PathSearch::kNever, const LaneParams& params = {}) {
    search.spread(costs->view(), map->cell('r'), reach);
    return best_lane({*gain, costs->view(), search, within}, robot, 0.0, reach, params);
  }
  std::optional<Lane> spot(const LaneParams& params = {}) {
    search.spread(costs->view(), map->cell('r'));
    return best_spot({*gain, costs->view(), search, within}, robot, PathSearch::kNever, params);
  }
  Occupancy at(const Point2& p) const { return trinary(map->view()[map->view().geometry.cell_at(p)]); }

  std::optional<MapDrawing> map;
  std::optional<SweepGain> gain;
  std::optional<CostMap> costs;
  std::optional<Bounds2> within;
  PathSearch search;
  Pose2 robot;
};

TEST_F(LaneTest, RunsFromKnownFloorOverUnknownFloorUpToWhatIsKnownAgain) {
  draw({"############",  //
        "#..........#",  //
        "#r.?????...#",  //
        "#..........#",  //
        "############"});
  const auto found = lane();
  ASSERT_TRUE(found);
  EXPECT_EQ(at(found->from), kFree);
  EXPECT_NEAR(std::fabs(direction(found->heading).x()), 1.0, 1e-9) << "along it";
  EXPECT_NEAR(found->length, 1.0, 0.3);
  EXPECT_NEAR(found->from.y(), 0.5, 0.05) << "through its middle";
}

TEST_F(LaneTest, EndsBeforeWhatTheDiscWouldTouch) {
  draw({"##############",  //
        "#...??????#..#",  //
        "#r..??????#..#",  //
        "#...??????#..#",  //
        "##############"});
  const auto found = lane();
  ASSERT_TRUE(found);
  EXPECT_LT(std::max(found->from.x(), found->to().x()), 2.0 - 0.1735);
}

TEST_F(LaneTest, LiesBesideWhatIsKnownAndLeavesNoStripBehind) {
  draw({"####################",  //
        "#..................#",  //
        "#..................#",  //
        "#..???????????????.#",  //
        "#..???????????????.#",  //
        "#..???????????????.#",  //
        "#..???????????????.#",  //
        "#..???????????????.#",  //
        "#..???????????????.#",  //
        "#r.................#",  //
        "#..................#",  //
        "####################"});
  const auto found = lane();
  ASSERT_TRUE(found);
  // The unknown floor lies between y = 0.6 and 1.8 and x = 0.6 and 3.6: the lane is a disc's radius within its border.
  const bool level = std::fabs(direction(found->heading).x()) > 0.9;
  const double inside = level ? std::min(found->from.y() - 0.6, 1.8 - found->from.y())
                              : std::min(found->from.x() - 0.6, 3.6 - found->from.x());
  EXPECT_NEAR(inside, 0.161, 0.03);
}

TEST_F(LaneTest, TheNearerOfTwoIsDrivenFirst) {
  draw({"##############################",  //
        "#.............r..............#",  //
        "#???......................???#",  //
        "#???.....???..............???#",  //
        "#???......................???#",  //
        "##############################"});
  const auto found = lane();
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->from.x(), 2.0, 0.6);
}

TEST_F(LaneTest, ThereIsNoneWhereNothingIsUnknownOrItIsOutOfReach) {
  draw({"##########",  //
        "#r.....#??",  //
        "#......#??",  //
        "##########"});
  EXPECT_FALSE(lane());
  EXPECT_FALSE(spot());
}

TEST_F(LaneTest, KeepsWithinReach) {
  draw({"##############################",  //
        "#r........................???#",  //
        "#.........................???#",  //
        "#.........................???#",  //
        "##############################"});
  EXPECT_FALSE(lane(2.0));
  EXPECT_TRUE(lane());
}

TEST_F(LaneTest, ASpeckIsWorthADriveOnlyIfItIsLargeEnough) {
  draw({"########",  //
        "#r.....#",  //
        "#......#",  //
        "#......#",  //
        "#......#",  //
        "########"});
  MapDrawing specked = *map;
  specked.set({{17, 10}, {19, 12}}, '?');
  gain->update(specked.view(), specked.all());
  const auto found = spot();
  ASSERT_TRUE(found);
  EXPECT_EQ(found->length, 0.0);
  EXPECT_LT((found->from - Point2(0.9, 0.55)).norm(), 0.161);
  LaneParams params;
  params.least_area = 0.0125;
  EXPECT_FALSE(spot(params)) << "4 cells are 0.01 m^2";
}

}  // namespace
}  // namespace scrubjay::test
