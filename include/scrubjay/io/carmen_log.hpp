/// \file
/// Logs of CARMEN (the Carnegie Mellon Robot Navigation Toolkit): what a robot's wheels and its laser measured.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <scrubjay/geometry/pose2.hpp>
#include <scrubjay/geometry/stamped_pose.hpp>
#include <scrubjay/robot/robot_model.hpp>
#include <span>
#include <string>
#include <vector>

namespace scrubjay {

/// What a log says of one moment.
struct CarmenRecord {
  double stamp = 0.0;         ///< when it was measured; no later than the next one's [s]
  double logged_stamp = 0.0;  ///< as it stands in the file, which may be late [s]
  Pose2 pose;                 ///< by the log's own reference: as logged at a scan, carried on by the wheels after it
  Pose2 odometry;             ///< by the wheels alone, from the first scan on
  std::optional<std::size_t> scan;  ///< number of the scan that was taken then
};

/// A log from its first scan on.
///
/// Read are
/// - `FLASER n r1 ... rn x y theta odom_x odom_y odom_theta stamp host logger_stamp`, all with the same n;
/// - `ODOM x y theta tv rv accel stamp host logger_stamp`;
/// - `PARAM robot_frontlaser_offset`, `robot_front_laser_max`, `laser_front_laser_resolution` [deg],
///
/// and all else is left out. The pose columns of a raw log hold the wheels' odometry or a live localization. In a log
/// that was *corrected* by SLAM they hold its poses, and each scan is followed by an ODOM record that puts the odometry
/// back to that pose, so that later ones go on from there. Either way the motion between two scans is known: from that
/// anchor to the last ODOM record before the next scan, or else between the two scans' odometry columns.
struct CarmenLog {
  std::string name;  ///< of the file
  /// Of the front laser. Poses are the laser's own, so its mount is the identity. n beams that aren't told otherwise
  /// span 180 degrees from -90 on: 180 and 360 without the last bearing, 181 and 361 with it (CARMEN, GMapping).
  LidarModel lidar;
  double laser_offset = 0.0;          ///< of the laser ahead of the wheels' axle [m]
  std::vector<CarmenRecord> records;  ///< in the order of the file; the first one is a scan's
  std::vector<std::size_t> scans;     ///< the record of each scan
  std::vector<float> ranges;          ///< of all scans one after another, lidar.beams each [m]
  std::size_t late = 0;  ///< records whose stamp was later than that of one behind them, and is that one's now

  std::span<const float> scan_ranges(std::size_t scan) const {
    const auto beams = static_cast<std::size_t>(lidar.beams);
    return std::span(ranges).subspan(scan * beams, beams);
  }
  /// From the first record to the last [s].
  double duration() const { return records.back().stamp - records.front().stamp; }
};

/// Reads a log, plain or packed with gzip. Throws Error with file, line and field; also for poses beyond kWorldExtent
/// and stamps beyond 1e11 s, and if it holds no FLASER record.
CarmenLog read_carmen_log(const std::filesystem::path& path);
/// The same from memory; `name` stands in the errors.
CarmenLog parse_carmen_log(std::span<const std::uint8_t> file, const std::string& name);

/// The log's own poses, of every record.
std::vector<StampedPose> logged_poses(const CarmenLog& log);

/// Poses of a log's first records, one each, at the stamps in the file and in their order: what others who worked on
/// the same log mean by a time, such as the relations of a benchmark.
std::vector<StampedPose> at_logged_stamps(const CarmenLog& log, std::span<const StampedPose> poses);

}  // namespace scrubjay
