/// \file
/// A Roomba on the other end of a byte channel.
#pragma once

#include <array>
#include <scrubjay/odometry/encoder.hpp>
#include <scrubjay/oi/command.hpp>
#include <scrubjay/oi/query.hpp>
#include <scrubjay/oi/quirks.hpp>
#include <scrubjay/oi/sensors.hpp>
#include <scrubjay/oi/stream_parser.hpp>
#include <scrubjay/robot/byte_channel.hpp>
#include <scrubjay/robot/robot.hpp>
#include <scrubjay/robot/robot_model.hpp>

namespace scrubjay {

/// How the link to a robot is.
enum class LinkState : std::uint8_t {
  Alive,
  Silent,  ///< open, but no frame came for OiRobot::kSilence
  Closed,  ///< the channel has ended
};

/// Speaks the Open Interface: streams all packets from robots that can stream, asks for them every tick where they
/// can't (Roomba 400), and drives by wheel speeds (by radius on a Roomba 400).
///
/// Safe mode is taken up again whenever the robot has fallen back to Passive and stands on its wheels.
class OiRobot final : public Robot {
 public:
  static constexpr double kSilence = 0.1;  ///< without a frame for this long the robot counts as silent [s]

  /// Wakes the robot, takes control and starts the stream. The channel must outlive it.
  OiRobot(ByteChannel& channel, const RobotModel& model, const oi::FirmwareQuirks& quirks = {});

  std::optional<Frame> next() override;
  void drive(const Motion& motion) override;
  void stop() override;

  /// Why next() gave none.
  LinkState link() const { return link_; }
  const oi::StreamParser::Counters& counters() const { return parser_.counters(); }
  /// Values out of their packet's range so far, none of which was taken.
  std::uint64_t rejected_values() const { return rejected_values_; }
  /// All values as the robot gave them last.
  const oi::Sensors& sensors() const { return sensors_; }

 private:
  static constexpr std::size_t kReadSize = 512;
  static constexpr std::size_t kMaxFrames = kReadSize / 30 + 2;  // the shortest frame that is asked for has 56 bytes

  bool streams() const { return model_.protocol != oi::Model::Roomba400; }
  bool send(const oi::Command& command);
  void ask(double stamp);
  bool receive();
  void take_reply(std::span<const std::uint8_t> bytes, double stamp);
  void arrive(const oi::DecodeStatus& status, double stamp);
  Frame make_frame(double stamp);
  void read_travel(Frame& frame);
  void keep_mode(const Frame& frame);

  ByteChannel& channel_;
  RobotModel model_;
  oi::FirmwareQuirks quirks_;
  oi::StreamParser parser_;
  oi::QueryReader reply_;
  oi::Sensors sensors_;
  Encoder left_encoder_;
  Encoder right_encoder_;
  LinkState link_ = LinkState::Alive;
  bool started_ = false;
  bool measures_ = false;         // distance and angle were read before
  double asked_stamp_ = 0.0;      // of the last query
  double last_stamp_ = 0.0;       // of the last frame
  double mode_sent_stamp_ = 0.0;  // of the last attempt to take control again
  int left_speed_ = 0;            // as commanded last [mm/s]
  int right_speed_ = 0;
  std::uint64_t rejected_values_ = 0;
  std::array<Frame, kMaxFrames> frames_;  // decoded, not yet handed on
  std::size_t frame_count_ = 0;
  std::size_t next_frame_ = 0;
};

}  // namespace scrubjay
