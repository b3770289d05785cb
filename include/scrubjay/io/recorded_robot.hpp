/// \file
/// A robot whose frames come from a recording, whoever talked to it.
#pragma once

#include <cstdint>
#include <deque>
#include <scrubjay/io/recording.hpp>
#include <scrubjay/oi/command_decoder.hpp>
#include <scrubjay/oi/query.hpp>
#include <scrubjay/oi/quirks.hpp>
#include <scrubjay/oi/stream_parser.hpp>
#include <scrubjay/robot/frame_maker.hpp>
#include <scrubjay/robot/robot.hpp>
#include <span>

namespace scrubjay {

/// Follows what the client asked for, since only that tells what the robot's bytes mean: a stream of any list, or
/// replies to queries. A frame for each stream frame and for each whole reply; it goes where it went, whatever it is
/// told.
///
/// A client that asks for packets one by one gets frames that know of one more each; wheels travel in those that bring
/// encoder counts, or distance and angle.
class RecordedRobot final : public Robot {
 public:
  /// `reader` must outlive it.
  RecordedRobot(RecordingReader& reader, const RobotModel& model, const oi::FirmwareQuirks& quirks = {});

  std::optional<Frame> next() override;
  void drive(const Motion&) override {}
  void stop() override {}

 private:
  struct Asked {
    oi::Command query;
    double stamp = 0.0;  // [s]
  };

  void heed(const oi::Command& command, double stamp);
  void take(std::span<const std::uint8_t> bytes, double stamp);
  std::span<const std::uint8_t> take_reply(std::span<const std::uint8_t> bytes, double stamp);
  bool await_next();
  void forget_way();
  void add_frame(double stamp);

  RecordingReader& reader_;
  RobotModel model_;
  oi::CommandDecoder commands_;
  oi::StreamParser stream_;
  oi::QueryReader reply_;
  bool streaming_ = false;
  std::deque<Asked> asked_;  // not yet answered, but for the one that reply_ awaits
  double asked_stamp_ = 0.0;
  oi::Sensors sensors_;
  FrameMaker frame_maker_;
  ToldSpeeds told_;
  double last_stamp_ = 0.0;  // of the last frame [s]
  std::deque<Frame> frames_;
};

}  // namespace scrubjay
