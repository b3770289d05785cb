/// \file
/// From decoded sensor values to frames.
#pragma once

#include <scrubjay/odometry/encoder.hpp>
#include <scrubjay/oi/quirks.hpp>
#include <scrubjay/oi/sensors.hpp>
#include <scrubjay/robot/frame.hpp>
#include <scrubjay/robot/robot_model.hpp>

namespace scrubjay {

/// Speeds of the two wheels [m/s].
struct ToldSpeeds {
  double left = 0.0;
  double right = 0.0;
};

/// Makes a frame of each reading of a robot's sensors, with the wheels' travel since the one before.
///
/// A step that no wheel can have made counts as none. After a silence that is as long as a restart takes, the robot's
/// counters may have begun anew, and only a step counts that fits what the wheels were told before it.
class FrameMaker {
 public:
  explicit FrameMaker(const RobotModel& model, const oi::FirmwareQuirks& quirks = {})
      : model_(model), quirks_(quirks) {}

  /// Of a reading at `stamp` [s], `elapsed` after the one before [s]; `told` before that. Distance and angle must be
  /// those since the reading before.
  Frame make(const oi::Sensors& sensors, double stamp, double elapsed, const ToldSpeeds& told);

 private:
  /// Of an encoder, since the reading before.
  struct CountedStep {
    double way = 0.0;  ///< [m]
    bool believed = true;
  };

  void count_encoders(Frame& frame, const oi::Sensors& sensors, double elapsed, const ToldSpeeds& told);
  void measure(Frame& frame, const oi::Sensors& sensors, double elapsed, const ToldSpeeds& told);
  void note_gap(double elapsed);
  bool credible(double travel, double elapsed, double told) const;
  double believe(double step, CountedStep& before, double elapsed, double told) const;

  RobotModel model_;
  oi::FirmwareQuirks quirks_;
  Encoder left_encoder_;
  Encoder right_encoder_;
  bool begun_ = false;  // there was a reading before
  CountedStep left_before_;
  CountedStep right_before_;
  double gap_ = 0.0;        // without frames, that ended lately [s]
  double since_gap_ = 0.0;  // ... so long ago [s]
};

}  // namespace scrubjay
