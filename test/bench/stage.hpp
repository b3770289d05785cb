/// \file
/// Houses and robots that benchmarks share.
#pragma once

#include <scrubjay/io/robot_file.hpp>
#include <scrubjay/simulation/noise.hpp>
#include <scrubjay/world/score.hpp>
#include <scrubjay/world/segment_index.hpp>
#include <string>
#include <world/generated.hpp>

namespace scrubjay::bench {

inline constexpr int kHouse = 5;    ///< rooms a side: 200 segments in 20 x 20 m, half of them walls
inline constexpr int kEstate = 40;  ///< rooms a side: 12,800 segments in 160 x 160 m

inline World make_world(int rooms) {
  Random random(1);
  return test::random_house(random, rooms, 4.0);
}

/// A house of `rooms` x `rooms` rooms, and a place in its first room to start from.
struct Stage {
  explicit Stage(int rooms)
      : world(make_world(rooms)), index(solid_segments(world)), start(starting_pose(make_world(1), 0.1735)) {}

  World world;
  SegmentIndex index;
  Pose2 start;
};

/// "none", "hard-floor" or "carpet".
inline sim::NoiseProfile noise(const std::string& profile) {
  return read_noise(SCRUBJAY_SOURCE_DIR "/urdf/noise.yaml", profile);
}

}  // namespace scrubjay::bench
