/// \file
/// Emulated robots in one world, tick by tick.
#pragma once

#include <deque>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "emulated_robot.hpp"

namespace scrubjay::apps {

/// Robots that see and block each other, in turn: the same for the same bytes from their clients at the same ticks.
class Emulation {
 public:
  /// Robots behind `link`, or behind LINK0, LINK1 ... if there are several: the first where the stage's start is, the
  /// others around it. Throws Error if there is no room for so many, or a link can't be made.
  Emulation(const Stage& stage, std::size_t count, const EmulatedFaults& faults, std::uint64_t seed,
            const std::filesystem::path& link);

  void tick();
  void pulse_brc(std::size_t robot) { robots_[robot].pulse_brc(); }
  double now() const { return robots_.front().now(); }
  const std::deque<EmulatedRobot>& robots() const { return robots_; }

 private:
  double radius_;
  std::deque<EmulatedRobot> robots_;
  std::vector<sim::Disc> others_;
};

}  // namespace scrubjay::apps
