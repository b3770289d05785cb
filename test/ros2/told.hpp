/// \file
/// What others tell a robot, as messages.
#pragma once

#include <scrubjay/messages/cdr.hpp>
#include <scrubjay/messages/conversions.hpp>

namespace scrubjay::ros {

inline Bytes told_velocity(double linear, double angular) {
  Twist message;
  message.linear.x = linear;
  message.angular.z = angular;
  return encode(message);
}

inline Bytes told_goal(const Pose2& pose) {
  PoseStamped message;
  message.header.frame_id = "map";
  message.pose = pose_message(pose);
  return encode(message);
}

inline Bytes told_place(const Pose2& pose) {
  PoseWithCovarianceStamped message;
  message.header.frame_id = "map";
  message.pose.pose = pose_message(pose);
  return encode(message);
}

}  // namespace scrubjay::ros
