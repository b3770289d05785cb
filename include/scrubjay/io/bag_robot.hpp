/// \file
/// A robot whose frames come from a bag: ours, or anybody's.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <scrubjay/robot/robot.hpp>
#include <scrubjay/robot/robot_model.hpp>
#include <string>

namespace scrubjay {

/// What of a bag frames are made from, and what it tells of the robot. Topics are empty where there is none.
struct BagSenses {
  std::string odometry;  ///< of nav_msgs/msg/Odometry; else of tf2_msgs/msg/TFMessage, with transforms of an odom frame
  std::string scan;      ///< of sensor_msgs/msg/LaserScan
  std::string bumper;    ///< of create_msgs/msg/Bumper
  std::string cliff;     ///< of create_msgs/msg/Cliff
  std::string base;      ///< the robot's frame, as base_footprint; empty if the odometry doesn't tell
  /// By the first scan. What scans don't tell is as for any lidar: a beam without a return says nothing.
  std::optional<LidarModel> lidar;
  bool mount_known = false;  ///< by the transforms; else the lidar is taken to be in the robot's middle
  bool upside_down = false;  ///< the lidar hangs: its bearings run the other way
  std::string description;   ///< the robot's URDF, by a topic robot_description; empty if there is none
};

/// Looks through a bag for them, by type and by a topic's last name: of several topics of a type, the one called scan,
/// odom, bumper or cliff. Without scans, the robot must have a bumper.
///
/// `robot_namespace`, as /robot1, tells which of several robots is wanted; empty for any. Throws Error that names what
/// is missing, or what there are several of, and what the bag has instead.
BagSenses find_senses(const std::filesystem::path& bag, std::string_view robot_namespace = "");

/// The robot `body` as far as nothing is told of it, with the lidar of the bag. A lidar that `body` has keeps what
/// scans don't tell: its noise, and how far a beam without a return is clear.
RobotModel robot_of(const BagSenses& senses, const RobotModel& body);

/// A frame an odometry, with the scan that was over by then, or a frame of its own for a scan that ended between two of
/// them; bumps, light signals and cliffs as they were told since the frame before. Stamps are those at which things
/// were measured (`header.stamp`), or recorded where a message has none. The robot goes where it went, whatever it is
/// told.
class BagRobot final : public Robot {
 public:
  /// `senses` as found in that bag. Throws Error if it can't be read.
  BagRobot(const std::filesystem::path& bag, const BagSenses& senses);
  BagRobot(const BagRobot&) = delete;
  BagRobot& operator=(const BagRobot&) = delete;
  ~BagRobot() override;

  std::optional<Frame> next() override;
  void drive(const Motion&) override {}
  void stop() override {}

  /// Once next() gave none: whether the bag is cut or damaged, see BagReader.
  bool cut() const;
  /// Messages of its topics so far that are in no frame: damaged, with impossible values, behind their time, or scans
  /// without odometry around them.
  std::size_t left_out() const;

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace scrubjay
