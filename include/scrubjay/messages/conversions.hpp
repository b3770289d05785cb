/// \file
/// What a robot senses and knows, as messages.
#pragma once

#include <scrubjay/geometry/pose_estimate.hpp>
#include <scrubjay/grid/cell_rect.hpp>
#include <scrubjay/grid/log_odds.hpp>
#include <scrubjay/messages/topics.hpp>
#include <scrubjay/robot/robot_model.hpp>
#include <span>

namespace scrubjay::ros {

/// The frames of REP-105, and where the lidar is.
struct FrameNames {
  std::string map = "map";
  std::string odom = "odom";
  std::string base = "base_link";
  std::string scan = "base_scan";
};

Quaternion quaternion(double yaw);
/// Turn about z of a rotation that may have others, too (the first of its Euler angles z-y-x) [rad].
double yaw_of(const Quaternion& q);
Pose pose_message(const Pose2& pose);
/// The plane's part of a pose.
Pose2 pose_of(const Pose& pose);
Transform transform_message(const Pose2& pose);
Pose2 pose_of(const Transform& transform);
TransformStamped transform_stamped(const Header& header, const std::string& child, const Pose2& pose);

/// Covariances of x, y and yaw stand in their places of the 6 x 6 matrix; what a robot on a floor can't do is certain.
Odometry odometry_message(const Header& header, const std::string& child, const PoseEstimate& estimate);
/// The scan, whose stamp is `header`'s. Ranges go over as they are (REP-117).
LaserScan scan_message(const Header& header, const scrubjay::LaserScan& scan);
Bumper bumper_message(const Header& header, const Frame& frame);
Cliff cliff_message(const Header& header, const Frame& frame);
BatteryState battery_message(const Header& header, const Battery& battery);

/// The part of a map that holds `cells`, all of them within it, in nav2's trinary values.
OccupancyGrid map_message(const Header& header, GridView<const LogOdds> map, const CellRect& cells);
/// The same cells of a map that was published with `published` as its `cells`.
OccupancyGridUpdate map_update_message(const Header& header, GridView<const LogOdds> map, const CellRect& published,
                                       const CellRect& cells);
Path path_message(const Header& header, std::span<const Point2> points);
Path path_message(const Header& header, std::span<const Pose2> poses);
/// One marker of points, which takes the place of the one before; with none of them, it takes that one away.
MarkerArray points_message(const Header& header, std::string_view name, std::span<const Point2> points, double size);

}  // namespace scrubjay::ros
