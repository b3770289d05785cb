#include <gtest/gtest.h>

#include <scrubjay/world/trajectory_error.hpp>

namespace scrubjay {
namespace {

TEST(TrajectoryErrorTest, IsZeroForTheTruthItself) {
  const StampedPose track[] = {{0.0, {0, 0, 0}}, {0.1, {1, 2, 0.5}}};
  const TrajectoryError error = trajectory_error(track, track);
  EXPECT_EQ(error.ate, 0.0);
  EXPECT_EQ(error.final_distance, 0.0);
  EXPECT_EQ(error.final_heading, 0.0);
}

TEST(TrajectoryErrorTest, TakesTheRootMeanSquareAndTheLastPose) {
  const StampedPose truth[] = {{0.0, {0, 0, 0}}, {0.1, {1, 0, 3.0}}};
  const StampedPose estimate[] = {{0.0, {0, 3, 0}}, {0.1, {1, 4, -3.0}}};
  const TrajectoryError error = trajectory_error(estimate, truth);
  EXPECT_DOUBLE_EQ(error.ate, std::sqrt((9.0 + 16.0) / 2.0));
  EXPECT_DOUBLE_EQ(error.final_distance, 4.0);
  EXPECT_NEAR(error.final_heading, 2.0 * kPi - 6.0, 1e-12);  // the short way round
}

TEST(TrajectoryErrorTest, NothingToCompareIsNoError) {
  const StampedPose one[] = {{0.0, {5, 5, 0}}};
  EXPECT_EQ(trajectory_error({}, {}).ate, 0.0);
  EXPECT_EQ(trajectory_error(one, {}).ate, 0.0);
}

}  // namespace
}  // namespace scrubjay
