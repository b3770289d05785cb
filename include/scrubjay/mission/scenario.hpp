/// \file
/// All that is needed to repeat a run.
#pragma once

#include <cstdint>
#include <optional>
#include <scrubjay/geometry/bounds.hpp>
#include <scrubjay/geometry/pose2.hpp>
#include <scrubjay/odometry/calibration.hpp>
#include <scrubjay/oi/model.hpp>
#include <string>

namespace scrubjay {

struct Scenario {
  std::string world;                 ///< path of the world's file
  std::string model = "roomba-600";  ///< a known robot, or the path of a URDF file
  std::string strategy;              ///< empty: what suits the model best
  std::string localizer;             ///< "odometry" or "scan-matching"; empty: what suits the model best
  std::string noise = "none";        ///< a profile of noise.yaml
  std::uint64_t seed = 1;
  std::optional<Pose2> start;              ///< in the world's frame; otherwise the world's own, or starting_pose()
  std::optional<Calibration> calibration;  ///< of the robot's wheels; otherwise they are believed to be the model's
  double resolution = 0.05;                ///< of the map [m]
  double max_time = 7200.0;                ///< simulated [s]
  std::optional<Bounds2> within;           ///< floor to stay on, in the map's frame
  bool return_home = false;                ///< drive back to the start once done
  bool motion_distortion = false;          ///< a lidar's beams are measured one after another while it moves
  std::optional<double> forward_cone;      ///< only beams this near to straight ahead are mapped [rad]
  std::optional<double> robot_radius;      ///< floor this near to the robot is mapped as free, with a lidar [m]
  std::optional<oi::Model> protocol;       ///< the dialect that a robot on a wire spoke; otherwise its model's
  bool mode_one_too_high = false;          ///< oi::FirmwareQuirks::mode_one_too_high of a robot on a wire

  bool operator==(const Scenario&) const = default;
};

}  // namespace scrubjay
