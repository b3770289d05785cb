#include <gtest/gtest.h>

#include <scrubjay/geometry/random.hpp>
#include <scrubjay/localization/surface_map.hpp>

namespace scrubjay {
namespace {

constexpr double kNoise = 0.01;  // of the beams [m]
const Point2 kBelow(0.0, -1.0);
const Point2 kAbove(0.0, 1.0);

/// A map that grows, and a field that follows it.
struct Grounds {
  explicit Grounds(const GridGeometry& grid) : geometry(grid), cells(grid.size()) {}
  void occupy(const Point2& p, LogOdds value = kMaxLogOdds) {
    cells[geometry.index(geometry.cell_at(p))] = value;
    field.follow({geometry, cells.data()}, cells_of(geometry));
  }

  GridGeometry geometry;
  std::vector<LogOdds> cells;
  LikelihoodField field;
};

GridGeometry grid() {
  return {0.05, {-2.0, -2.0}, 80, 80};
}

/// A wall along y = `height`, seen from `view`.
void add_wall(SurfaceMap& surfaces, Grounds& grounds, double height, const Point2& view, double noise = 0.0) {
  Random random(7);
  for (double x = -1.0; x < 1.0; x += 0.01) {
    const Point2 p(x, height + noise * random.normal());
    grounds.occupy(p);
    surfaces.add(p, view, kNoise, grounds.field);
  }
}

TEST(SurfaceMapTest, KnowsAWallFinerThanItsCells) {
  SurfaceMap surfaces;
  Grounds grounds(grid());
  add_wall(surfaces, grounds, 0.013, kBelow);
  const auto line = surfaces.line_at(grounds.geometry.cell_at({0.3, 0.02}), kBelow, grounds.field);
  ASSERT_TRUE(line);
  EXPECT_NEAR(line->distance({0.3, 0.013}), 0.0, 1e-6);
  EXPECT_NEAR(std::fabs(line->normal.y()), 1.0, 1e-6);
}

TEST(SurfaceMapTest, AveragesNoise) {
  SurfaceMap surfaces;
  Grounds grounds(grid());
  for (int i = 0; i < 20; ++i) add_wall(surfaces, grounds, 0.013, kBelow, 0.02);
  const auto line = surfaces.line_at(grounds.geometry.cell_at({0.3, 0.02}), kBelow, grounds.field);
  ASSERT_TRUE(line);
  EXPECT_NEAR(line->distance({0.3, 0.013}), 0.0, 0.006);
}

TEST(SurfaceMapTest, KeepsTheFacesOfAThinWallApart) {
  SurfaceMap surfaces;
  Grounds grounds(grid());
  add_wall(surfaces, grounds, 0.01, kBelow);
  add_wall(surfaces, grounds, 0.08, kAbove);
  const CellIndex between = grounds.geometry.cell_at({0.0, 0.04});
  EXPECT_NEAR(surfaces.line_at(between, kBelow, grounds.field)->distance({0.0, 0.01}), 0.0, 1e-6);
  EXPECT_NEAR(surfaces.line_at(between, kAbove, grounds.field)->distance({0.0, 0.08}), 0.0, 1e-6);
}

TEST(SurfaceMapTest, KeepsThemApartForWhoLooksAlongThem) {
  SurfaceMap surfaces;
  Grounds grounds(grid());
  const Point2 from_below(0.9, -0.44), from_above(0.9, 0.44);  // less than a right angle apart
  add_wall(surfaces, grounds, 0.01, from_below);
  add_wall(surfaces, grounds, 0.08, from_above);
  const CellIndex between = grounds.geometry.cell_at({0.0, 0.04});
  EXPECT_NEAR(surfaces.line_at(between, from_below, grounds.field)->distance({0.0, 0.01}), 0.0, 1e-6);
  EXPECT_NEAR(surfaces.line_at(between, from_above, grounds.field)->distance({0.0, 0.08}), 0.0, 1e-6);
}

TEST(SurfaceMapTest, HasALineForEndsInFrontOfItAsForThoseBehind) {
  SurfaceMap surfaces;
  Grounds grounds(grid());
  for (double x = -1.0; x < 1.0; x += 0.05) grounds.occupy({x + 0.01, 0.025});
  Random random(7);
  for (int i = 0; i < 20000; ++i) {
    const double x = random.uniform(-1.0, 1.0);
    const double y = 0.025 + 0.03 * random.normal();
    surfaces.add({x, y}, kBelow, 0.03, grounds.field);
  }
  for (const double away : {-0.15, -0.1, -0.05, 0.0, 0.05, 0.1, 0.15}) {
    const CellIndex c = grounds.geometry.cell_at({0.3, 0.025 + away});
    const auto line = surfaces.line_at(c, kBelow, grounds.field);
    ASSERT_TRUE(line) << away;
    EXPECT_NEAR(std::fabs(line->normal.y()), 1.0, 0.02) << away;
  }
}

TEST(SurfaceMapTest, SeesNoLineInAPoint) {
  SurfaceMap surfaces;
  Grounds grounds(grid());
  grounds.occupy({0.02, 0.02});
  surfaces.add({0.02, 0.02}, kBelow, kNoise, grounds.field);
  EXPECT_FALSE(surfaces.line_at(grounds.geometry.cell_at({0.02, 0.02}), kBelow, grounds.field));
}

TEST(SurfaceMapTest, TakesTheMapsWordForWhatItDidNotSee) {
  const SurfaceMap surfaces;
  Grounds grounds(grid());
  for (double x = -1.0; x < 1.0; x += 0.05) grounds.occupy({x + 0.01, 0.01});
  const auto line = surfaces.line_at(grounds.geometry.cell_at({0.0, 0.02}), kBelow, grounds.field);
  ASSERT_TRUE(line);
  EXPECT_NEAR(line->distance({0.0, 0.025}), 0.0, 1e-9);  // the cells' middle
}

TEST(SurfaceMapTest, ForgetsWhatTheMapForgot) {
  SurfaceMap surfaces;
  Grounds grounds(grid());
  add_wall(surfaces, grounds, 0.013, kBelow);
  for (LogOdds& cell : grounds.cells) cell = -kMaxLogOdds;
  grounds.occupy({1.9, 1.9});
  EXPECT_FALSE(surfaces.line_at(grounds.geometry.cell_at({0.0, 0.013}), kBelow, grounds.field));
  // A wall that is built there later owes nothing to the one before.
  for (double x = -1.0; x < 1.0; x += 0.01) surfaces.add({x, 0.04}, kBelow, kNoise, grounds.field);
  for (double x = -1.0; x < 1.0; x += 0.05) grounds.occupy({x + 0.01, 0.04});
  const auto line = surfaces.line_at(grounds.geometry.cell_at({0.0, 0.04}), kBelow, grounds.field);
  ASSERT_TRUE(line);
  EXPECT_NEAR(line->distance({0.0, 0.04}), 0.0, 0.002);
}

TEST(SurfaceMapTest, KeepsItsPlacesWhenTheMapGrows) {
  SurfaceMap surfaces;
  Grounds grounds(grid());
  add_wall(surfaces, grounds, 0.013, kBelow);
  Grounds grown({0.05, {-52.0, -7.0}, 1300, 400});
  for (double x = -1.0; x < 1.0; x += 0.05) grown.cells[grown.geometry.index(grown.geometry.cell_at({x, 0.013}))] = 50;
  grown.occupy({0.5, 0.013});
  const auto line = surfaces.line_at(grown.geometry.cell_at({0.3, 0.02}), kBelow, grown.field);
  ASSERT_TRUE(line);
  EXPECT_NEAR(line->distance({0.3, 0.013}), 0.0, 1e-6);
  // Far from where it began, it makes room.
  surfaces.add({-51.0, 12.0}, kBelow, kNoise, grown.field);
  EXPECT_TRUE(surfaces.line_at(grown.geometry.cell_at({0.3, 0.02}), kBelow, grown.field));
}

}  // namespace
}  // namespace scrubjay
