/// \file
/// A Roomba on the other end of a byte channel.
#pragma once

#include <array>
#include <scrubjay/oi/command.hpp>
#include <scrubjay/oi/query.hpp>
#include <scrubjay/oi/quirks.hpp>
#include <scrubjay/oi/sensors.hpp>
#include <scrubjay/oi/stream_parser.hpp>
#include <scrubjay/robot/byte_channel.hpp>
#include <scrubjay/robot/command_echo.hpp>
#include <scrubjay/robot/frame_maker.hpp>
#include <scrubjay/robot/frame_tally.hpp>
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
/// Safe mode is taken up again whenever the robot has fallen back to Passive and stands on its wheels. A motion is told
/// again every other tick, and where the robot's echo shows that it is deaf, it is fed zeros until it hears: a byte
/// that is lost on the way costs little. A robot that falls silent is told to stand, again and again.
class OiRobot final : public Robot {
 public:
  /// Without a frame for this long the robot counts as silent [s]: five ticks. A read sees it when it ends, and may
  /// have begun just before: with reads of 20 ms at most, as SerialPort's, it is noticed within 95 ms.
  static constexpr double kSilence = 0.075;

  /// What for. One that listens takes no control and never changes the robot's mode: it takes the stream that runs, or
  /// asks a Roomba 400 for sensors. Only restart() asks for a stream; one that was switched off meanwhile stays silent.
  enum class Session : std::uint8_t { Drive, Listen };

  /// Wakes the robot, takes control and starts the stream, unless it only listens. The channel must outlive it.
  OiRobot(ByteChannel& channel, const RobotModel& model, const oi::FirmwareQuirks& quirks = {},
          Session session = Session::Drive);

  /// None when the robot is silent or the channel has ended: link() says which. A silent one may be asked again.
  std::optional<Frame> next() override;
  /// The next frame of what the channel has by now: reads from it at most once, and gives none if that completes none.
  /// For channels that don't wait, as firmware's.
  std::optional<Frame> poll();
  /// Nothing, in a session that listens.
  void drive(const Motion& motion) override;
  /// One that has it drive by itself (Seek Dock, Clean, Spot, Max) is left alone with it, through silences too, until a
  /// motion is wanted again, or Safe or Full mode; and is told again if its mode shows that it didn't hear. False in a
  /// session that listens, and if the channel has ended.
  bool order(const oi::Command& command) override;
  void stop() override;
  /// After stop(): reads on until the robot says that it is Passive, for `patience` [s] by the channel's stamps at
  /// most, and tells it again meanwhile. False if it never said so; a Roomba 400 tells no mode.
  bool confirm_stop(double patience);

  /// Takes the session up again with a robot that fell silent, and that may have been started anew. Its way goes on
  /// from where it was. One that drives by itself is only asked for frames, the first time in a silence; then it is
  /// started, and told again what it was ordered.
  void restart();
  /// Tells the robot to stand, whatever it was told before; the next motion is told in any case.
  void halt();

  /// Why next() gave none.
  LinkState link() const { return link_; }
  /// Of the last read [s].
  double stamp() const { return stamp_; }
  const oi::StreamParser::Counters& counters() const { return parser_.counters(); }
  /// Frames that were due and didn't come, from the first one to the last; replies, from a robot that is asked.
  std::uint64_t lost_frames() const { return streams() ? frame_tally_.lost() : lost_replies_; }
  /// Times that the robot was deaf to what it was told.
  std::uint64_t deafnesses() const { return deafnesses_; }
  /// Values out of their packet's range so far, none of which was taken.
  std::uint64_t rejected_values() const { return rejected_values_; }
  /// All values as the robot gave them last.
  const oi::Sensors& sensors() const { return sensors_; }

 private:
  static constexpr std::size_t kReadSize = 512;
  static constexpr std::size_t kMaxFrames = kReadSize / 30 + 2;  // the shortest frame that is asked for has 56 bytes

  bool streams() const { return model_.protocol != oi::Model::Roomba400; }
  bool listens() const { return session_ == Session::Listen; }
  void begin_session();
  void take_control();
  void want_frames();
  bool send(const oi::Command& command);
  void tell(int left, int right);
  void flush();
  void ask(double stamp);
  bool receive();
  void fall_silent();
  void take_reply(std::span<const std::uint8_t> bytes, double stamp);
  void arrive(const oi::DecodeStatus& status, double stamp);
  void keep_mode(const Frame& frame);
  void heal_deafness(const Frame& frame);

  ByteChannel& channel_;
  RobotModel model_;
  Session session_;
  oi::StreamParser parser_;
  oi::QueryReader reply_;
  oi::Sensors sensors_;
  FrameMaker frame_maker_;
  FrameTally frame_tally_;
  CommandEcho echo_;
  LinkState link_ = LinkState::Alive;
  bool started_ = false;
  bool keeps_mode_ = true;        // takes control again where it was lost
  bool restarted_ = false;        // since the last frame
  bool driven_ = false;           // told to move since it was stopped
  double stamp_ = 0.0;            // of the last read
  double asked_stamp_ = 0.0;      // of the last query
  double last_stamp_ = 0.0;       // of the last frame
  double mode_sent_stamp_ = 0.0;  // of the last attempt to take control again
  double told_stamp_ = 0.0;       // when a motion was told last
  int left_speed_ = 0;            // as told last [mm/s]
  int right_speed_ = 0;
  ToldSpeeds wanted_;                      // by the last motion
  std::optional<oi::Command> own_errand_;  // that it drives by itself for
  std::uint64_t lost_replies_ = 0;
  std::uint64_t deafnesses_ = 0;
  std::uint64_t rejected_values_ = 0;
  std::array<Frame, kMaxFrames> frames_;  // decoded, not yet handed on
  std::size_t frame_count_ = 0;
  std::size_t next_frame_ = 0;
};

}  // namespace scrubjay
