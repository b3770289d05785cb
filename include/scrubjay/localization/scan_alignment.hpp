/// \file
/// Lays a scan onto surfaces, finer than cells.
#pragma once

#include <scrubjay/localization/correlative_search.hpp>
#include <scrubjay/localization/scan_end.hpp>
#include <scrubjay/localization/surface_map.hpp>
#include <span>
#include <vector>

namespace scrubjay {

struct ScanAlignmentParams {
  double outlier = 1.5;     ///< an end this far from its line counts half (Cauchy) [standard deviations]
  double trust = 0.3;       ///< what a beam's word counts: some of what beams err by is common to all of a scan
  double blur = 0.005;      ///< standard deviation of where the map has a surface, on top of its line's [m]
  double shared = 0.1;      ///< beams that end within this length of a surface share its line's error [m]
  int max_iterations = 10;  ///< three or four do, but for scans that fit nowhere
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
/// So do errors: a beam that grazes a wall is hardly off by what its range is off by. And what a line itself is off by
/// counts once, however many beams end there: else the corner of a wall, a hand's breadth off and seen by forty beams
/// while its other face is still new, would have more to say than all the rest of a room. And a straight wall of the
/// scan knows better how it stands than the few cells of a line: along a bare corridor, lines that are a degree or two
/// askew would together hold the robot back.
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

  /// Variances of an end's distance from its line [m^2].
  struct Uncertainty {
    double own;     // of this end alone
    double shared;  // of as many as share the line: what each of them adds, it adds once
  };

  Uncertainty uncertainty(const ScanEnd& end, double cosine, double of_line) const;
  Slope slope_at(const Pose2& pose, std::span<const ScanEnd> ends, const SurfaceMap& surfaces,
                 const LikelihoodField& field);

  ScanAlignmentParams params_;
  std::vector<Pairing> pairings_;
};

}  // namespace scrubjay
