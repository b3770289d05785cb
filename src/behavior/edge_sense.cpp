#include <algorithm>
#include <scrubjay/behavior/edge_sense.hpp>

namespace scrubjay {
namespace {

bool any_cliff(const Frame& frame, CliffSensor a, CliffSensor b) {
  return (frame.cliff_flags >> static_cast<int>(a) & 1) != 0 || (frame.cliff_flags >> static_cast<int>(b) & 1) != 0;
}

}  // namespace

EdgeView edge_view(const Frame& frame, Side side, const RobotModel& robot, double point_range) {
  const bool left = side == Side::Left;
  const auto sensor = [&](std::size_t i) { return left ? i : frame.light_signal.size() - 1 - i; };
  const auto range = [&](std::size_t i) {
    return robot.has_light_sensors ? robot.light.range(frame.light_signal[sensor(i)]) : 10.0 * robot.light.max_range;
  };
  const bool touched_left = frame.bump_left || any_cliff(frame, CliffSensor::Left, CliffSensor::FrontLeft);
  const bool touched_right = frame.bump_right || any_cliff(frame, CliffSensor::Right, CliffSensor::FrontRight);

  EdgeView view;
  view.side = range(0);
  view.front_side = range(1);
  view.front = range(2);
  view.other_front = range(3);
  view.other_front_side = range(4);
  view.other_side = range(5);
  view.bump_side = left ? touched_left : touched_right;
  view.bump_other = left ? touched_right : touched_left;
  const double ranges[] = {view.side, view.front_side, view.front};
  for (std::size_t i = 0; i < 3; ++i) {
    if (ranges[i] > point_range) continue;
    const Pose2& mount = robot.light.mount[sensor(i)];
    view.point = mount * Point2(ranges[i], 0.0);
    break;
  }
  return view;
}

double obstacle_bearing(const Frame& frame, const RobotModel& robot) {
  const auto nearest = std::max_element(frame.light_signal.begin(), frame.light_signal.end());
  if (robot.has_light_sensors && robot.light.range(*nearest) < robot.light.max_range) {
    return robot.light.mount[static_cast<std::size_t>(nearest - frame.light_signal.begin())].yaw;
  }
  if (frame.bump_left == frame.bump_right) return 0.0;
  return frame.bump_left ? radians(45.0) : radians(-45.0);
}

Side nearer_side(const Frame& frame, Side preferred) {
  if (frame.bump_left != frame.bump_right) return frame.bump_left ? Side::Left : Side::Right;
  const auto& signal = frame.light_signal;
  const auto half = signal.size() / 2;
  const auto left = *std::max_element(signal.begin(), signal.begin() + half);
  const auto right = *std::max_element(signal.begin() + half, signal.end());
  if (left == right) return preferred;
  return left > right ? Side::Left : Side::Right;
}

}  // namespace scrubjay
