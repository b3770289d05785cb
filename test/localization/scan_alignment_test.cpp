#include <gtest/gtest.h>

#include <cmath>
#include <scrubjay/geometry/random.hpp>
#include <scrubjay/localization/scan_alignment.hpp>

namespace scrubjay {
namespace {

/// A map of one wall along y = 1, seen from below, with ends that lie beside it by `roughness`.
struct OneWall {
  explicit OneWall(double roughness = 0.0) {
    const GridGeometry grid{0.05, {-2.0, -2.0}, 80, 80};
    std::vector<LogOdds> cells(grid.size());
    Random random(7);
    for (double x = -1.5; x < 1.5; x += 0.01) {
      const Point2 end(x, 1.0 + roughness * random.normal());
      cells[grid.index(grid.cell_at(end))] = kMaxLogOdds;
      field.follow({grid, cells.data()}, cells_of(grid));
      surfaces.add(end, {0.0, -1.0}, 0.01, field);
    }
  }

  /// A robot at the origin sees the wall in `count` beams that come back in the direction `view`.
  ScanAlignment see(int count, const Point2& view, double noise, double width, double off = 0.0) const {
    std::vector<ScanEnd> ends;
    for (int i = 0; i < count; ++i) ends.push_back({{2.0 * i / count - 1.0, 1.0 + off}, view, noise, width});
    ScanAligner aligner;
    return aligner.align(ends, surfaces, field, {{}, 1e-3 * Eigen::Matrix3d::Identity()}, {});
  }

  LikelihoodField field;
  SurfaceMap surfaces;
};

TEST(ScanAlignerTest, LaysAScanOntoItsWall) {
  const ScanAlignment aligned = OneWall().see(60, {0.0, -1.0}, 0.02, 0.02, 0.03);
  EXPECT_NEAR(aligned.pose.y, -0.03, 1e-3);
  EXPECT_NEAR(aligned.pose.x, 0.0, 1e-6);
  EXPECT_GT(aligned.support, 59.0);
}

TEST(ScanAlignerTest, HardlySeesARangesErrorInABeamThatGrazesAWall) {
  const OneWall wall;
  const double head_on = wall.see(60, {0.0, -1.0}, 0.05, 0.02).information(1, 1);
  const double grazing = wall.see(60, {0.98, -0.199}, 0.05, 0.02).information(1, 1);
  EXPECT_GT(grazing, 4.0 * head_on);
}

TEST(ScanAlignerTest, TakesNoMoreFromManyBeamsThanTheirWallTells) {
  const OneWall wall(0.02);
  const double some = wall.see(20, {0.0, -1.0}, 0.01, 0.1).information(1, 1);
  const double many = wall.see(400, {0.0, -1.0}, 0.01, 0.005).information(1, 1);
  EXPECT_GT(many, some);
  EXPECT_LT(many, 4.0 * some);  // not 20 times as much
}

}  // namespace
}  // namespace scrubjay
