#include <gmock/gmock.h>

#include <scrubjay/io/robot_file.hpp>
#include <set>

#include "stage.hpp"

namespace scrubjay::test {
namespace {

using ::testing::AllOf;
using ::testing::Each;
using ::testing::Ge;
using ::testing::Le;

constexpr std::size_t kPieces = 5;

sim::NoiseProfile profile(std::string_view name) {
  return read_noise(std::filesystem::path(SCRUBJAY_SOURCE_DIR) / "urdf/noise.yaml", name);
}

TEST(NoiseTest, NoneIsPerfect) {
  const sim::SystematicErrors errors = draw_errors(profile("none"), kPieces, Random(1));
  EXPECT_EQ(errors.left_scale, 1.0);
  EXPECT_EQ(errors.right_scale, 1.0);
  EXPECT_EQ(errors.separation_scale, 1.0);
  EXPECT_THAT(errors.mount, Each(0.0));
  EXPECT_THAT(errors.albedo, Each(1.0));
  EXPECT_EQ(errors.albedo.size(), kPieces);
}

class NoiseProfileTest : public ::testing::TestWithParam<const char*> {};

TEST_P(NoiseProfileTest, DrawsWithinItsRangesEitherWay) {
  const sim::NoiseProfile noise = profile(GetParam());
  int left_larger = 0;
  int wider = 0;
  constexpr int kRuns = 500;
  for (std::uint64_t seed = 0; seed < kRuns; ++seed) {
    const sim::SystematicErrors errors = draw_errors(noise, kPieces, Random(seed));
    const double middle = 0.5 * (errors.left_scale + errors.right_scale);
    EXPECT_THAT(std::fabs(errors.left_scale - errors.right_scale) / middle,
                AllOf(Ge(noise.wheel_mismatch.low - 1e-12), Le(noise.wheel_mismatch.high + 1e-12)));
    EXPECT_THAT(middle, AllOf(Ge((1.0 - noise.distance_error) * noise.grip.low - 1e-12),
                              Le((1.0 + noise.distance_error) * noise.grip.high + 1e-12)));
    EXPECT_THAT(std::fabs(errors.separation_scale - 1.0),
                AllOf(Ge(noise.separation_error.low - 1e-12), Le(noise.separation_error.high + 1e-12)));
    EXPECT_THAT(errors.mount, Each(AllOf(Ge(-noise.mount_error), Le(noise.mount_error))));
    EXPECT_THAT(errors.albedo, Each(AllOf(Ge(noise.albedo.low), Le(noise.albedo.high))));
    left_larger += errors.left_scale > errors.right_scale;
    wider += errors.separation_scale > 1.0;
  }
  EXPECT_NEAR(left_larger, kRuns / 2, kRuns / 8);
  EXPECT_NEAR(wider, kRuns / 2, kRuns / 8);
}

INSTANTIATE_TEST_SUITE_P(Profiles, NoiseProfileTest, ::testing::Values("hard-floor", "carpet", "uncalibrated"));

TEST(NoiseTest, ErrorsAreThoseOfTheSeed) {
  const sim::NoiseProfile noise = profile("hard-floor");
  EXPECT_EQ(draw_errors(noise, kPieces, Random(3)).albedo, draw_errors(noise, kPieces, Random(3)).albedo);
  EXPECT_NE(draw_errors(noise, kPieces, Random(3)).albedo, draw_errors(noise, kPieces, Random(4)).albedo);
}

TEST(NoiseTest, AWorldWithMoreInItLeavesTheRobotsOwnErrorsAlone) {
  const sim::NoiseProfile noise = profile("hard-floor");
  const sim::SystematicErrors few = draw_errors(noise, 1, Random(3));
  const sim::SystematicErrors many = draw_errors(noise, 100, Random(3));
  EXPECT_EQ(few.left_scale, many.left_scale);
  EXPECT_EQ(few.separation_scale, many.separation_scale);
  EXPECT_EQ(few.mount, many.mount);
  EXPECT_EQ(few.albedo[0], many.albedo[0]);
}

/// Mean and standard deviation of `sample(seed)`.
template <typename Sample>
std::pair<double, double> moments(int count, Sample sample) {
  double sum = 0.0;
  double squares = 0.0;
  for (int seed = 0; seed < count; ++seed) {
    const double value = sample(static_cast<std::uint64_t>(seed));
    sum += value;
    squares += value * value;
  }
  const double mean = sum / count;
  return {mean, std::sqrt(squares / count - mean * mean)};
}

TEST(NoiseTest, AWheelsWayErrsByTheSquareRootOfTheWay) {
  sim::NoiseProfile noise;
  noise.travel_noise = 0.002;
  constexpr int kRuns = 800;
  for (const double seconds : {2.0, 8.0}) {
    double rolled = 0.0;
    const auto [mean, deviation] = moments(kRuns, [&](std::uint64_t seed) {
      Stage stage({}, {}, noise, seed);
      rolled = stage.drive(0.25, 0.25, seconds).left_rolled;
      return stage.pose().yaw;
    });
    // Both wheels err independently of each other; the heading is their difference over the axle.
    const double expected = 0.002 * std::sqrt(2.0 * rolled) / kAxle;
    EXPECT_NEAR(deviation, expected, 0.1 * expected) << seconds;
    EXPECT_NEAR(mean, 0.0, 4.0 * expected / std::sqrt(kRuns)) << seconds;
  }
}

TEST(NoiseTest, ATurnErrsByTheSquareRootOfTheTurn) {
  sim::NoiseProfile noise;
  noise.turn_noise = 0.02;
  constexpr int kRuns = 800;
  double turn = 0.0;
  const auto [mean, deviation] = moments(kRuns, [&](std::uint64_t seed) {
    Stage stage({}, {}, noise, seed);
    const sim::BodySenses& senses = stage.drive(-0.1, 0.1, 5.0);
    turn = (senses.right_rolled - senses.left_rolled) / kAxle;
    return angle_difference(stage.pose().yaw, turn);
  });
  const double expected = 0.02 * std::sqrt(turn);
  EXPECT_NEAR(deviation, expected, 0.1 * expected);
  EXPECT_NEAR(mean, 0.0, 4.0 * expected / std::sqrt(kRuns));
}

TEST(NoiseTest, UnequalWheelsDriveAnArc) {
  sim::NoiseProfile noise;
  noise.wheel_mismatch = {0.01, 0.01};
  Stage stage({}, {}, noise);
  const double rolled = stage.drive(0.2, 0.2, 10.0).left_rolled;
  EXPECT_NEAR(std::fabs(stage.pose().yaw), 0.01 * rolled / kAxle, 1e-9);
}

TEST(NoiseTest, AWiderAxleTurnsLess) {
  sim::NoiseProfile noise;
  noise.separation_error = {0.1, 0.1};
  std::set<double> shares;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    Stage stage({}, {}, noise, seed);
    const sim::BodySenses& senses = stage.drive(-0.05, 0.05, 5.0);
    shares.insert(std::round(100.0 * stage.pose().yaw / ((senses.right_rolled - senses.left_rolled) / kAxle)));
  }
  EXPECT_THAT(shares, ::testing::ElementsAre(91.0, 111.0));
}

TEST(NoiseTest, WheelSpeedsComeInStepsFromADeadband) {
  const sim::NoiseProfile hard_floor = profile("hard-floor");
  sim::NoiseProfile noise;
  noise.speed_step = hard_floor.speed_step;
  noise.speed_deadband = hard_floor.speed_deadband;
  const auto speed = [&](double wanted) {
    Stage stage({}, {}, noise);
    const double before = stage.drive(wanted, wanted, 2.0).left_rolled;
    return (stage.body.tick({wanted, wanted}).left_rolled - before) / kTick;
  };
  EXPECT_EQ(speed(0.0), 0.0);
  EXPECT_EQ(speed(0.0109), 0.0);
  EXPECT_EQ(speed(-0.0109), 0.0);
  EXPECT_NEAR(speed(0.1), 0.011 + 3 * 0.0285, 1e-9);
  EXPECT_NEAR(speed(-0.1), -(0.011 + 3 * 0.0285), 1e-9);
}

}  // namespace
}  // namespace scrubjay::test
