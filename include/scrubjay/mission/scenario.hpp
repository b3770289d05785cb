/// \file
/// All that is needed to repeat a run.
#pragma once

#include <cstdint>
#include <optional>
#include <scrubjay/geometry/pose2.hpp>
#include <string>

namespace scrubjay {

struct Scenario {
  std::string world;                 ///< path of the world's file
  std::string model = "roomba-600";  ///< a known robot, or the path of a URDF file
  std::string strategy = "edge-follow";
  std::string noise = "none";  ///< a profile of noise.yaml
  std::uint64_t seed = 1;
  std::optional<Pose2> start;  ///< in the world's frame; otherwise the world's own, or its roomiest place
  double resolution = 0.05;    ///< of the map [m]
  double max_time = 7200.0;    ///< simulated [s]

  bool operator==(const Scenario&) const = default;
};

}  // namespace scrubjay
