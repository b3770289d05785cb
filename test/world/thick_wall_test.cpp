#include <gtest/gtest.h>

#include <cmath>
#include <scrubjay/world/world.hpp>

namespace scrubjay {
namespace {

// By the shoelace formula; the outline repeats its first point.
double area(const Wall& wall) {
  double twice = 0.0;
  for (std::size_t i = 1; i < wall.points.size(); ++i) {
    const Point2& a = wall.points[i - 1];
    const Point2& b = wall.points[i];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * std::fabs(twice);
}

TEST(ThickWallTest, AStraightOneIsARectangleWithFlushEnds) {
  const Wall wall = thick_wall({{1, 1}, {3, 1}}, 0.1);
  EXPECT_EQ(wall.points.size(), 5u);
  EXPECT_EQ(wall.points.front(), wall.points.back());
  EXPECT_NEAR(area(wall), 0.2, 1e-12);
  for (const Point2& corner : wall.points) {
    EXPECT_NEAR(std::fabs(corner.y() - 1.0), 0.05, 1e-12);
    EXPECT_TRUE(corner.x() == 1.0 || corner.x() == 3.0);
  }
}

TEST(ThickWallTest, CornersAreMitredSoThatTheThicknessStays) {
  const Wall wall = thick_wall({{0, 0}, {2, 0}, {2, 3}}, 0.2);
  EXPECT_NEAR(area(wall), 0.2 * 5.0, 1e-12);  // what the outer side gains at a mitre, the inner one loses
  EXPECT_TRUE(contains({wall.points.begin(), wall.points.end() - 1}, {2.05, -0.05}));
  EXPECT_FALSE(contains({wall.points.begin(), wall.points.end() - 1}, {1.85, 0.15}));
}

TEST(ThickWallTest, ItsDirectionDoesNotMatter) {
  EXPECT_NEAR(area(thick_wall({{0, 0}, {1, 1}, {1, 2}}, 0.1)), area(thick_wall({{1, 2}, {1, 1}, {0, 0}}, 0.1)), 1e-12);
}

TEST(ThickWallTest, RepeatedPointsAndHairpinsStayFinite) {
  for (const Wall& wall : {thick_wall({{0, 0}, {0, 0}, {1, 0}}, 0.1), thick_wall({{0, 0}, {1, 0}, {0, 0.001}}, 0.1)}) {
    for (const Point2& corner : wall.points) {
      EXPECT_TRUE(std::isfinite(corner.x()) && std::isfinite(corner.y()));
      EXPECT_LT(corner.norm(), 2.0);
    }
  }
}

}  // namespace
}  // namespace scrubjay
