#include <gtest/gtest.h>

#include <scrubjay/oi/sensor_views.hpp>

namespace scrubjay::oi {
namespace {

Sensors with(PacketId id, std::int32_t value) {
  Sensors sensors;
  sensors.set(id, value);
  return sensors;
}

TEST(SensorViewsTest, BumpsComeRightBeforeLeft) {
  EXPECT_TRUE(bumps_and_wheel_drops(with(PacketId::BumpsAndWheelDrops, 1)).bump_right);
  EXPECT_TRUE(bumps_and_wheel_drops(with(PacketId::BumpsAndWheelDrops, 2)).bump_left);
  EXPECT_EQ(bumps_and_wheel_drops(with(PacketId::BumpsAndWheelDrops, 0b10110)),
            (BumpsAndWheelDrops{false, true, true, false, true}));
  EXPECT_TRUE(bumps_and_wheel_drops(with(PacketId::BumpsAndWheelDrops, 8)).wheel_drop_left);
  EXPECT_FALSE(bumps_and_wheel_drops(with(PacketId::BumpsAndWheelDrops, 12)).bumped());
  EXPECT_FALSE(bumps_and_wheel_drops(with(PacketId::BumpsAndWheelDrops, 3)).wheel_dropped());
}

TEST(SensorViewsTest, LightBumperRunsFromLeftToRight) {
  EXPECT_EQ(light_bumper(with(PacketId::LightBumper, 1)), (LightBumper{.left = true}));
  EXPECT_EQ(light_bumper(with(PacketId::LightBumper, 2)), (LightBumper{.front_left = true}));
  EXPECT_EQ(light_bumper(with(PacketId::LightBumper, 12)), (LightBumper{.center_left = true, .center_right = true}));
  EXPECT_EQ(light_bumper(with(PacketId::LightBumper, 48)), (LightBumper{.front_right = true, .right = true}));
}

TEST(SensorViewsTest, OvercurrentsOfBrushesAndWheels) {
  EXPECT_EQ(wheel_overcurrents(with(PacketId::WheelOvercurrents, 1)), (WheelOvercurrents{.side_brush = true}));
  EXPECT_EQ(wheel_overcurrents(with(PacketId::WheelOvercurrents, 4)), (WheelOvercurrents{.main_brush = true}));
  EXPECT_EQ(wheel_overcurrents(with(PacketId::WheelOvercurrents, 24)),
            (WheelOvercurrents{.right_wheel = true, .left_wheel = true}));
}

TEST(SensorViewsTest, ButtonsHaveAnotherOrderOnEachModel) {
  const Sensors first = with(PacketId::Buttons, 1);
  EXPECT_EQ(pressed_buttons(first, Model::Create2), (PressedButtons{.clean = true}));
  EXPECT_EQ(pressed_buttons(first, Model::Create1), (PressedButtons{.clean = true}));
  EXPECT_EQ(pressed_buttons(first, Model::Roomba400), (PressedButtons{.max = true}));
  const Sensors third = with(PacketId::Buttons, 4);
  EXPECT_EQ(pressed_buttons(third, Model::Create2), (PressedButtons{.dock = true}));
  EXPECT_EQ(pressed_buttons(third, Model::Create1), (PressedButtons{.dock = true}));
  EXPECT_EQ(pressed_buttons(third, Model::Roomba400), (PressedButtons{.spot = true}));
  EXPECT_EQ(pressed_buttons(with(PacketId::Buttons, 0xC0), Model::Create2),
            (PressedButtons{.schedule = true, .clock = true}));
}

TEST(SensorViewsTest, ChargingIsReconditioningFullOrTrickle) {
  const bool expected[] = {false, true, true, true, false, false};
  for (int state = 0; state < 6; ++state) {
    EXPECT_EQ(is_charging(charging_state(with(PacketId::ChargingState, state))), expected[state]) << state;
  }
  EXPECT_EQ(charging_state(with(PacketId::ChargingState, 5)), ChargingState::Fault);
}

TEST(SensorViewsTest, ChargingSourcesAndStasis) {
  EXPECT_EQ(charging_sources(with(PacketId::ChargingSourcesAvailable, 2)), (ChargingSources{false, true}));
  EXPECT_EQ(stasis(with(PacketId::Stasis, 1)), (Stasis{true, false}));
  EXPECT_EQ(stasis(with(PacketId::Stasis, 2)), (Stasis{false, true}));
}

}  // namespace
}  // namespace scrubjay::oi
