/// \file
/// Notices a robot that can't free itself.
#pragma once

#include <scrubjay/geometry/pose2.hpp>
#include <scrubjay/robot/frame.hpp>

namespace scrubjay {

/// Our own choice: a strategy frees itself within seconds, a random one within a minute or so.
struct StuckParams {
  double patience = 120.0;  ///< held for this long at one place, it is stuck [s]
  double free_for = 2.0;    ///< ... unless nothing held it for this long [s]
  double place = 0.05;      ///< what counts as one place [m]
};

/// A robot is held while its bumper is pressed, a wheel hangs or a cliff is under it.
class StuckDetector {
 public:
  explicit StuckDetector(const StuckParams& params = {}) : params_(params) {}

  /// True once the robot has been held at one place for too long.
  bool update(const Frame& frame, const Pose2& pose) {
    const bool held = frame.bumped() || frame.wheel_dropped() || frame.cliff_flags != 0;
    if (held) held_stamp_ = frame.stamp;
    const bool free = frame.stamp - held_stamp_ >= params_.free_for;
    const bool elsewhere = (pose.position() - place_).squaredNorm() > params_.place * params_.place;
    if (!started_ || free || elsewhere) {
      started_ = true;
      place_ = pose.position();
      place_stamp_ = frame.stamp;
    }
    return frame.stamp - place_stamp_ >= params_.patience;
  }

 private:
  StuckParams params_;
  Point2 place_{0.0, 0.0};
  double place_stamp_ = 0.0;
  double held_stamp_ = 0.0;
  bool started_ = false;
};

}  // namespace scrubjay
