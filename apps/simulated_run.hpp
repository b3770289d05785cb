/// \file
/// A scenario as a simulated robot in a world, and the mission that it drives.
#pragma once

#include <filesystem>
#include <optional>
#include <scrubjay/io/run_files.hpp>
#include <scrubjay/mission/mission.hpp>
#include <scrubjay/mission/scenario.hpp>
#include <scrubjay/mission/strategies.hpp>
#include <scrubjay/simulation/noise.hpp>
#include <scrubjay/simulation/robot_spec.hpp>
#include <scrubjay/world/segment_index.hpp>
#include <scrubjay/world/world.hpp>
#include <stop_token>

namespace scrubjay::apps {

class Publishing;
class Steering;

/// What runs read and share: a world with its index, a robot, a noise profile.
struct Stage {
  World world;
  SegmentIndex index;
  sim::RobotSpec robot;
  sim::NoiseProfile noise;
  Pose2 start;  ///< in the world's frame
};

/// Reads all that the scenario names. Throws Error; also if the robot doesn't fit where it is to start.
Stage set_stage(const Scenario& scenario);

/// What there is to find out about a stage, in cells of `resolution`. To be asked for before the run: it throws Error
/// if the resolution is none for this world and this robot, which no run should be wasted on.
GroundTruth truth_of(const Stage& stage, double resolution);

/// What a scenario's strategy is made for. A replay makes the same one.
StrategySetting strategy_setting(const Scenario& scenario, const RobotModel& robot);

struct RunOptions {
  double speed = 0.0;                           ///< times real time; 0 is as fast as possible
  std::optional<std::filesystem::path> record;  ///< where to record the bytes
  Observer* onlooker = nullptr;                 ///< somebody who looks on; may be nobody
  Publishing* publishing = nullptr;             ///< tells others; may be nobody
  Steering* steering = nullptr;                 ///< in place of the scenario's strategy, if anybody
};

/// Runs the scenario on its stage, and scores it. The same scenario gives the same result, but for the times it took.
RunResult run_simulated(const Scenario& scenario, const Stage& stage, const GroundTruth& truth,
                        const RunOptions& options, const std::stop_token& stop);

/// Scores a map against the world that it is of, and keeps what a picture needs of it.
RunTruth compare_with_truth(const Stage& stage, const GroundTruth& truth, GridView<const Occupancy> map,
                            std::span<const StampedPose> trajectory);

}  // namespace scrubjay::apps
