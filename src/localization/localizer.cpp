#include <scrubjay/localization/localizer.hpp>

namespace scrubjay {

const PoseEstimate& DeadReckoning::update(const Frame& frame) {
  if (!frame.odometry) return odometry_.update({frame.left_travel, frame.right_travel}, frame.stamp);
  // What stands still is not to creep by rounding errors.
  const bool stands = !last_odometry_ || *last_odometry_ == *frame.odometry;
  const Pose2 step = stands ? Pose2{} : inverse(*last_odometry_) * *frame.odometry;
  last_odometry_ = frame.odometry;
  return odometry_.advance(step, frame.stamp);
}

}  // namespace scrubjay
