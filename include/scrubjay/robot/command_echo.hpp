/// \file
/// Whether a robot heard what it was told.
#pragma once

#include <array>
#include <cstddef>

namespace scrubjay {

/// Compares the wheel speeds that a robot says it was asked for (OI packets 41 and 42) with those that it was told.
///
/// A command that lost a byte takes the next one's bytes for its own, and one that a flipped bit has turned into a list
/// swallows up to 255 bytes: the robot is deaf meanwhile and goes on as it was told before. Its echo tells.
class CommandEcho {
 public:
  /// The longest that an echo takes: both ways on a slow wire, a tick of the robot, a read [s].
  static constexpr double kDelay = 0.06;

  /// The robot was told these speeds [mm/s] at `stamp` [s].
  void tell(int left, int right, double stamp);
  /// A frame of `stamp` says that it was asked for these. True if they weren't in force any more for kDelay: the robot
  /// is deaf. Not said of a robot that never echoed anything, nor twice within kDelay.
  bool is_deaf(int left, int right, double stamp);

 private:
  struct Told {
    int left = 0;
    int right = 0;
    double since = 0.0;  // [s]
  };

  // As many as there are ticks in kDelay, and a few more.
  std::array<Told, 8> told_{};
  std::size_t count_ = 0;  // of those told, ever
  bool echoes_ = false;    // a motion came back once
  double said_ = 0.0;      // when it was found deaf last [s]
};

}  // namespace scrubjay
