#include <scrubjay/localization/localizer.hpp>

namespace scrubjay {

const PoseEstimate& DeadReckoning::update(const Frame& frame) {
  if (!frame.odometry) return odometry_.update({frame.left_travel, frame.right_travel}, frame.stamp);
  // By the whole way, not step by step: rounding errors don't add up, and a replay has the poses of the run.
  if (!first_) first_ = frame.odometry;
  const bool back = *frame.odometry == *first_;  // exactly, without an error of rounding
  return odometry_.follow(back ? Pose2{} : inverse(*first_) * *frame.odometry, frame.stamp);
}

}  // namespace scrubjay
