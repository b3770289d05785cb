/// \file
/// Knows when a robot that follows an edge has been once around it.
#pragma once

#include <algorithm>
#include <cmath>
#include <scrubjay/geometry/pose_estimate.hpp>

namespace scrubjay {

struct LoopClosureParams {
  double distance = 0.12;          ///< back at the start within this [m] ...
  double sigmas = 2.0;             ///< ... and this many standard deviations gained on the way
  double most_distance = 0.5;      ///< but never farther than this: other places look alike [m]
  double heading = radians(60.0);  ///< and looking the same way within this [rad]
  double min_length = 0.5;         ///< no edge is shorter around [m]
  double give_up_turns = 3.0;      ///< after so many whole turns it is closed whatever the pose says
};

/// A closed curve that doesn't cross itself turns by a full circle exactly (Hopf's Umlaufsatz): counter-clockwise
/// around a piece of furniture on the left, clockwise within a room. Being back at the start pose without that turn
/// closes nothing; more than several turns say that the pose has drifted and will never be back.
class LoopClosure {
 public:
  explicit LoopClosure(const LoopClosureParams& params = {}) : params_(params) {}

  void begin(const PoseEstimate& start) {
    start_ = start;
    last_ = start.pose;
    length_ = 0.0;
    turned_ = 0.0;
  }

  /// True once the loop is closed.
  bool update(const PoseEstimate& now) {
    length_ += (now.pose.position() - last_.position()).norm();
    turned_ += angle_difference(now.pose.yaw, last_.yaw);
    last_ = now.pose;
    const double turns = std::fabs(turned_) / (2.0 * kPi);
    if (turns >= params_.give_up_turns) return true;
    if (length_ < params_.min_length || std::fabs(turns - 1.0) > 0.25) return false;
    const double gained =
        now.covariance(0, 0) + now.covariance(1, 1) - start_.covariance(0, 0) - start_.covariance(1, 1);
    double reach = params_.distance + params_.sigmas * std::sqrt(std::max(0.0, gained));
    reach = std::min(reach, params_.most_distance);
    return (now.pose.position() - start_.pose.position()).squaredNorm() <= reach * reach &&
           std::fabs(angle_difference(now.pose.yaw, start_.pose.yaw)) <= params_.heading;
  }

  double length() const { return length_; }  ///< way since the start [m]
  double turned() const { return turned_; }  ///< counter-clockwise since the start [rad]

 private:
  LoopClosureParams params_;
  PoseEstimate start_;
  Pose2 last_;
  double length_ = 0.0;
  double turned_ = 0.0;
};

}  // namespace scrubjay
