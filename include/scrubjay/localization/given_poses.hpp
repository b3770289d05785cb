/// \file
/// Poses that somebody else found.
#pragma once

#include <scrubjay/geometry/stamped_pose.hpp>
#include <scrubjay/localization/localizer.hpp>
#include <vector>

namespace scrubjay {

/// Takes each frame's pose from a list, by its stamp, and believes it: the covariance is zero.
class GivenPoses final : public Localizer {
 public:
  /// `poses` in the order of their stamps, one or more; the map's frame is theirs.
  explicit GivenPoses(std::vector<StampedPose> poses);

  /// Between two stamps the robot moves evenly from one pose to the next; before the first it stands there, and after
  /// the last. Frames in the order of their stamps: those with the stamp of several poses take them one after another.
  const PoseEstimate& update(const Frame& frame) override;

 private:
  std::vector<StampedPose> poses_;
  std::size_t next_ = 0;  ///< the first one that no frame has reached
  PoseEstimate estimate_;
};

}  // namespace scrubjay
