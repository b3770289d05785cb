#include <gmock/gmock.h>

#include "stage.hpp"

namespace scrubjay::test {
namespace {

using ::testing::Each;

constexpr double kAmbient = 30.0;

const LightSensorModel& model() {
  static const LightSensorModel light;
  return light;
}

/// The robot at the origin, and a wall `range` from sensor `i`, seen `incidence` from square on.
Stage wall_before(std::size_t i, double range, double incidence = 0.0, double half_width = 1.0,
                  const sim::NoiseProfile& noise = {}) {
  const Pose2& mount = model().mount[i];
  const Point2 hit = mount.position() + range * direction(mount.yaw);
  const Point2 along = half_width * direction(mount.yaw + 0.5 * kPi + incidence);
  return Stage(with_walls({{{hit - along, hit + along}}}), {}, noise);
}

TEST(LightSensorTest, TellsTheAmbientWhenNothingIsNear) {
  Stage stage(room(4.0, 4.0), {2.0, 2.0, 0.7});
  EXPECT_THAT(stage.feel().light_signal, Each(kAmbient));
}

TEST(LightSensorTest, FollowsTheCurveOfTheModel) {
  for (std::size_t i = 0; i < kLightSensorCount; ++i) {
    for (const double range : {0.03, 0.06, 0.1, 0.15, 0.2}) {
      Stage stage = wall_before(i, range);
      const double expected = 3500.0 * std::exp(-26.83 * range);
      EXPECT_NEAR(stage.feel().light_signal[i] - kAmbient, expected, 0.02 * expected) << i << " at " << range;
    }
  }
}

TEST(LightSensorTest, SeesLessOfAWallThatIsTurnedAway) {
  for (const double degrees : {-50.0, -30.0, 30.0, 50.0}) {
    Stage stage = wall_before(2, 0.1, radians(degrees));
    const double expected = 3500.0 * std::exp(-26.83 * 0.1) * std::cos(radians(degrees));
    EXPECT_NEAR(stage.feel().light_signal[2] - kAmbient, expected, 0.04 * expected) << degrees;
  }
}

TEST(LightSensorTest, GrowsAsAWallComesNearer) {
  Stage stage(with_walls({facing({0.0, 0.0}, 0.0, 0.6, 1.0)}));
  sim::BodySenses before = stage.feel();
  while (!before.bump_left) {
    const sim::BodySenses& senses = stage.body.tick({0.1, 0.1});
    for (const std::size_t i : {1u, 2u, 3u, 4u}) EXPECT_GE(senses.light_signal[i], before.light_signal[i]);
    before = senses;
  }
  EXPECT_GT(before.light_signal[2], 1000.0);
}

TEST(LightSensorTest, EachLooksItsOwnWay) {
  for (std::size_t i = 0; i < kLightSensorCount; ++i) {
    Stage stage = wall_before(i, 0.03, 0.0, 0.02);
    const sim::BodySenses& senses = stage.feel();
    for (std::size_t other = 0; other < kLightSensorCount; ++other) {
      EXPECT_EQ(senses.light_signal[other] > 1000.0, other == i) << other << " with a wall before " << i;
    }
    EXPECT_EQ(senses.light_flags, 1 << i);
  }
}

TEST(LightSensorTest, TheFirstThingInTheWayCounts) {
  const Wall near = facing({0.0, 0.0}, radians(12.5), 0.25, 0.1);
  const Wall far = facing({0.0, 0.0}, radians(12.5), 0.3, 0.1);
  Stage both(with_walls({far, near}));
  Stage alone(with_walls({near}));
  EXPECT_EQ(both.feel().light_signal[2], alone.feel().light_signal[2]);
}

TEST(LightSensorTest, ADarkSurfaceGivesLess) {
  sim::NoiseProfile dark;
  dark.albedo = {0.5, 0.5};
  const double white = wall_before(3, 0.05).feel().light_signal[3] - kAmbient;
  EXPECT_DOUBLE_EQ(wall_before(3, 0.05, 0.0, 1.0, dark).feel().light_signal[3] - kAmbient, 0.5 * white);
}

TEST(LightSensorTest, EachThingHasAColourOfItsOwn) {
  sim::NoiseProfile colours;
  colours.albedo = {0.4, 1.4};
  // The same wall on the left and on the right.
  Stage stage(with_walls({facing({0.0, 0.0}, radians(65.0), 0.2, 0.05), facing({0.0, 0.0}, radians(-65.0), 0.2, 0.05)}),
              {}, colours);
  const sim::BodySenses& senses = stage.feel();
  EXPECT_GT(std::fabs(senses.light_signal[0] - senses.light_signal[5]), 1.0);
}

TEST(LightSensorTest, FlagsRiseAtAHundredCountsAndFallAtSeventy) {
  Stage stage(with_walls({facing({0.0, 0.0}, 0.0, 0.45, 1.0)}));
  constexpr std::uint8_t kCenterLeft = 4;
  double signal = stage.feel().light_signal[2];
  int rises = 0;
  int falls = 0;
  bool flagged = false;
  for (int i = 0; i < ticks_in(14.0); ++i) {
    const double speed = i < ticks_in(7.0) ? 0.03 : -0.03;
    const sim::BodySenses& senses = stage.body.tick({speed, speed});
    const bool now = (senses.light_flags & kCenterLeft) != 0;
    if (now && !flagged) {
      ++rises;
      EXPECT_LT(signal, 100.0);
      EXPECT_GE(senses.light_signal[2], 100.0);
    }
    if (!now && flagged) {
      ++falls;
      EXPECT_GE(signal, 70.0);
      EXPECT_LT(senses.light_signal[2], 70.0);
    }
    flagged = now;
    signal = senses.light_signal[2];
  }
  EXPECT_EQ(rises, 1);
  EXPECT_EQ(falls, 1);
}

TEST(LightSensorTest, NoiseHasAShareOfTheSignalAndAFloor) {
  const auto deviation = [](Stage& stage) {
    constexpr int kSamples = 4000;
    double sum = 0.0;
    double squares = 0.0;
    for (int i = 0; i < kSamples; ++i) {
      const double signal = stage.feel().light_signal[2];
      sum += signal;
      squares += signal * signal;
    }
    const double mean = sum / kSamples;
    return std::sqrt(squares / kSamples - mean * mean);
  };
  sim::NoiseProfile noise;
  noise.light_noise = 0.02;
  noise.light_floor_noise = 5.0;
  Stage dark({}, {}, noise);
  EXPECT_NEAR(deviation(dark), 5.0, 0.3);
  Stage bright = wall_before(2, 0.03, 0.0, 1.0, noise);
  const double signal = kAmbient + 3500.0 * std::exp(-26.83 * 0.03);
  EXPECT_NEAR(deviation(bright), std::hypot(5.0, 0.02 * signal), 2.0);
}

TEST(LightSensorTest, ARobotWithoutLightSensorsSeesNothing) {
  sim::RobotSpec spec;
  spec.model.has_light_sensors = false;
  Stage stage(with_walls({facing({0.0, 0.0}, 0.0, 0.18, 1.0)}), {}, {}, 1, spec);
  EXPECT_THAT(stage.feel().light_signal, Each(0.0));
  EXPECT_EQ(stage.feel().light_flags, 0);
}

// It stands at (90, -120) mm and looks 57 degrees to the right.
TEST(WallSensorTest, SeesAWallOnTheRightFromSixteenToFortyMillimetres) {
  for (const auto& [range, seen] :
       {std::pair{0.010, false}, {0.017, true}, {0.025, true}, {0.039, true}, {0.041, false}}) {
    Stage stage(with_walls({facing({0.09, -0.12}, radians(-57.0), range, 0.1)}));
    const sim::BodySenses& senses = stage.feel();
    EXPECT_EQ(senses.wall, seen) << range;
    EXPECT_EQ(senses.wall_signal > 0.0, range < 0.04) << range;
  }
}

TEST(WallSensorTest, SignalGrowsAsTheWallComesNearer) {
  double before = 0.0;
  for (const double range : {0.039, 0.03, 0.02, 0.01}) {
    Stage stage(with_walls({facing({0.09, -0.12}, radians(-57.0), range, 0.1)}));
    EXPECT_GT(stage.feel().wall_signal, before);
    before = stage.feel().wall_signal;
  }
  EXPECT_LE(before, 1023.0);
}

TEST(WallSensorTest, SeesNothingOnTheLeft) {
  Stage stage(with_walls({facing({0.09, 0.12}, radians(57.0), 0.025, 0.1)}));
  EXPECT_FALSE(stage.feel().wall);
  EXPECT_EQ(stage.feel().wall_signal, 0.0);
}

}  // namespace
}  // namespace scrubjay::test
