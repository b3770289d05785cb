#include <algorithm>
#include <cmath>
#include <scrubjay/exploration/feelers.hpp>
#include <scrubjay/oi/infrared.hpp>

namespace scrubjay {

Ahead ahead_by_light(const Frame& frame, const RobotModel& robot, double trusted) {
  Ahead nearest;
  for (std::size_t i = 0; robot.has_light_sensors && i < frame.light_signal.size(); ++i) {
    const double range = robot.light.range(frame.light_signal[i]);
    if (range > trusted) continue;
    const Point2 hit = robot.light.mount[i] * Point2(range, 0.0);
    const double aside = std::fabs(hit.y());
    if (hit.x() <= 0.0 || aside >= robot.radius) continue;
    const double shell = std::sqrt(robot.radius * robot.radius - aside * aside);
    const double way = std::max(0.0, hit.x() - shell);
    if (way < nearest.way) nearest = {way, hit};
  }
  return nearest;
}

double room_beside(const Frame& frame, const RobotModel& robot) {
  constexpr double kNothing = std::numeric_limits<double>::infinity();
  if (!robot.has_light_sensors) return kNothing;
  double room = 0.0;
  for (const LightSensor side : {LightSensor::Left, LightSensor::Right}) {
    const auto i = static_cast<std::size_t>(side);
    const double range = robot.light.range(frame.light_signal[i]);
    if (range > robot.light.max_range) return kNothing;
    room += std::fabs((robot.light.mount[i] * Point2(range, 0.0)).y()) - robot.radius;
  }
  return room;
}

bool faces_dock(const Frame& frame) {
  const auto beams = oi::dock_beams(frame.infrared_omni);
  if (!beams || !beams->red || !beams->green || !beams->force_field) return false;
  const auto sees_dock = [](std::uint8_t character) {
    const auto seen = oi::dock_beams(character);
    return seen && seen->any();
  };
  return sees_dock(frame.infrared_left) && sees_dock(frame.infrared_right);
}

double known_ahead(GridView<const LogOdds> map, const Pose2& pose, double radius, double sight) {
  const double step = map.geometry.resolution;
  for (double way = step; way <= sight; way += step) {
    for (const double aside : {-0.75, 0.0, 0.75}) {
      const CellIndex cell = map.geometry.cell_at(pose * Point2(radius + way, aside * radius));
      if (!map.contains(cell) || trinary(map[cell]) != kFree) return way - step;
    }
  }
  return sight;
}

double speed_to_stop(double way, double braking) {
  return std::sqrt(2.0 * braking * std::max(0.0, way));
}

}  // namespace scrubjay
