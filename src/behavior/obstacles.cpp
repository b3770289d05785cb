#include <scrubjay/behavior/obstacles.hpp>

namespace scrubjay {

std::uint16_t light_signal_at(double range, const RobotModel& robot) {
  if (!robot.has_light_sensors) return 0xFFFF;  // never reached
  const LightSensorModel& light = robot.light;
  return static_cast<std::uint16_t>(light.ambient + light.gain * exp(-light.attenuation * range));
}

ObstacleSense::ObstacleSense(const RobotModel& robot, const ObstacleParams& params)
    : near_signal_(light_signal_at(params.ahead_range, robot)) {}

Obstacles ObstacleSense::operator()(const Frame& frame) const {
  const auto lit = [&](LightSensor sensor) {
    return frame.light_signal[static_cast<std::size_t>(sensor)] >= near_signal_;
  };
  const auto cliff = [&](CliffSensor sensor) { return (frame.cliff_flags >> static_cast<int>(sensor) & 1) != 0; };
  Obstacles found;
  found.left = frame.bump_left || cliff(CliffSensor::Left) || lit(LightSensor::Left) || lit(LightSensor::FrontLeft);
  found.right =
      frame.bump_right || cliff(CliffSensor::Right) || lit(LightSensor::Right) || lit(LightSensor::FrontRight);
  // A wall along one side is no reason to stop; one that the front of the robot would touch is.
  found.ahead = frame.bumped() || frame.cliff_flags != 0 || frame.virtual_wall || lit(LightSensor::FrontLeft) ||
                lit(LightSensor::CenterLeft) || lit(LightSensor::CenterRight) || lit(LightSensor::FrontRight);
  return found;
}

}  // namespace scrubjay
