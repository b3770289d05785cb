/// \file
/// Messages of a bag as what frames are made of.
#pragma once

#include <optional>
#include <scrubjay/io/bag.hpp>
#include <scrubjay/messages/cdr.hpp>
#include <scrubjay/messages/create_msgs.hpp>
#include <scrubjay/messages/nav_msgs.hpp>
#include <scrubjay/messages/sensor_msgs.hpp>
#include <scrubjay/robot/robot_model.hpp>

#include "frame_assembly.hpp"

namespace scrubjay {

/// When a message was measured, or else recorded [ns].
std::int64_t stamp_of(const ros::Header& header, const BagMessage& message);

/// The pose that an odometry tells; none beyond kWorldExtent, or if it is no pose.
std::optional<Pose2> pose_of(const ros::Odometry& odometry);
std::optional<Pose2> pose_of(const ros::TransformStamped& transform);

/// Whether its shape makes sense: two beams or more, and numbers that a lidar can have.
bool is_sound(const ros::LaserScan& scan);
/// The lidar that makes such scans, in the robot's middle.
LidarModel lidar_of(const ros::LaserScan& scan);
/// `upside_down`: bearings run the other way.
TimedScan scan_of(ros::LaserScan scan, std::int64_t nanoseconds, bool upside_down);

BumperState bumper_of(const ros::Bumper& bumper);
CliffState cliff_of(const ros::Cliff& cliff);

}  // namespace scrubjay
