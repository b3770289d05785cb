/// \file
/// Where frames come from and motions go to.
#pragma once

#include <optional>
#include <scrubjay/oi/command.hpp>
#include <scrubjay/robot/frame.hpp>
#include <scrubjay/robot/motion.hpp>

namespace scrubjay {

/// A robot: real, simulated or recorded.
class Robot {
 public:
  virtual ~Robot() = default;
  /// The next frame. A real robot blocks until it arrives, a simulated one advances its world by a tick, a recorded one
  /// reads on. None at the end: the recording is over, the link is lost.
  virtual std::optional<Frame> next() = 0;
  /// Drives like this until told otherwise.
  virtual void drive(const Motion& motion) = 0;
  /// Says this to a robot that speaks the Open Interface, besides what it is driven by: a song, lights, the way to its
  /// dock. False if it speaks no such thing.
  virtual bool order(const oi::Command&) { return false; }
  /// Stands still, and ends in a mode that charges.
  virtual void stop() = 0;
};

}  // namespace scrubjay
