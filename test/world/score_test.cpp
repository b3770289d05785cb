#include <gtest/gtest.h>

#include <scrubjay/error.hpp>
#include <scrubjay/world/score.hpp>

#include "world/disc.hpp"

namespace scrubjay {
namespace {

/// 4 x 3 m with a box in the middle.
GroundTruth furnished_room() {
  World world;
  world.walls.push_back({{{0, 0}, {4, 0}, {4, 3}, {0, 3}, {0, 0}}});
  world.furniture.push_back({"box", {box({2, 1.5}, {0.6, 0.4}, 0.2)}});
  return ground_truth(world, {0.512, 0.513, 0.0}, kRadius, 0.05);
}

struct Map {
  GridGeometry geometry;
  std::vector<Occupancy> cells;

  GridView<const Occupancy> view() const { return {geometry, cells.data()}; }
};

Map perfect_map(const GroundTruth& truth) {
  Map map{truth.geometry, {}};
  for (const GroundTruth::Cell& cell : truth.cells) {
    map.cells.push_back(cell.wall ? kOccupied : cell.reachable ? kFree : kUnknown);
  }
  return map;
}

void expect_all(const MapScore& score, double value) {
  EXPECT_EQ(score.coverage, value);
  EXPECT_EQ(score.iou, value);
  EXPECT_EQ(score.wall_recall, value);
  EXPECT_EQ(score.wall_precision, value);
  EXPECT_EQ(score.followed_wall_recall, value);
  EXPECT_EQ(score.followed_wall_precision, value);
}

TEST(ScoreTest, APerfectMapScoresOne) {
  const GroundTruth truth = furnished_room();
  expect_all(score_map(perfect_map(truth).view(), truth), 1.0);
}

TEST(ScoreTest, AnEmptyMapKnowsNothingAndClaimsNothing) {
  const MapScore score = score_map({}, furnished_room());
  EXPECT_EQ(score.coverage, 0.0);
  EXPECT_EQ(score.iou, 0.0);
  EXPECT_EQ(score.wall_recall, 0.0);
  EXPECT_EQ(score.wall_precision, 1.0);
}

TEST(ScoreTest, AMapShiftedByACellLosesALittleAndByThreeALot) {
  const GroundTruth truth = furnished_room();
  Map map = perfect_map(truth);
  map.geometry.origin.x() += 0.05;
  const MapScore one = score_map(map.view(), truth);
  EXPECT_LT(one.coverage, 1.0);
  EXPECT_GT(one.coverage, 0.95);
  EXPECT_LT(one.iou, one.coverage);
  EXPECT_EQ(one.wall_recall, 1.0) << "within one cell";
  EXPECT_EQ(one.wall_precision, 1.0);
  map.geometry.origin.x() += 0.10;
  const MapScore three = score_map(map.view(), truth);
  EXPECT_LT(three.wall_recall, 0.7) << "walls across the shift are lost, those along it aren't";
  EXPECT_LT(three.wall_precision, 0.7);
  EXPECT_LT(three.iou, one.iou);
}

TEST(ScoreTest, ExtentsMayDiffer) {
  const GroundTruth truth = furnished_room();
  const Map map = perfect_map(truth);
  // The same cells with a border of unknown ones, 7 to the left and 4 below.
  Map larger{map.geometry, {}};
  larger.geometry.origin -= Point2(7 * 0.05, 4 * 0.05);
  larger.geometry.width += 12;
  larger.geometry.height += 9;
  larger.cells.assign(larger.geometry.size(), kUnknown);
  for (int y = 0; y < map.geometry.height; ++y) {
    for (int x = 0; x < map.geometry.width; ++x) {
      larger.cells[larger.geometry.index({x + 7, y + 4})] = map.cells[map.geometry.index({x, y})];
    }
  }
  expect_all(score_map(larger.view(), truth), 1.0);
  larger.cells[0] = kFree;
  EXPECT_LT(score_map(larger.view(), truth).iou, 1.0) << "free space that the truth doesn't know";
  larger.cells[0] = kOccupied;
  EXPECT_LT(score_map(larger.view(), truth).wall_precision, 1.0);
}

TEST(ScoreTest, CentresDecideWhereCellsDoNotLineUp) {
  const GroundTruth truth = furnished_room();
  Map map = perfect_map(truth);
  map.geometry.origin += Point2(0.011, -0.02);
  expect_all(score_map(map.view(), truth), 1.0);
}

TEST(ScoreTest, CoverageIsTheShareOfReachableCellsKnownAsFree) {
  const GroundTruth truth = furnished_room();
  Map map = perfect_map(truth);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    if (!truth.cells[i].reachable) continue;
    if (i % 4 == 0) {
      map.cells[i] = i % 8 == 0 ? kUnknown : 40;  // neither unknown nor "perhaps" is known as free
    } else {
      map.cells[i] = kFreeUpTo;
      ++kept;
    }
  }
  const double share = static_cast<double>(kept) / static_cast<double>(truth.reachable_count);
  EXPECT_EQ(score_map(map.view(), truth).coverage, share);
  EXPECT_EQ(score_map(map.view(), truth).iou, share);
}

TEST(ScoreTest, FollowedBoundariesAreScoredOnTheirOwn) {
  const GroundTruth truth = furnished_room();
  ASSERT_EQ(truth.boundary_count, 2);
  // The robot followed the box alone (boundary 2) and mapped nothing else.
  Map map = perfect_map(truth);
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    if (truth.cells[i].wall && truth.cells[i].boundary != 2) map.cells[i] = kUnknown;
  }
  const MapScore score = score_map(map.view(), truth, {2});
  EXPECT_LT(score.wall_recall, 0.2);
  EXPECT_EQ(score.followed_wall_recall, 1.0);
  EXPECT_EQ(score.followed_wall_precision, 1.0);
  EXPECT_EQ(score_map(map.view(), truth, {1}).followed_wall_recall, 0.0);
}

