/// \file
/// Where a scan fits a map best, of all places near a guess.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <scrubjay/localization/likelihood_field.hpp>
#include <span>
#include <vector>

namespace scrubjay {

/// A guess at a pose, as a normal distribution.
struct PosePrior {
  Pose2 pose;
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  ///< inverse of the covariance of (x, y, yaw)

  /// Log-likelihood of the pose that is off by `error` (x, y, yaw) from the guess, but for a constant.
  double log_likelihood(const Eigen::Vector3d& error) const { return -0.5 * error.dot(information * error); }
};

struct SearchWindow {
  std::int32_t cells = 1;  ///< either way, along x and y
  double angle = 0.0;      ///< either way [rad]
};

/// Correlative scan matching in two levels: E. Olson, *Real-Time Correlative Scan Matching*, ICRA 2009, sec. III.
///
/// Every pose of the window, in steps of a cell, and of the turn that moves the scan's ends by about a cell, is worth
/// the log-likelihood of the guess plus that of the scan. Blocks of poses, best bound first, are opened until no bound
/// is better than the best pose: so this finds the maximum, not one near it.
class CorrelativeSearch {
 public:
  /// `beam_weight`: by how much a beam that ends on a surface is likelier than one that ends elsewhere [nats].
  /// It is well below 1, since neighbouring beams tell the same.
  explicit CorrelativeSearch(double beam_weight) : beam_weight_(beam_weight) {}

  /// `ends` are the scan's in the robot's frame; at least one.
  Pose2 best(std::span<const Point2> ends, const LikelihoodField& field, const PosePrior& prior,
             const SearchWindow& window);

 private:
  static constexpr std::int32_t kBlock = LikelihoodField::kBlock;

  /// Poses of one turn and of kBlock x kBlock offsets.
  struct Block {
    double bound;
    std::int32_t turn;  // [steps]
    CellIndex offset;   // of the first of them [cells]
  };

  void place(std::span<const Point2> ends, const GridGeometry& grid, const Pose2& pose, double step,
             std::int32_t turns);
  std::span<const CellIndex> placed(std::int32_t turn, std::size_t count) const;
  void bound_blocks(std::size_t count, const LikelihoodField& field, const PosePrior& prior, std::int32_t reach,
                    double step, std::int32_t turns);

  double beam_weight_;
  std::vector<CellIndex> cells_;  // where the ends lie, turn after turn
  std::vector<Block> blocks_;
};

}  // namespace scrubjay
