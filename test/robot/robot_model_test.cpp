#include <gtest/gtest.h>

#include <cmath>
#include <scrubjay/robot/robot_model.hpp>

namespace scrubjay {
namespace {

TEST(LightSensorModelTest, RangeUndoesTheSignal) {
  const LightSensorModel light;
  for (const double range : {0.0, 0.01, 0.05, 0.1, 0.15}) {
    const double signal = light.gain * std::exp(-light.attenuation * range) + light.ambient;
    // The signal is a whole number; its slope says how much that costs.
    const double step = 1.0 / (light.attenuation * (signal - light.ambient));
    EXPECT_NEAR(light.range(static_cast<std::uint16_t>(std::lround(signal))), range, step);
  }
}

TEST(LightSensorModelTest, WeakSignalsSayNothingAndStrongOnesContact) {
  const LightSensorModel light;
  EXPECT_GE(light.range(0), light.max_range);
  EXPECT_GE(light.range(30), light.max_range);
  EXPECT_EQ(light.range(3530), 0.0);
  EXPECT_EQ(light.range(4095), 0.0);
}

TEST(LightSensorModelTest, RangeFallsAsTheSignalGrows) {
  const LightSensorModel light;
  for (std::uint16_t signal = 31; signal < 3530; ++signal) {
    ASSERT_GT(light.range(signal), light.range(static_cast<std::uint16_t>(signal + 1)));
  }
}

TEST(LightSensorModelTest, SensorsSitOnACircleAndLookOutwards) {
  const LightSensorModel light;
  for (const Pose2& mount : light.mount) {
    EXPECT_NEAR(mount.position().norm(), 0.154, 1e-9);
    EXPECT_NEAR(std::atan2(mount.y, mount.x), mount.yaw, 1e-9);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_GT(light.mount[i].yaw, light.mount[i + 1].yaw);  // left to right
    EXPECT_NEAR(light.mount[i].y, -light.mount[5 - i].y, 1e-12);
  }
}

}  // namespace
}  // namespace scrubjay
