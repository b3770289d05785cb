#include <scrubjay/odometry/arc.hpp>

namespace scrubjay {

Pose2 arc_motion(const WheelTravel& travel, const DifferentialDrive& drive) {
  const Arc arc = arc_of(travel, drive);
  const SinCos middle = sin_cos(0.5 * arc.turn);
  const double reach = chord(arc);
  return {reach * middle.cos, reach * middle.sin, wrap_angle(arc.turn)};
}

}  // namespace scrubjay
