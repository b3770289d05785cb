/// \file
/// Measures what is on the other end of a byte channel, without ever moving it.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <scrubjay/oi/model.hpp>
#include <scrubjay/oi/query.hpp>
#include <scrubjay/oi/quirks.hpp>
#include <scrubjay/oi/sensors.hpp>
#include <scrubjay/oi/stream_parser.hpp>
#include <scrubjay/robot/byte_channel.hpp>
#include <stop_token>
#include <string>
#include <vector>

namespace scrubjay {

/// What a packet said over a while.
struct PacketHistory {
  std::int32_t least = 0;
  std::int32_t most = 0;
  std::int32_t always = 0;  ///< bits that were set in every frame
  std::int32_t ever = 0;    ///< bits that were set in any frame
};

/// Times from a query written to the last byte of its answer [s].
struct ReplyTimes {
  int asked = 0;
  int answered = 0;
  double median = 0.0;
  double p95 = 0.0;  ///< 95 of 100 answers were as fast as this
};

/// What came in while the robot told all that it senses.
struct FrameCount {
  double seconds = 0.0;           ///< from the first frame to the end of listening
  std::uint64_t frames = 0;       ///< whole ones
  std::uint64_t missing = 0;      ///< that should have come in that time, one every 15 ms, and didn't
  std::uint64_t damaged = 0;      ///< of those: came with a wrong checksum or length
  std::uint64_t stray_bytes = 0;  ///< that belong to no whole frame
  std::uint64_t bad_values = 0;   ///< out of their packet's range, in whole frames
  double longest_gap = 0.0;       ///< between two frames [s]

  double per_second() const { return seconds > 0.0 ? static_cast<double>(frames - 1) / seconds : 0.0; }
};

/// Who answers.
enum class Contact : std::uint8_t {
  Silent,   ///< nobody: not a byte came
  Foreign,  ///< somebody, but it is no Open Interface at this rate
  Robot,
};

/// All that was measured. What wasn't is as it is here.
struct DoctorReport {
  Contact contact = Contact::Silent;
  oi::Model model = oi::Model::Create2;  ///< by the longest list of packets that it answers to
  std::optional<oi::Release> release;    ///< as its banner says
  std::string banner;                    ///< what it printed when it started anew, printable characters and line breaks
  std::optional<oi::OiMode> mode;        ///< none on a Roomba 400, which doesn't tell
  oi::FirmwareQuirks quirks;             ///< those of the release, and those seen
  oi::Sensors sensors;                   ///< all values as they were last
  std::array<PacketHistory, oi::kLastPacket + 1> history{};  ///< by packet number, over `frames`
  ReplyTimes replies;
  FrameCount frames;
  bool link_lost = false;  ///< the channel ended
};

/// Examines a robot step by step. It only asks and listens: the robot stays in Passive mode, which drives nothing and
/// charges, and is left there, with its stream stopped.
class Examination {
 public:
  using Clock = std::function<double()>;
  /// Looks at all values after each frame; false ends the listening.
  using Look = std::function<bool(const oi::Sensors& sensors, double stamp)>;

  /// `now`: the clock of the channel's stamps [s]. The channel must outlive this. Once `stop` is requested, each step
  /// ends within a tick or two, with what it has.
  Examination(ByteChannel& channel, Clock now, std::stop_token stop = {});
  Examination(const Examination&) = delete;
  Examination& operator=(const Examination&) = delete;
  ~Examination();

  /// Wakes the interface and asks in each dialect, the richest first. Takes 2 s at most, a tenth with a good wire.
  Contact find_robot();
  /// Starts the robot anew and reads the banner in which some name their firmware: some 5 s; 1.5 s
  /// on a robot that pays no heed. False if the robot doesn't answer any more.
  bool read_banner();
  /// Asks for ten bytes, again and again.
  void time_replies(int count = 60);
  /// Has all packets streamed (asks for them, on a robot that can't stream) for so long [s], and keeps count.
  void listen(double seconds, const Look& look = {});
  /// The same without keeping count: what a user does to the robot meanwhile says nothing of its health.
  void watch(double seconds, const Look& look);

  const DoctorReport& report() const { return report_; }

 private:
  bool send(const oi::Command& command);
  void quieten();
  std::optional<double> ask(oi::SensorId id, oi::Model model);
  bool answers(oi::Model model);
  oi::Model richest(oi::Model model);
  void hear(double seconds, const Look& look);
  void take_frame(double stamp, std::uint16_t rejected);
  void end_listening(double stamp);
  void count_losses(const oi::StreamParser::Counters& counters);
  void listen_to_stream(double seconds, const Look& look);
  void listen_by_asking(double seconds, const Look& look);
  bool going_on() const { return !report_.link_lost && !stop_.stop_requested(); }

  ByteChannel& channel_;
  Clock now_;
  std::stop_token stop_;
  DoctorReport report_;
  std::size_t heard_ = 0;  // bytes, ever
  bool counting_ = false;  // frames, and what they say
  bool any_frame_ = false;
  double first_frame_ = 0.0;
  double last_frame_ = 0.0;
};

}  // namespace scrubjay
