#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <scrubjay/error.hpp>
#include <scrubjay/io/carmen_log.hpp>
#include <scrubjay/io/world_reader.hpp>

#include "file_content.hpp"
#include "gzip.hpp"
#include "text_lines.hpp"

namespace scrubjay {
namespace {

/// An ODOM record.
struct LoggedOdometry {
  double stamp = 0.0;
  Pose2 pose;
};

/// A FLASER record, and the ODOM records up to the next one.
struct LoggedScan {
  double stamp = 0.0;
  Pose2 pose;
  Pose2 odometry;      ///< that the ODOM records go on from
  bool reset = false;  ///< it was put back to `pose` after the scan
  std::vector<LoggedOdometry> after;
};

constexpr double kMostTurned = 1e5;    // summed up over a log [rad]
constexpr double kLatestStamp = 1e11;  // [s]; those that count from 1970 stand at 1e9 to 2e9

/// The next word as a number from -limit to limit.
double bounded(TextLine& line, std::string_view what, double limit) {
  const double value = line.number(what);
  if (std::fabs(value) <= limit) return value;
  line.fail_field(fmt::format("{} is {:g}; want {:g} to {:g}", what, value, -limit, limit));
}

Pose2 read_pose(TextLine& line, std::string_view prefix) {
  const double x = bounded(line, fmt::format("{}x", prefix), kWorldExtent);
  const double y = bounded(line, fmt::format("{}y", prefix), kWorldExtent);
  return {x, y, wrap_angle(bounded(line, fmt::format("{}theta", prefix), kMostTurned))};
}

double read_stamp(TextLine& line) {
  return bounded(line, "stamp", kLatestStamp);
}

/// Takes the lines of a log apart.
class LogReader {
 public:
  void add(TextLine& line);
  CarmenLog finish(const std::string& name);

 private:
  void add_scan(TextLine& line);
  void add_odometry(TextLine& line);
  void add_parameter(TextLine& line);
  LidarModel lidar() const;

