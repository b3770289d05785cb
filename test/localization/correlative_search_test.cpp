#include <gtest/gtest.h>

#include <algorithm>
#include <scrubjay/geometry/random.hpp>
#include <scrubjay/localization/correlative_search.hpp>

namespace scrubjay {
namespace {

constexpr double kBeamWeight = 0.7;

/// Points at random, in a map and as a scan.
struct Scene {
  explicit Scene(std::uint64_t seed) : cells(geometry.size()) {
    Random random(seed);
    for (int i = 0; i < 60; ++i) {
      const Point2 p(random.uniform(-2.5, 2.5), random.uniform(-2.5, 2.5));
      cells[geometry.index(geometry.cell_at(p))] = kMaxLogOdds;
      ends.push_back(inverse(truth) * p);
    }
    field.follow({geometry, cells.data()}, {});
  }

  double worth(const Pose2& pose, const PosePrior& prior, const Eigen::Vector3d& error) const {
    double fit = 0.0;
    for (const Point2& end : ends) fit += field.at(geometry.cell_at(pose * end));
    return kBeamWeight * fit / LikelihoodField::kBest + prior.log_likelihood(error);
  }

  GridGeometry geometry{0.05, {-3.0, -3.0}, 120, 120};
  Pose2 truth{0.12, -0.31, 0.4};
  std::vector<LogOdds> cells;
  std::vector<Point2> ends;
  LikelihoodField field;
};

PosePrior guess(const Pose2& pose, double sigma, double sigma_angle) {
  PosePrior prior{pose, Eigen::Matrix3d::Zero()};
  prior.information.diagonal() << 1.0 / (sigma * sigma), 1.0 / (sigma * sigma), 1.0 / (sigma_angle * sigma_angle);
  return prior;
}

TEST(CorrelativeSearchTest, FindsTheTruthToACell) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Scene scene(seed);
    CorrelativeSearch search(kBeamWeight);
    Random random(seed + 100);
    const Pose2 off{random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), random.uniform(-0.2, 0.2)};
    const PosePrior prior = guess({scene.truth.x + off.x, scene.truth.y + off.y, scene.truth.yaw + off.yaw}, 0.2, 0.2);
    const Pose2 found = search.best(scene.ends, scene.field, prior, {8, 0.25});
    EXPECT_NEAR(found.x, scene.truth.x, 0.05) << seed;
    EXPECT_NEAR(found.y, scene.truth.y, 0.05) << seed;
    EXPECT_NEAR(found.yaw, scene.truth.yaw, 0.03) << seed;
  }
}

TEST(CorrelativeSearchTest, MissesNoBetterPoseOfItsWindow) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Scene scene(seed);
    CorrelativeSearch search(kBeamWeight);
    const PosePrior prior = guess({0.3, -0.2, 0.5}, 0.15, 0.1);
    const Pose2 found = search.best(scene.ends, scene.field, prior, {5, 0.1});
    const Eigen::Vector3d off(found.x - prior.pose.x, found.y - prior.pose.y, found.yaw - prior.pose.yaw);
    const double best = scene.worth(found, prior, off);
    for (int y = -5; y <= 5; ++y) {
      for (int x = -5; x <= 5; ++x) {
        const Eigen::Vector3d other(0.05 * x, 0.05 * y, off.z());
        // Where a cell's border is met to the last bit, one end may be in either cell.
        const double worth = scene.worth({prior.pose.x + other.x(), prior.pose.y + other.y(), found.yaw}, prior, other);
        EXPECT_LE(worth, best + kBeamWeight) << seed << ": " << x << ", " << y;
      }
    }
  }
}

TEST(CorrelativeSearchTest, StaysWithTheGuessWhereTheMapSaysNothing) {
  const Scene scene(1);
  CorrelativeSearch search(kBeamWeight);
  const std::vector<Point2> nowhere{{100.0, 0.0}, {0.0, 100.0}};
  const Pose2 pose{0.1, 0.2, 0.3};
  EXPECT_EQ(search.best(nowhere, scene.field, guess(pose, 0.1, 0.1), {4, 0.1}), pose);
}

TEST(CorrelativeSearchTest, WeighsTheGuess) {
  const Scene scene(2);
  CorrelativeSearch search(kBeamWeight);
  const Pose2 pose{scene.truth.x + 0.2, scene.truth.y, scene.truth.yaw};
  const Pose2 free = search.best(scene.ends, scene.field, guess(pose, 1.0, 1.0), {6, 0.1});
  const Pose2 sure = search.best(scene.ends, scene.field, guess(pose, 0.001, 0.001), {6, 0.1});
  EXPECT_NEAR(free.x, scene.truth.x, 0.05);
  EXPECT_EQ(sure, pose);
}

}  // namespace
}  // namespace scrubjay
