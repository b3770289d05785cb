#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <scrubjay/error.hpp>
#include <scrubjay/geometry/random.hpp>
#include <scrubjay/mapping/growing_map.hpp>
#include <string>

namespace scrubjay {
namespace {

/// Cells by their column and row from the map frame's origin.
using Truth = std::map<std::pair<std::int32_t, std::int32_t>, LogOdds>;

std::pair<std::int32_t, std::int32_t> place(const Point2& center, double resolution) {
  return {static_cast<std::int32_t>(std::lround(center.x() / resolution - 0.5)),
          static_cast<std::int32_t>(std::lround(center.y() / resolution - 0.5))};
}

void expect_holds(const GrowingMap& map, const Truth& truth) {
  const auto view = map.view();
  std::size_t held = 0;
  for (std::int32_t y = 0; y < view.geometry.height; ++y) {
    for (std::int32_t x = 0; x < view.geometry.width; ++x) {
      const LogOdds cell = view[{x, y}];
      const auto known = truth.find(place(view.geometry.center({x, y}), view.geometry.resolution));
      ASSERT_EQ(cell, known == truth.end() ? 0 : known->second);
      held += cell != 0 ? 1u : 0u;
    }
  }
  ASSERT_EQ(held, truth.size());
}

TEST(GrowingMapTest, StartsEmpty) {
  const GrowingMap map(0.05);
  EXPECT_EQ(map.view().geometry.size(), 0u);
  const OccupancyGrid grid = map.occupancy();
  EXPECT_EQ(grid.geometry.size(), 1u);
  EXPECT_EQ(grid.cells, std::vector<Occupancy>{kUnknown});
}

TEST(GrowingMapTest, KeepsWhatItHoldsWhileItGrowsInAllDirections) {
  for (const double resolution : {0.05, 0.1, 0.03}) {
    Random random(1);
    GrowingMap map(resolution);
    Truth truth;
    for (int i = 0; i < 150; ++i) {
      const double reach = 0.1 + 0.02 * i;
      const Point2 center{random.uniform(-reach, reach), random.uniform(-reach, reach)};
      map.cover(center, 0.3);
      const auto view = map.view();
      const CellIndex cell = view.geometry.cell_at(center);
      ASSERT_TRUE(view.contains(cell));
      const auto value = static_cast<LogOdds>(1 + random.below(100));
      view[cell] = value;
      truth[place(view.geometry.center(cell), resolution)] = value;
      expect_holds(map, truth);
    }
  }
}

TEST(GrowingMapTest, CoversTheWholeDiscAskedFor) {
  Random random(2);
  for (int run = 0; run < 200; ++run) {
    GrowingMap map(0.05);
    for (int i = 0; i < 3; ++i) {
      const Point2 center{random.uniform(-5.0, 5.0), random.uniform(-5.0, 5.0)};
      const double radius = random.uniform(0.0, 1.0);
      map.cover(center, radius);
      for (const double bearing : {0.0, 0.5 * kPi, kPi, -0.5 * kPi}) {
        EXPECT_TRUE(map.view().contains(map.view().geometry.cell_at(center + radius * direction(bearing))));
      }
    }
  }
}

TEST(GrowingMapTest, CornersStayAtMultiplesOfTheResolution) {
  Random random(3);
  GrowingMap map(0.05);
  for (int i = 0; i < 50; ++i) {
    map.cover({random.uniform(-20.0, 20.0), random.uniform(-20.0, 20.0)}, 0.3);
    for (const GridGeometry& geometry : {map.view().geometry, map.occupancy().geometry}) {
      for (const double corner : {geometry.origin.x(), geometry.origin.y()}) {
        EXPECT_NEAR(corner / 0.05, std::round(corner / 0.05), 1e-9);
      }
    }
  }
}

TEST(GrowingMapTest, GrowsSeldom) {
  GrowingMap map(0.05);
  int grown = 0;
  std::size_t size = 0;
  for (int i = 0; i < 2000; ++i) {
    map.cover({0.02 * i, 0.0}, 0.3);
    grown += map.view().geometry.size() != size;
    size = map.view().geometry.size();
  }
  EXPECT_LT(grown, 15);
}

TEST(GrowingMapTest, OccupancyIsCutToWhatIsKnownAndTrinary) {
  GrowingMap map(0.25);
  map.cover({0.0, 0.0}, 3.0);
  const auto view = map.view();
  const auto set = [&](double x, double y, LogOdds value) { view[view.geometry.cell_at({x, y})] = value; };
  set(-1.1, 0.6, kOccupiedLogOdds);
  set(-0.6, 0.6, kFreeLogOdds);
  set(-0.6, 0.1, 5);  // some evidence, but not enough
  const OccupancyGrid grid = map.occupancy();
  EXPECT_EQ(grid.geometry.origin, (Point2{-1.25, 0.0}));
  EXPECT_EQ(grid.geometry.width, 3);
  EXPECT_EQ(grid.geometry.height, 3);
  EXPECT_EQ(grid.geometry.resolution, 0.25);
  EXPECT_EQ(grid.cells, (std::vector<Occupancy>{-1, -1, -1, -1, -1, -1, 100, -1, 0}));
}

TEST(GrowingMapTest, RefusesAPoseThatWentAstray) {
  GrowingMap map(0.05);
  map.cover({0.0, 0.0}, 0.3);
  const GridGeometry before = map.view().geometry;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const Point2& pose : {Point2{1000.0, 0.0}, Point2{0.0, -1000.0}, Point2{1e300, 0.0}, Point2{nan, 0.0},
                             Point2{0.0, nan}, Point2{infinity, 0.0}, Point2{0.0, -infinity}}) {
    try {
      map.cover(pose, 0.3);
      FAIL() << pose.transpose();
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), Error::Kind::Failure);
      EXPECT_NE(std::string(error.what()).find("gone astray"), std::string::npos);
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
    EXPECT_EQ(map.view().geometry, before);
  }
}

}  // namespace
}  // namespace scrubjay
