/// \file
/// Frames to a pose with covariance.
#pragma once

#include <optional>
#include <scrubjay/geometry/pose_estimate.hpp>
#include <scrubjay/odometry/odometry.hpp>
#include <scrubjay/robot/frame.hpp>

namespace scrubjay {

class Localizer {
 public:
  virtual ~Localizer() = default;
  /// The pose of `base_link` in `map` after this frame; valid until the next update.
  virtual const PoseEstimate& update(const Frame& frame) = 0;
};

/// Trusts the wheels alone, or the robot's own odometry where frames tell that.
class DeadReckoning final : public Localizer {
 public:
  explicit DeadReckoning(const DifferentialDrive& drive, const WheelNoise& noise = {}) : odometry_(drive, noise) {}

  const PoseEstimate& update(const Frame& frame) override;

 private:
  Odometry odometry_;
  std::optional<Pose2> first_;  ///< pose that the robot told
};

}  // namespace scrubjay
