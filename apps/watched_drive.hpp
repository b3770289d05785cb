/// \file
/// A robot that is driven by keys, as others see it: with a pose and a map.
#pragma once

#include <scrubjay/mission/estimation.hpp>
#include <scrubjay/mission/mission.hpp>

#include "publishing.hpp"

namespace scrubjay::apps {

/// There is no mission, as nobody decides anything: what others are told of one is put together here.
class WatchedDrive {
 public:
  /// `publishing` must outlive it. Throws Error for what the scenario's model can't do.
  WatchedDrive(const Scenario& scenario, const RobotModel& robot, Publishing& publishing, RunTime time)
      : estimation_(make_estimation(scenario, robot)),
        publishing_(publishing),
        others_(publishing.begin(scenario, robot, time)) {}

  /// To be told of every frame, and of what the robot does then.
  void see(const Frame& frame, const Motion& motion) {
    const PoseEstimate& estimate = estimation_.localizer->update(frame);
    estimation_.mapper->update(frame, estimate);
    const Decision decision{motion, "driven by keys"};
    others_.notify({frame, estimate, estimation_.mapper->map(), decision, estimation_.mapper->changed()});
    if (report_.frames++ == 0) began_ = frame.stamp;
    report_.time = frame.stamp - began_;
    report_.bumps += frame.bumped() && !was_bumped_;
    was_bumped_ = frame.bumped();
  }
  /// `driven`: so far [m].
  void end(Ended ended, double driven) {
    report_.ended = ended;
    report_.distance = driven;
    publishing_.finish(estimation_.mapper->map(), report_);
  }

 private:
  Estimation estimation_;
  Publishing& publishing_;
  Observer& others_;
  Report report_;
  double began_ = 0.0;  // stamp of the first frame [s]
  bool was_bumped_ = false;
};

}  // namespace scrubjay::apps
