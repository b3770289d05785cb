/// \file
/// Keeps a lidar's pose by laying each scan over the map so far.
#pragma once

#include <scrubjay/localization/correlative_search.hpp>
#include <scrubjay/localization/likelihood_field.hpp>
#include <scrubjay/localization/localizer.hpp>
#include <scrubjay/localization/pose_filter.hpp>
#include <scrubjay/localization/scan_alignment.hpp>
#include <scrubjay/localization/straight_walls.hpp>
#include <scrubjay/localization/surface_map.hpp>
#include <scrubjay/localization/wall_compass.hpp>
#include <scrubjay/mapping/mapper.hpp>
#include <scrubjay/mapping/scan_points.hpp>
#include <scrubjay/robot/robot_model.hpp>

namespace scrubjay {

/// Our own choices, tried on the worlds of this repository with an LDS-01 and on the logs of Intel's lab and of
/// Freiburg's building 079 with a SICK LMS.
struct ScanMatchingParams {
  double window = 0.4;                  ///< searched around the guess, either way, at most [m]
  double window_angle = radians(20.0);  ///< searched around the guess, either way, at most [rad]
  double max_range = 20.0;              ///< beams that end farther away aren't used [m]
  double min_travel = 0.01;             ///< a scan is matched after this way since the last match ... [m]
  double min_turn = radians(0.5);       ///< ... or this turn [rad]
  int search_beams = 120;               ///< of a scan that the search looks at, about, evenly spread
  double beam_weight = 1.0;             ///< of the search: see CorrelativeSearch [nats]
  double min_support = 10.0;            ///< beams on surfaces that make a match ...
  double min_share = 0.3;               ///< ... if they are this share of those that end where the map knows anything
  double doubtful_share = 0.7;          ///< with a share below this, the wheels may have slipped: the whole window ...
  double slip_gain = 1.2;               ///< ... is searched, and must support the match this many times better ...
  double slip_support = 20.0;           ///< ... and by this many beams: where few are left, noise takes some along
  double wall_angle = radians(0.5);     ///< straight walls whose direction is surer than this stand as the scan says
  MotionNoise motion;
  ScanAlignmentParams alignment;
  WallCompassParams compass;
};

/// Odometry between scans, less what it was found to err by (PoseFilter); each scan is matched with the map that was
/// made of those before. A correlative search
/// (CorrelativeSearch) over what odometry allows finds the right hill, an alignment (ScanAligner) its top. Odometry and
/// scan are weighed by what each of them knows: along a bare corridor, odometry has the say. Before either, the walls
/// in sight tell what the heading errs by (WallCompass). The covariance is that of all together, in the map: how far
/// the map itself has drifted since its beginning, no scan of it can tell.
///
/// The scans from before the robot first moves define the map; later ones with too little in common with it are let go
/// by. While the robot stands, nothing is matched, so nothing drifts.
class ScanMatching final : public Localizer {
 public:
  /// `mapper` must outlive it, and be updated after each frame with this localizer's pose. Throws Error for a robot
  /// without a lidar.
  ScanMatching(const RobotModel& robot, const Mapper& mapper, const ScanMatchingParams& params = {});

  const PoseEstimate& update(const Frame& frame) override;

 private:
  void reckon(const Frame& frame);
  void match(const Frame& frame);
  void take(const Frame& frame);
  void head_by_walls();
  bool lay_over_map();
  ScanAlignment match_from(const PoseFilter& guess);
  int count_known(GridView<const LogOdds> map) const;
  void remember();

  const Mapper& mapper_;
  ScanMatchingParams params_;
  LidarModel lidar_;
  DeadReckoning odometry_;
  PoseFilter filter_;
  ScanPoints scan_points_;
  LikelihoodField field_;
  SurfaceMap surfaces_;
  CorrelativeSearch search_;
  ScanAligner aligner_;
  WallCompass compass_;
  std::vector<ScanEnd> ends_;        // of the scan at hand, in the robot's frame
  std::vector<Point2> search_ends_;  // some of them
  std::vector<StraightWall> walls_;  // that they lie on

  PoseEstimate estimate_;
  Pose2 last_odometry_;
  double way_ = 0.0;      // driven since the last match [m]
  double turn_ = 0.0;     // turned since the last match, whichever way [rad]
  bool started_ = false;  // there was a scan
};

}  // namespace scrubjay
