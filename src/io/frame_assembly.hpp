/// \file
/// Frames from messages that were measured at times of their own, and come in no order.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <scrubjay/robot/frame.hpp>
#include <variant>
#include <vector>

namespace scrubjay {

/// A scan and when it was measured, which its shape's own stamp needn't tell.
struct TimedScan {
  std::int64_t end = 0;         ///< of the last beam [ns]
  LaserScan shape{};            ///< without ranges
  std::vector<float> ranges{};  ///< [m]
};

struct BumperState {
  bool left = false;
  bool right = false;
  std::uint8_t light_flags = 0;                                 ///< as in Frame
  std::array<std::uint16_t, kLightSensorCount> light_signal{};  ///< as in Frame
};

struct CliffState {
  std::uint8_t flags = 0;  ///< as in Frame
};

/// Makes a frame of each odometry, and one more of each scan that ended between two of them, at the pose between.
///
/// Messages are put in the order of their stamps as far as they come within a second of odometry; a scan is told only
/// once it is over, and takes its time to be told. What comes later, or has no odometry around it, is left out; so is
/// an odometry whose stamp alone is a minute ahead, while a clock that was set ahead is followed.
class FrameAssembly {
 public:
  /// A frame, whose scan, if it has one, lacks its ranges: they are here.
  struct Made {
    Frame frame{};
    std::vector<float> ranges{};
  };

  void add_odometry(std::int64_t nanoseconds, const Pose2& pose);
  void add_scan(TimedScan scan);
  void add_touch(std::int64_t nanoseconds, const std::variant<BumperState, CliffState>& touch);
  /// No message comes any more.
  void finish() { finished_ = true; }

  /// The next frame that nothing that is still to come can change.
  std::optional<Made> next();
  /// Messages so far that are in no frame.
  std::size_t left_out() const { return left_out_; }

 private:
  struct Odometry {
    std::int64_t nanoseconds = 0;
    Pose2 pose;
  };
  struct Touch {
    std::int64_t nanoseconds = 0;
    std::variant<BumperState, CliffState> state;
  };
  Made make(std::int64_t nanoseconds, const Pose2& pose);
  void feel(std::int64_t until, Frame& frame);
  void take_scan(Made& made);
  std::optional<Made> scan_before(const Odometry& odometry);

  std::optional<Odometry> last_;  ///< that a frame was made of
  std::deque<Odometry> odometry_;
  std::optional<Odometry> ahead_;  ///< one with a stamp that the next one must confirm; counts as left out until then
  std::deque<TimedScan> scans_;
  std::deque<Touch> touches_;
  BumperState bumper_;
  CliffState cliff_;
  bool finished_ = false;
  std::size_t left_out_ = 0;
};

}  // namespace scrubjay
