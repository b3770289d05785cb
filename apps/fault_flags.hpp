/// \file
/// What is to be wrong with emulated robots, on the command line.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "emulated_robot.hpp"

namespace scrubjay::apps {

struct FaultFlags {
  double drop = 0.0;
  double flip = 0.0;
  double delay = 0.0;                  ///< [ms]
  std::optional<std::string> silence;  ///< EVERY,FOR [s]
  bool mode_off_by_one = false;
  int encoder_start = 0;
  bool asleep = false;
  double battery = 1.0;
  std::optional<std::string> lifted;       ///< FROM[,UNTIL] [s]
  std::vector<std::string> sticky_wheels;  ///< SIDE,FROM[,UNTIL] [s]
};

void add_fault_flags(CLI::App& command, FaultFlags& flags);
/// Throws Error, which names the flag and says what it wants.
EmulatedFaults make_faults(const FaultFlags& flags);

}  // namespace scrubjay::apps
