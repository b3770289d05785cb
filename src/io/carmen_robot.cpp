#include <scrubjay/io/carmen_robot.hpp>

namespace scrubjay {

std::optional<Frame> CarmenRobot::next() {
  if (next_ >= log_.records.size()) return std::nullopt;
  const CarmenRecord& record = log_.records[next_++];
  Frame frame;
  frame.stamp = record.stamp;
  frame.odometry = record.odometry;
  if (!record.scan) return frame;
  LaserScan scan;
  scan.stamp = record.stamp;
  scan.angle_min = log_.lidar.angle_min;
  scan.angle_increment = log_.lidar.angle_increment;
  scan.range_min = log_.lidar.min_range;
  scan.range_max = log_.lidar.max_range;
  scan.ranges = log_.scan_ranges(*record.scan);
  frame.scan = scan;
  return frame;
}

RobotModel robot_of(const CarmenLog& log, double radius) {
  RobotModel model;
  model.open_interface = false;
  model.radius = radius;
  model.has_light_sensors = false;
  model.lidar = log.lidar;
  return model;
}

}  // namespace scrubjay
