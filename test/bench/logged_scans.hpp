/// \file
/// Scans and poses from logs of real robots, for benchmarks.
#pragma once

#include <benchmark/benchmark.h>

#include <cstdint>
#include <scrubjay/mapping/lidar_mapper.hpp>
#include <string>
#include <vector>

namespace scrubjay::bench {

struct LoggedScan {
  Pose2 pose;  ///< by the log's own SLAM
  LaserScan scan;
};

struct LoggedScans {
  RobotModel robot;
  std::vector<float> ranges;  ///< of all scans
  std::vector<LoggedScan> scans;

  std::int64_t beams() const { return static_cast<std::int64_t>(ranges.size()); }
};

inline constexpr const char* kIntel = "intel-corrected";
inline constexpr const char* kFreiburg = "freiburg-079-corrected";

/// A CARMEN log of ../shared/data, read once. If it isn't there, there are no scans, and the benchmark is skipped.
const LoggedScans& logged_scans(benchmark::State& state, const std::string& name);

/// All of a log's scans at its own poses: 5 cm, 20 m, and no disc of the robot, as peers know nothing of that.
LidarMapper map_of(const LoggedScans& log);

}  // namespace scrubjay::bench
