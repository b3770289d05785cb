/// \file
/// One simulated run over a bad wire, and what was true of it.
#pragma once

#include <cstdint>
#include <scrubjay/mission/mission.hpp>
#include <scrubjay/simulation/noise.hpp>
#include <scrubjay/simulation/wire_faults.hpp>
#include <scrubjay/world/score.hpp>
#include <scrubjay/world/segment_index.hpp>
#include <scrubjay/world/world.hpp>
#include <string>

namespace scrubjay::reliability {

/// A world with all that runs in it share.
struct Scenery {
  /// Reads a world's file. Throws Error.
  explicit Scenery(const std::string& file);

  std::string name;
  World world;
  SegmentIndex index;
  Pose2 start;
  GroundTruth truth;
};

struct RunSetting {
  const Scenery* scenery = nullptr;
  std::string strategy{};
  sim::NoiseProfile noise{};
  sim::WireFaults faults{};
  std::uint64_t seed = 1;
  double time = 120.0;  ///< simulated [s]
};

/// What became of it. Times in [s], lengths in [m].
struct RunOutcome {
  Ended ended = Ended::RobotGone;
  bool stands = false;        ///< stands in Passive afterwards
  double distance = 0.0;      ///< driven, in truth
  double stale_motion = 0.0;  ///< longest that wheels obeyed speeds not told again, while the wire carried bytes
  double cut_motion = 0.0;    ///< the same by the clock, whether the wire carried bytes or not

  std::uint64_t due = 0;           ///< ticks of the robot from the first frame that came to the last
  std::uint64_t sent = 0;          ///< whole frames sent in them
  std::uint64_t received = 0;      ///< ... that came as they were sent
  std::uint64_t false_frames = 0;  ///< that pass as frames, and weren't sent so
  std::uint64_t counted = 0;       ///< lost frames, as the client counts them

  std::uint64_t foreign_commands = 0;  ///< that the robot understood, and nobody gave
  std::uint64_t refused_commands = 0;  ///< that the robot couldn't make sense of
  std::uint64_t rejected_values = 0;   ///< that the client didn't believe
  std::uint64_t deafnesses = 0;        ///< times that the client found the robot deaf
  std::uint64_t silences = 0;          ///< that the client noticed ...
  std::uint64_t reconnections = 0;     ///< ... and overcame
  double longest_silence = 0.0;
  sim::WireFaultCounters wire{};

  double map_error = 0.0;       ///< mean distance of the map's occupied cells from the nearest true wall
  double position_error = 0.0;  ///< root mean square over the run
  double coverage = 0.0;        ///< of the reachable floor
};

/// The same setting gives the same outcome.
RunOutcome run(const RunSetting& setting);

}  // namespace scrubjay::reliability
