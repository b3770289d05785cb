/// \file
/// How many frames of a stream are missing.
#pragma once

#include <cstdint>

namespace scrubjay {

/// Counts the frames that were due and didn't come, whatever became of them: hit on the wire, swallowed by a silence,
/// or never sent. It follows the robot's tick (a phase-locked loop over the times of arrival), so that frames that come
/// late or in bursts aren't missed, and a clock that runs a little otherwise than ours doesn't add up.
class FrameTally {
 public:
  static constexpr double kTick = 0.015;  ///< nominal time between two frames [s] (OI specification, "Stream")

  /// A whole frame came at `stamp` [s]. Stamps don't fall.
  void arrive(double stamp);
  std::uint64_t arrived() const { return arrived_; }
  /// Frames missing between the first and the last that came. While frames are late it may count one or two that still
  /// come, and takes them off again.
  std::uint64_t lost() const;

 private:
  std::uint64_t arrived_ = 0;
  std::int64_t ticks_ = 0;  // from the first frame to the last
  double due_ = 0.0;        // when the last one was [s]
  double period_ = kTick;   // as this robot keeps it [s]
};

}  // namespace scrubjay
