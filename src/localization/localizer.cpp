#include <scrubjay/localization/localizer.hpp>

namespace scrubjay {

const PoseEstimate& DeadReckoning::update(const Frame& frame) {
  return odometry_.update({frame.left_travel, frame.right_travel}, frame.stamp);
}

}  // namespace scrubjay
