/// \file
/// A laser scan as beams in the robot's frame.
#pragma once

#include <limits>
#include <scrubjay/geometry/pose2.hpp>
#include <scrubjay/robot/robot_model.hpp>
#include <span>
#include <vector>

namespace scrubjay {

/// What one beam says, in the robot's frame at the time of the frame that brought the scan.
struct Beam {
  Point2 origin{0.0, 0.0};  ///< where the sensor was when the beam was measured [m]
  Point2 end{0.0, 0.0};     ///< [m]
  bool hit = false;         ///< something stands at the end; else the way there is clear, and no more is known
};

/// Which beams are used, and how far.
struct ScanPointsParams {
  /// Returns from farther away are beams that are clear up to here [m].
  double max_range = std::numeric_limits<double>::infinity();
  double forward_cone = kPi;  ///< only beams within this of straight ahead, either way, are used [rad]
  double hit_depth = 0.0;     ///< a hit's end is put this much farther away than it was measured [m]
};

/// Works out a lidar's beams, scan by scan. Bearings are computed once, and again only when the scans change shape.
///
/// After REP-117, a range that is NaN, negative, or shorter than the sensor measures says nothing; one that is longer
/// than it measures, or 0 (as LDS-01 tells it), is a beam without return: clear up to LidarModel::clear_range.
///
/// Of a scan that was measured while the robot moved (`time_increment` > 0), every beam starts from where the sensor
/// was then, if the robot moved at `twist` all the while.
class ScanPoints {
 public:
  explicit ScanPoints(const LidarModel& lidar, const ScanPointsParams& params = {}) : lidar_(lidar), params_(params) {}

  /// The beams that say something, in the scan's order; valid until the next call. `stamp` is that of the frame that
  /// brought the scan, `twist` the robot's at that time. Throws Error if the scan needs a twist that isn't finite.
  std::span<const Beam> beams(const LaserScan& scan, double stamp, const Twist2& twist);

 private:
  struct Bearing {
    std::size_t beam;  // place in the scan
    Point2 direction;  // in the robot's frame
  };

  void learn_bearings(const LaserScan& scan);
  void deskew(const LaserScan& scan, double stamp, const Twist2& twist);

  LidarModel lidar_;
  ScanPointsParams params_;
  std::vector<Bearing> bearings_;  // of the beams in the forward cone, for scans of the shape below
  double angle_min_ = 0.0;
  double angle_increment_ = 0.0;
  std::size_t count_ = 0;
  std::vector<Beam> beams_;
  std::vector<std::size_t> places_;  // of each of beams_ in the scan
};

}  // namespace scrubjay
