#include "infrared_sensing.hpp"

#include <cmath>
#include <scrubjay/oi/infrared.hpp>

namespace scrubjay::sim {
namespace {

/// Where the robot is, seen from an emitter.
struct Sight {
  double range = 0.0;    ///< [m]
  double bearing = 0.0;  ///< [rad]
};

Sight sight_of(const Pose2& emitter, const Point2& receiver) {
  const Point2 seen = inverse(emitter) * receiver;
  return {seen.norm(), atan2(seen.y(), seen.x())};
}

bool lit(const SegmentIndex& index, const Pose2& emitter, const Point2& receiver, double range) {
  if (range <= 0.0) return true;
  const Point2 way = (receiver - emitter.position()) / range;
  // The emitter may stand against a wall: look from a hand's breadth in front of it.
  constexpr double kClear = 0.01;
  return index.cast(emitter.position() + kClear * way, way, range - kClear).range >= range - kClear;
}

std::uint8_t dock_character(const SegmentIndex& index, const InfraredSpec& spec, const Pose2& dock,
                            const Point2& receiver) {
  const Sight sight = sight_of(dock, receiver);
  if (sight.range > spec.buoy_range || !lit(index, dock, receiver, sight.range)) return 0;
  oi::DockBeams beams;
  beams.force_field = sight.range <= spec.force_field;
  // A robot that comes has the red buoy on its left, which is the dock's right.
  beams.red = std::fabs(sight.bearing + spec.buoy_bearing) <= spec.buoy_half_angle;
  beams.green = std::fabs(sight.bearing - spec.buoy_bearing) <= spec.buoy_half_angle;
  return oi::dock_character(beams);
}

bool in_dock(const Pose2& dock, const Pose2& robot, const Point2& receiver) {
  constexpr double kContactDistance = 0.03;
  constexpr double kContactAngle = radians(15.0);
  return (receiver - dock.position()).norm() <= kContactDistance &&
         std::fabs(angle_difference(robot.yaw, dock.yaw + kPi)) <= kContactAngle;
}

}  // namespace

void sense_infrared(const World& world, const SegmentIndex& index, const InfraredSpec& spec, const Pose2& robot,
                    BodySenses& senses) {
  senses.virtual_wall = false;
  senses.infrared_omni = senses.infrared_left = senses.infrared_right = 0;
  const Point2 receiver = robot * spec.receiver;
  if (world.dock) {
    const Pose2& dock = world.dock->pose;
    senses.infrared_omni = dock_character(index, spec, dock, receiver);
    senses.docked = in_dock(dock, robot, receiver);
    // The two directional receivers look ahead, each to its side and a little past the middle; own guess.
    const double bearing = sight_of(robot, dock.position()).bearing;
    if (bearing > radians(-15.0) && bearing < radians(90.0)) senses.infrared_left = senses.infrared_omni;
    if (bearing < radians(15.0) && bearing > radians(-90.0)) senses.infrared_right = senses.infrared_omni;
  }
  for (const VirtualWall& fence : world.virtual_walls) {
    const Sight sight = sight_of(fence.pose, receiver);
    if (sight.range > fence.range || std::fabs(sight.bearing) > fence.half_angle) continue;
    if (!lit(index, fence.pose, receiver, sight.range)) continue;
    senses.virtual_wall = true;
    senses.infrared_omni = oi::kVirtualWall;
  }
}

}  // namespace scrubjay::sim
