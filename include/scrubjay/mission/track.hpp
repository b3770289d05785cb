/// \file
/// Where a robot went and where it bumped, as it believes.
#pragma once

#include <scrubjay/geometry/stamped_pose.hpp>
#include <scrubjay/mission/observer.hpp>
#include <vector>

namespace scrubjay {

/// Keeps ten poses a second unless told otherwise, and every bump.
class Track final : public Observer {
 public:
  static constexpr double kInterval = 0.1;  ///< [s]

  /// `interval`: the least time between two poses [s]; 0 keeps every frame's.
  explicit Track(double interval = kInterval) : interval_(interval) {}

  void notify(const Snapshot& now) override {
    if (points_.empty() || now.frame.stamp - points_.back().stamp >= interval_ - 1e-9) {
      points_.push_back({now.frame.stamp, now.estimate.pose});
    }
    if (now.frame.bumped() && !was_bumped_) bumps_.push_back(now.estimate.pose);
    was_bumped_ = now.frame.bumped();
  }

  const std::vector<StampedPose>& points() const { return points_; }
  const std::vector<Pose2>& bumps() const { return bumps_; }  ///< poses of the robot when it bumped

 private:
  double interval_;
  std::vector<StampedPose> points_;
  std::vector<Pose2> bumps_;
  bool was_bumped_ = false;
};

}  // namespace scrubjay