TEST(ScoreTest, OccupiedCellsNearOtherBoundariesDoNotCountForTheFollowed) {
  const GroundTruth truth = furnished_room();
  Map map = perfect_map(truth);
  EXPECT_EQ(score_map(map.view(), truth, {2}).followed_wall_precision, 1.0);
  // A phantom in the open counts against any choice.
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    const CellIndex cell{static_cast<int>(i) % truth.geometry.width, static_cast<int>(i) / truth.geometry.width};
    if ((truth.geometry.center(cell) - Point2(0.5, 0.0)).norm() < 0.1) map.cells[i] = kOccupied;
  }
  const MapScore score = score_map(map.view(), truth, {2});
  EXPECT_LT(score.followed_wall_precision, score.wall_precision);
  EXPECT_LT(score.wall_precision, 1.0);
}

TEST(ScoreTest, WhoFollowedEveryBoundaryIsScoredOnAll) {
  const GroundTruth truth = furnished_room();
  Map map = perfect_map(truth);
  // Phantoms beside the true walls, so that precision isn't 1; corners that can't be touched count as walls.
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    if (truth.cells[i].reachable && i % 9 == 0) map.cells[i] = kOccupied;
  }
  for (const std::vector<std::uint16_t>& all : {std::vector<std::uint16_t>{}, {1, 2}}) {
    const MapScore score = score_map(map.view(), truth, all);
    EXPECT_LT(score.wall_precision, 1.0);
    EXPECT_EQ(score.followed_wall_precision, score.wall_precision);
    EXPECT_EQ(score.followed_wall_recall, score.wall_recall);
  }
}

TEST(ScoreTest, RefusesAnotherResolution) {
  const GroundTruth truth = furnished_room();
  Map map = perfect_map(truth);
  map.geometry.resolution = 0.1;
  EXPECT_THROW(score_map(map.view(), truth), Error);
}

}  // namespace
}  // namespace scrubjay
