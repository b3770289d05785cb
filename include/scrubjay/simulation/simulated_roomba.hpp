/// \file
/// A whole simulated Roomba behind a byte channel.
#pragma once

#include <scrubjay/robot/byte_channel.hpp>
#include <scrubjay/simulation/firmware.hpp>
#include <scrubjay/simulation/roomba_body.hpp>
#include <vector>

namespace scrubjay::sim {

/// Body, firmware and a loopback wire in lockstep: a read that finds nothing to read advances the world by one tick.
/// Whatever client sits on the other end, it meets the same bytes as on a serial port, as fast as it can read.
class SimulatedRoomba final : public ByteChannel {
 public:
  /// `world` and `index` must outlive it.
  SimulatedRoomba(const World& world, const SegmentIndex& index, const RobotSpec& spec, const NoiseProfile& noise,
                  const Random& random, const Pose2& start, const FirmwareOptions& options = {},
                  const RobotFaults& faults = {});

  ByteRead read(std::span<std::uint8_t> buffer) override;
  bool write(std::span<const std::uint8_t> bytes) override;

  /// Somebody carries it to `pose`.
  void place(const Pose2& pose) { body_.place(pose); }
  /// Where other robots are now.
  void place_others(std::span<const Disc> others) { body_.place_others(others); }
  /// Its BRC pin is pulled low for a moment.
  void pulse_brc() { firmware_.pulse_brc(); }
  const Truth& truth() const { return body_.truth(); }
  const Firmware& firmware() const { return firmware_; }
  /// Simulated time [s]: whole milliseconds divided once, so that it is the double that a recording gives back.
  double now() const { return static_cast<double>(15 * truth().ticks) / 1000.0; }

 private:
  RoombaBody body_;
  Firmware firmware_;
  std::vector<std::uint8_t> wire_;  // from the robot, not yet read
  std::size_t read_ = 0;            // of it
};

}  // namespace scrubjay::sim
