#include <cassert>
#include <scrubjay/localization/given_poses.hpp>
#include <utility>

namespace scrubjay {
namespace {

/// `at` lies between the two stamps, which differ.
Pose2 between(const StampedPose& a, const StampedPose& b, double at) {
  const double share = (at - a.stamp) / (b.stamp - a.stamp);
  return {a.pose.x + share * (b.pose.x - a.pose.x), a.pose.y + share * (b.pose.y - a.pose.y),
          wrap_angle(a.pose.yaw + share * angle_difference(b.pose.yaw, a.pose.yaw))};
}

/// The speed at which a body goes from one to the next, in its own frame.
Twist2 twist_between(const StampedPose& a, const StampedPose& b) {
  const double interval = b.stamp - a.stamp;
  if (interval <= 0.0) return {};
  const Pose2 motion = inverse(a.pose) * b.pose;
  return {motion.x / interval, motion.y / interval, motion.yaw / interval};
}

}  // namespace

GivenPoses::GivenPoses(std::vector<StampedPose> poses) : poses_(std::move(poses)) {
  assert(!poses_.empty());
}

const PoseEstimate& GivenPoses::update(const Frame& frame) {
  // Exactly one pose of several with this stamp; all of those before it.
  while (next_ < poses_.size() && poses_[next_].stamp < frame.stamp) ++next_;
  const bool exact = next_ < poses_.size() && poses_[next_].stamp == frame.stamp;
  if (exact) ++next_;
  if (next_ == 0) {
    estimate_.pose = poses_.front().pose;
    return estimate_;
  }
  const StampedPose& last = poses_[next_ - 1];
  if (exact || next_ == poses_.size()) {
    estimate_.pose = last.pose;
    estimate_.twist = next_ < 2 ? Twist2{} : twist_between(poses_[next_ - 2], last);
    return estimate_;
  }
  estimate_.pose = between(last, poses_[next_], frame.stamp);
  estimate_.twist = twist_between(last, poses_[next_]);
  return estimate_;
}

}  // namespace scrubjay
