/// \file
/// A simulated robot behind a pseudo-terminal, and the account of what really happened to it.
#pragma once

#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <scrubjay/io/pseudo_terminal.hpp>
#include <scrubjay/simulation/simulated_roomba.hpp>
#include <scrubjay/simulation/wire_faults.hpp>
#include <vector>

#include "simulated_run.hpp"

namespace scrubjay::apps {

/// What is wrong with a robot and its wire.
struct EmulatedFaults {
  sim::WireFaults wire;
  sim::FirmwareOptions firmware;
  sim::RobotFaults body;
};

class EmulatedRobot {
 public:
  /// `stage` must outlive it. `random` is the run's generator, of which robot `number` takes its own streams. Throws
  /// Error if `link` can't be made.
  EmulatedRobot(const Stage& stage, const Pose2& start, std::size_t number, const EmulatedFaults& faults,
                const Random& random, const std::filesystem::path& link);

  /// One tick: takes what the client sent, as much as the wire carries in that time, and sends what is due.
  void tick();
  void place_others(std::span<const sim::Disc> others) { roomba_.place_others(others); }
  void pulse_brc() { roomba_.pulse_brc(); }

  double now() const { return roomba_.now(); }
  const sim::Truth& truth() const { return roomba_.truth(); }
  const PseudoTerminal& terminal() const { return terminal_; }
  const std::filesystem::path& link() const { return link_; }

  /// Where it is and what it does, as a line of the live account.
  nlohmann::ordered_json now_json() const;
  /// The account of the whole run.
  nlohmann::ordered_json account() const;

 private:
  void look();

  sim::SimulatedRoomba roomba_;
  sim::FaultyChannel wire_;
  std::filesystem::path link_;
  PseudoTerminal terminal_;
  std::size_t number_;
  std::size_t bytes_per_tick_;
  Pose2 start_;
  double last_yaw_;
  double turned_ = 0.0;                        // counter-clockwise, less what it turned back [rad]
  std::array<std::uint64_t, 4> mode_ticks_{};  // by mode
  sim::Indicators shown_;                      // as it was lit last
  std::uint64_t received_ = 0;                 // bytes
  std::uint64_t sent_ = 0;
  std::vector<std::uint8_t> buffer_;
};

}  // namespace scrubjay::apps
