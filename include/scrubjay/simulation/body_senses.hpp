/// \file
/// What a simulated body feels in one tick, in physical units: the firmware puts it in packets.
#pragma once

#include <array>
#include <cstdint>
#include <scrubjay/robot/frame.hpp>

namespace scrubjay::sim {

struct WheelSpeeds {
  double left = 0.0;   ///< [m/s]
  double right = 0.0;  ///< [m/s]
};

struct BodySenses {
  bool bump_left = false;
  bool bump_right = false;
  bool wheel_drop_left = false;
  bool wheel_drop_right = false;
  std::array<double, kLightSensorCount> light_signal{};  ///< in counts, may be negative with noise
  std::uint8_t light_flags = 0;
  std::uint8_t cliff_flags = 0;
  double wall_signal = 0.0;
  bool wall = false;
  bool virtual_wall = false;
  std::uint8_t infrared_omni = 0;
  std::uint8_t infrared_left = 0;
  std::uint8_t infrared_right = 0;
  std::uint8_t dirt = 0;
  double left_rolled = 0.0;             ///< by the encoder's account, since the start; forwards is positive [m]
  double right_rolled = 0.0;            ///< [m]
  std::array<bool, 2> wheel_blocked{};  ///< left, right: turning against something that holds
  bool making_way = false;              ///< the caster wheel turns
  bool docked = false;
  Battery battery;
};

}  // namespace scrubjay::sim
