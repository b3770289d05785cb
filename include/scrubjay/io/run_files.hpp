/// \file
/// The folder that a run leaves behind.
#pragma once

#include <filesystem>
#include <optional>
#include <scrubjay/geometry/stamped_pose.hpp>
#include <scrubjay/io/serial_robot.hpp>
#include <scrubjay/mapping/occupancy_grid.hpp>
#include <scrubjay/mission/mission.hpp>
#include <scrubjay/mission/scenario.hpp>
#include <scrubjay/world/relation_error.hpp>
#include <scrubjay/world/score.hpp>
#include <scrubjay/world/trajectory_error.hpp>
#include <scrubjay/world/world.hpp>
#include <string>
#include <vector>

namespace scrubjay {

/// What is known of a run only where its world is known.
struct RunTruth {
  Pose2 start;                  ///< the map frame's origin in the world's frame
  std::vector<Segment2> walls;  ///< in the map's frame
  std::optional<Pose2> dock;    ///< in the map's frame
  MapScore score;
  std::uint64_t contacts = 0;           ///< times that the robot touched something, whether it felt that or not
  std::vector<StampedPose> trajectory;  ///< true poses in the map's frame; empty for a replay
  TrajectoryError error;
};

/// What a run from a robot's log is compared with. Nobody knows the truth there.
struct LogReference {
  std::string log;                      ///< its name
  std::string poses;                    ///< where the run's poses came from: "log", "odometry", "scan-matching"
  std::vector<StampedPose> trajectory;  ///< the log's own poses in the map's frame, at the times of the estimated ones
  TrajectoryError error;                ///< against them
  std::optional<RelationError> relations;
};

struct RunResult {
  Scenario scenario;
  Report report;
  OccupancyGrid map;
  std::vector<StampedPose> trajectory;  ///< estimated poses
  std::vector<Pose2> bumps;             ///< estimated poses at bumps
  double robot_radius = 0.0;            ///< [m]
  bool has_bumper = true;
  std::optional<RunTruth> truth;
  std::optional<LogReference> reference;  ///< of a log; such a run has no scenario
  std::optional<LinkReport> link;         ///< of a robot on a wire
  double wall_time = 0.0;                 ///< by the clock [s]
  double cpu_time = 0.0;                  ///< [s]
};

/// What metrics.json holds: everything that is the same for the same scenario.
std::string metrics_json(const RunResult& run);

/// Writes map.pgm and map.yaml, map.png, trajectory.tum, ground_truth.tum (where there is truth), metrics.json,
/// timing.json and scenario.yaml (for a log: reference.tum), each whole or not at all, and none before there was room
/// for all: a disc that is full leaves an older run's files as they were. Makes the folder if need be. Throws Error
/// (Kind::Failure).
void write_run(const std::filesystem::path& folder, const RunResult& run);

/// The walls of a world, seen from `start`.
std::vector<Segment2> walls_in_map(const World& world, const Pose2& start);

}  // namespace scrubjay