  std::vector<LoggedScan> scans_;
  std::vector<float> ranges_;
  int beams_ = 0;
  bool after_scan_ = false;  ///< the record before this one was a scan
  double laser_offset_ = 0.0;
  double max_range_ = 80.0;           ///< SICK LMS 200, data sheet; what it can't measure it tells as 81.83 or so
  std::optional<double> resolution_;  ///< between two beams [deg]
};

void LogReader::add(TextLine& line) {
  const std::string_view kind = line.word();
  if (kind == "FLASER") {
    add_scan(line);
  } else if (kind == "ODOM") {
    add_odometry(line);
  } else if (kind == "PARAM") {
    add_parameter(line);
  }
  after_scan_ = kind == "FLASER";
}

void LogReader::add_scan(TextLine& line) {
  const int beams = line.count("number of readings");
  if (beams < 2) line.fail(fmt::format("FLASER of {} readings; want 2 or more", beams));
  if (!scans_.empty() && beams != beams_) {
    line.fail(fmt::format("FLASER of {} readings; want {}, as in the scans before", beams, beams_));
  }
  beams_ = beams;
  constexpr double kFar = 1e6;  // [m], and well within what a float holds
  for (int i = 0; i < beams; ++i) ranges_.push_back(static_cast<float>(std::clamp(line.number("range"), -kFar, kFar)));
  LoggedScan scan;
  scan.pose = read_pose(line, "");
  scan.odometry = read_pose(line, "odom_");
  scan.stamp = read_stamp(line);
  scans_.push_back(scan);
}

void LogReader::add_odometry(TextLine& line) {
  if (scans_.empty()) return;
  const Pose2 pose = read_pose(line, "");
  LoggedScan& scan = scans_.back();
  if (after_scan_ && pose == scan.pose) {
    // Its other columns are what happened to be in memory.
    scan.odometry = pose;
    scan.reset = true;
    return;
  }
  for (const std::string_view speed : {"tv", "rv", "accel"}) line.number(speed);
  scan.after.push_back({read_stamp(line), pose});
}

void LogReader::add_parameter(TextLine& line) {
  const std::string_view name = line.word();
  if (name == "robot_frontlaser_offset") laser_offset_ = bounded(line, name, kWorldExtent);
  if (name == "robot_front_laser_max") {
    max_range_ = line.number(name);
    if (max_range_ <= 0.0) line.fail(fmt::format("{} is {}; want a positive length", name, max_range_));
  }
  if (name == "laser_front_laser_resolution") {
    resolution_ = line.number(name);
    if (*resolution_ <= 0.0) line.fail(fmt::format("{} is {}; want a positive angle", name, *resolution_));
  }
}

LidarModel LogReader::lidar() const {
  LidarModel model;
  model.mount = {};
  model.beams = beams_;
  model.angle_min = radians(-90.0);
  model.angle_increment = radians(resolution_.value_or(180.0 / (beams_ - beams_ % 2)));
  model.scan_time = 0.0;
  model.min_range = 0.01;  // 0 is no range
  model.max_range = max_range_;
  model.clear_range = 0.0;  // no return: far away, or black, or a mirror
  model.noise = 0.02;       // logs tell no data sheet; lasers of their time are good to 1 or 2 cm, far and near
  model.noise_per_range = 0.0;
  return model;
}

/// What stands before a record in the file was measured before it, though some loggers write a stamp that is late.
void correct_late_stamps(CarmenLog& log) {
  for (std::size_t i = log.records.size() - 1; i > 0; --i) {
    const double next = log.records[i].stamp;
    if (log.records[i - 1].stamp <= next) continue;
    log.records[i - 1].stamp = next;
    ++log.late;
  }
}

CarmenLog LogReader::finish(const std::string& name) {
  if (scans_.empty()) throw Error(fmt::format("{}: no FLASER record; want a CARMEN log with scans", name));
  CarmenLog log;
  log.name = name;
  log.lidar = lidar();
  log.laser_offset = laser_offset_;
  log.ranges = std::move(ranges_);
  Pose2 by_wheels;
  for (std::size_t i = 0; i < scans_.size(); ++i) {
    const LoggedScan& scan = scans_[i];
    const LoggedScan* next = i + 1 < scans_.size() ? &scans_[i + 1] : nullptr;
    log.scans.push_back(log.records.size());
    log.records.push_back({scan.stamp, scan.stamp, scan.pose, by_wheels, i});
    for (const LoggedOdometry& odometry : scan.after) {
      if (next != nullptr && &odometry == &scan.after.back() && odometry.stamp >= next->stamp) break;
      const Pose2 motion = inverse(scan.odometry) * odometry.pose;
      log.records.push_back({odometry.stamp, odometry.stamp, scan.pose * motion, by_wheels * motion, std::nullopt});
    }
    if (next == nullptr) break;
    const Pose2 there = !scan.reset ? next->odometry : scan.after.empty() ? scan.odometry : scan.after.back().pose;
    by_wheels = by_wheels * (inverse(scan.odometry) * there);
  }
  correct_late_stamps(log);
  return log;
}

}  // namespace

CarmenLog parse_carmen_log(std::span<const std::uint8_t> file, const std::string& name) {
  const std::string text = unpacked(file, name);
  TextLines lines(text, name);
  LogReader reader;
  while (auto line = lines.next()) reader.add(*line);
  return reader.finish(name);
}

CarmenLog read_carmen_log(const std::filesystem::path& path) {
  return parse_carmen_log(read_file(path), path.string());
}

std::vector<StampedPose> logged_poses(const CarmenLog& log) {
  std::vector<StampedPose> poses;
  poses.reserve(log.records.size());
  for (const CarmenRecord& record : log.records) poses.push_back({record.stamp, record.pose});
  return poses;
}

std::vector<StampedPose> at_logged_stamps(const CarmenLog& log, std::span<const StampedPose> poses) {
  std::vector<StampedPose> stamped;
  stamped.reserve(poses.size());
  for (std::size_t i = 0; i < std::min(poses.size(), log.records.size()); ++i) {
    stamped.push_back({log.records[i].logged_stamp, poses[i].pose});
  }
  std::ranges::stable_sort(stamped, {}, &StampedPose::stamp);
  return stamped;
}

}  // namespace scrubjay
