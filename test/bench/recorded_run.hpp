/// \file
/// A run of the whole loop, kept tick by tick, so that each of its steps can be played again alone.
#pragma once

#include <scrubjay/geometry/pose_estimate.hpp>
#include <scrubjay/robot/byte_channel.hpp>
#include <scrubjay/robot/frame.hpp>
#include <scrubjay/robot/motion.hpp>
#include <scrubjay/simulation/body_senses.hpp>
#include <string>
#include <vector>

#include "stage.hpp"

namespace scrubjay::bench {

/// What went from each step to the next in one tick.
struct RecordedTick {
  std::vector<std::uint8_t> commands;  ///< that the firmware received since the tick before
  sim::WheelSpeeds wanted;
  sim::BodySenses senses;
  std::vector<std::uint8_t> stream;  ///< that it sent
  Frame frame;
  PoseEstimate estimate;
  Motion motion;
};

struct RecordedRun {
  std::string strategy;
  std::string profile;
  Stage stage;
  std::vector<RecordedTick> ticks;
};

inline constexpr double kRecordedTime = 600.0;  ///< simulated [s]

/// The first ten minutes of a strategy in a house; recorded when it is asked for first.
const RecordedRun& recorded_run(const std::string& strategy, const std::string& profile, int rooms = kHouse);

// The steps, each played over the whole run with what it got then.
void play_body(const RecordedRun& run);
void play_firmware(const RecordedRun& run);  ///< decodes commands, encodes frames
void play_oi_robot(const RecordedRun& run);  ///< parses and decodes frames, encodes commands
void play_odometry(const RecordedRun& run);
void play_mapper(const RecordedRun& run);
/// The map is to be what it was at each tick, so the mapper runs along: what it costs is to be taken off.
void play_mapper_and_behavior(const RecordedRun& run);

/// CPU time of this thread [s].
double thread_cpu_time();

}  // namespace scrubjay::bench
