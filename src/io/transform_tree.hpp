/// \file
/// Where the frames of a robot are on it, as its transforms tell.
#pragma once

#include <Eigen/Geometry>
#include <map>
#include <optional>
#include <scrubjay/geometry/pose2.hpp>
#include <scrubjay/messages/geometry_msgs.hpp>
#include <string>
#include <string_view>

namespace scrubjay {

/// A frame's name without the `/` that ROS 1 put before it.
std::string plain_frame(std::string_view name);
/// `odom` of `robot1/odom`.
std::string_view last_name(std::string_view name);

/// A pose in the plane that x and y span, whatever the tilt; none if it isn't finite, or has no orientation.
std::optional<Pose2> in_plane(const ros::Point& position, const ros::Quaternion& orientation);

class TransformTree {
 public:
  /// What isn't finite, or has no rotation, is left out.
  void add(const ros::TransformStamped& transform);
  /// Pose of `frame` on the frame `base`, or on the nearest base_link or base_footprint below it if it isn't fixed to
  /// `base`; none if that isn't told.
  std::optional<Eigen::Isometry3d> on(std::string_view base, std::string_view frame) const;

 private:
  struct Link {
    std::string parent;
    Eigen::Isometry3d pose;  ///< of the child on it
  };
  std::map<std::string, Link, std::less<>> links_;  ///< by child
};

}  // namespace scrubjay
