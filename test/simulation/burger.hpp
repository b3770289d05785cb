/// \file
/// A TurtleBot3 Burger in a small world.
#pragma once

#include <scrubjay/io/robot_file.hpp>
#include <scrubjay/simulation/simulated_turtlebot.hpp>
#include <utility>

#include "stage.hpp"

namespace scrubjay::test {

/// World, index and robot, which refer to each other.
class Burger {
 public:
  static constexpr double kTick = sim::SimulatedTurtlebot::kTick;

  explicit Burger(World scenery, const Pose2& start = {}, const sim::NoiseProfile& noise = {}, std::uint64_t seed = 1,
                  const sim::TurtlebotOptions& options = {})
      : world(std::move(scenery)),
        index(solid_segments(world)),
        robot(world, index, spec(), noise, Random(seed), start, options) {}
  Burger(const Burger&) = delete;
  Burger& operator=(const Burger&) = delete;

  static const sim::RobotSpec& spec() {
    static const sim::RobotSpec burger =
        read_robot(std::filesystem::path(SCRUBJAY_SOURCE_DIR) / "urdf/turtlebot3_burger.urdf");
    return burger;
  }
  static const LidarModel& lidar() { return *spec().model.lidar; }
  static sim::NoiseProfile noise(std::string_view profile) {
    return read_noise(std::filesystem::path(SCRUBJAY_SOURCE_DIR) / "urdf/noise.yaml", profile);
  }

  /// Drives like this for about `seconds`; the last frame.
  Frame drive(const Motion& motion, double seconds) {
    robot.drive(motion);
    for (auto i = std::lround(seconds / kTick); i > 1; --i) robot.next();
    return *robot.next();
  }
  /// Goes on until a scan is there.
  LaserScan scan() {
    while (true) {
      const std::optional<Frame> frame = robot.next();
      if (frame->scan) return *frame->scan;
    }
  }
  const Pose2& pose() const { return robot.truth().pose; }

  World world;
  SegmentIndex index;
  sim::SimulatedTurtlebot robot;
};

}  // namespace scrubjay::test
