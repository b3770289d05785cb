/// \file
/// Lays a scan onto surfaces, finer than cells.
#pragma once

#include <scrubjay/localization/correlative_search.hpp>
#include <scrubjay/localization/surface_map.hpp>
#include <span>
#include <vector>

namespace scrubjay {

struct ScanAlignmentParams {
  double outlier = 1.5;     ///< an end this far from its line counts half (Cauchy) [standard deviations]
  double trust = 0.3;       ///< what a beam's word counts: beams that end on one surface share that surface's error
  int max_iterations = 10;  ///< three or four do, but for scans that fit nowhere
};

/// Where a beam ended.
struct ScanEnd {
  Point2 point{0.0, 0.0};  ///< [m]
  Point2 view{0.0, 0.0};   ///< unit vector back to where the beam came from
  double noise = 0.0;      ///< standard deviation along the beam, > 0 [m]
};

/// A scan laid onto surfaces.
struct ScanAlignment {
  Pose2 pose;                                             ///< the likeliest one, given the guess and the scan
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  ///< what the scan says of (x, y, yaw): the score's curvature
  double support = 0.0;  ///< ends on surfaces; one that is an `outlier` from its own counts half
};

/// Moves a scan until its ends lie on the lines of a SurfaceMap, by Gauss and Newton's method on the log-likelihood of
/// scan and guess together. Distances count across surfaces only, as in A. Censi, *An ICP Variant Using a
/// Point-to-Line Metric*, ICRA 2008: what a scan doesn't tell, like the way along a bare corridor, stays as guessed.
class ScanAligner {
 public:
  explicit ScanAligner(const ScanAlignmentParams& params = {}) : params_(params) {}

  /// From `start` on, which must be right to a cell or so; `ends` are in the robot's frame. The information of `prior`
  /// must be positive definite.
  ScanAlignment align(std::span<const ScanEnd> ends, const SurfaceMap& surfaces, const LikelihoodField& field,
                      const PosePrior& prior, const Pose2& start);

 private:
  /// The line that an end was last compared with, good while it stays in its cell.
  struct Pairing {
    CellIndex cell;
    std::optional<SurfaceLine> line;
  };

  /// Of the scan's log-likelihood at a pose.
  struct Slope {
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  // the curvature, without its sign
    Eigen::Vector3d pull = Eigen::Vector3d::Zero();         // the gradient
    double support = 0.0;
  };

  Slope slope_at(const Pose2& pose, std::span<const ScanEnd> ends, const SurfaceMap& surfaces,
                 const LikelihoodField& field);

  ScanAlignmentParams params_;
  std::vector<Pairing> pairings_;
};

}  // namespace scrubjay
