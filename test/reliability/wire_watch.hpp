/// \file
/// Who looks at both ends of a wire, and knows what was sent, what came, and what the robot made of it.
#pragma once

#include <cstdint>
#include <deque>
#include <scrubjay/oi/command_decoder.hpp>
#include <scrubjay/oi/stream_parser.hpp>
#include <scrubjay/robot/byte_channel.hpp>
#include <scrubjay/simulation/simulated_roomba.hpp>
#include <scrubjay/simulation/wire_faults.hpp>
#include <vector>

namespace scrubjay::reliability {

inline constexpr std::uint8_t kFramePayload = 81;  ///< of group 100 alone

/// The robot's end: which frames it sends, and for how long its wheels obey what.
class RobotEnd final : public ByteChannel {
 public:
  struct Sent {
    std::vector<std::uint8_t> payload;
    std::uint64_t tick = 0;
    std::uint64_t number = 0;  ///< from 1 on
  };

  explicit RobotEnd(sim::SimulatedRoomba& roomba) : roomba_(roomba) {}
  /// The wire between the two ends, whose silences count.
  void watch(const sim::FaultyChannel& wire) { wire_ = &wire; }

  ByteRead read(std::span<std::uint8_t> buffer) override;
  bool write(std::span<const std::uint8_t> bytes) override;

  /// The client has just sent these wheel speeds [m/s].
  void told(const sim::WheelSpeeds& speeds);

  /// Frames of the last second.
  const std::deque<Sent>& sent() const { return sent_; }
  /// Commands that nobody gave.
  std::uint64_t foreign_commands() const { return foreign_commands_; }
  /// Longest that wheels obeyed speeds that weren't told again, while the wire carried bytes [s].
  double stale_motion() const { return stale_motion_; }
  /// The same by the clock, silences of the wire included [s].
  double cut_motion() const { return cut_motion_; }

 private:
  struct Told {
    sim::WheelSpeeds speeds{};
    double stamp = 0.0;    ///< [s]
    double carried = 0.0;  ///< time for which the wire had carried bytes [s]
  };

  void look_at_wheels();
  bool is_foreign(const oi::Command& command) const;

  sim::SimulatedRoomba& roomba_;
  const sim::FaultyChannel* wire_ = nullptr;
  oi::StreamParser parser_{oi::Model::Create2, kFramePayload};
  oi::CommandDecoder decoder_{oi::Model::Create2};
  std::deque<Sent> sent_;
  std::uint64_t sent_count_ = 0;
  std::deque<Told> told_;
  Told obeyed_;           // what the wheels obey, and since when
  double carried_ = 0.0;  // [s]
  std::uint64_t foreign_commands_ = 0;
  double stale_motion_ = 0.0;
  double cut_motion_ = 0.0;
};

/// The client's end: which frames came as they were sent.
class ClientEnd final : public ByteChannel {
 public:
  ClientEnd(ByteChannel& wire, RobotEnd& robot) : wire_(wire), robot_(robot) {}

  ByteRead read(std::span<std::uint8_t> buffer) override;
  bool write(std::span<const std::uint8_t> bytes) override;

  std::uint64_t received() const { return received_; }
  /// That pass as frames, and weren't sent so.
  std::uint64_t false_frames() const { return false_frames_; }
  /// Ticks of the robot from the first frame that came to the last.
  std::uint64_t due() const { return received_ == 0 ? 0 : last_.tick - first_.tick + 1; }
  /// Frames that the robot sent in them.
  std::uint64_t sent() const { return received_ == 0 ? 0 : last_.number - first_.number + 1; }

 private:
  void arrive(std::span<const std::uint8_t> payload);

  ByteChannel& wire_;
  RobotEnd& robot_;
  oi::StreamParser parser_{oi::Model::Create2, kFramePayload};
  oi::CommandDecoder decoder_{oi::Model::Create2};
  std::uint64_t received_ = 0;
  std::uint64_t false_frames_ = 0;
  RobotEnd::Sent first_;
  RobotEnd::Sent last_;
};

}  // namespace scrubjay::reliability
