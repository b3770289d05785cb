#include <algorithm>
#include <cmath>
#include <scrubjay/localization/correlative_search.hpp>

namespace scrubjay {
namespace {

/// The turn that moves a scan's ends by a cell, in root mean square [rad].
double angle_step(std::span<const Point2> ends, double resolution) {
  double sum = 0.0;
  for (const Point2& end : ends) sum += end.squaredNorm();
  return resolution / std::max(resolution, std::sqrt(sum / static_cast<double>(ends.size())));
}

}  // namespace

Pose2 CorrelativeSearch::best(std::span<const Point2> ends, const LikelihoodField& field, const PosePrior& prior,
                              const SearchWindow& window) {
  const double resolution = field.geometry().resolution;
  const double step = angle_step(ends, resolution);
  const auto turns = static_cast<std::int32_t>(std::ceil(window.angle / step));
  place(ends, field.geometry(), prior.pose, step, turns);
  bound_blocks(ends.size(), field, prior, window.cells, step, turns);

  const double per_fit = beam_weight_ / LikelihoodField::kBest;
  double best_score = -std::numeric_limits<double>::infinity();
  Eigen::Vector3d best_error = Eigen::Vector3d::Zero();
  for (const Block& block : blocks_) {
    if (block.bound <= best_score) break;
    const std::span<const CellIndex> cells = placed(block.turn + turns, ends.size());
    for (std::int32_t y = block.offset.y; y < std::min(block.offset.y + kBlock, window.cells + 1); ++y) {
      for (std::int32_t x = block.offset.x; x < std::min(block.offset.x + kBlock, window.cells + 1); ++x) {
        std::int64_t sum = 0;
        for (const CellIndex& c : cells) sum += field.at({c.x + x, c.y + y});
        const Eigen::Vector3d error(x * resolution, y * resolution, block.turn * step);
        const double score = per_fit * static_cast<double>(sum) + prior.log_likelihood(error);
        if (score <= best_score) continue;
        best_score = score;
        best_error = error;
      }
    }
  }
  return {prior.pose.x + best_error.x(), prior.pose.y + best_error.y(), wrap_angle(prior.pose.yaw + best_error.z())};
}

void CorrelativeSearch::place(std::span<const Point2> ends, const GridGeometry& grid, const Pose2& pose, double step,
                              std::int32_t turns) {
  cells_.clear();
  for (std::int32_t turn = -turns; turn <= turns; ++turn) {
    const SinCos heading = sin_cos(pose.yaw + turn * step);
    for (const Point2& end : ends) {
      cells_.push_back(grid.cell_at({pose.x + heading.cos * end.x() - heading.sin * end.y(),
                                     pose.y + heading.sin * end.x() + heading.cos * end.y()}));
    }
  }
}

std::span<const CellIndex> CorrelativeSearch::placed(std::int32_t turn, std::size_t count) const {
  return std::span(cells_).subspan(static_cast<std::size_t>(turn) * count, count);
}

void CorrelativeSearch::bound_blocks(std::size_t count, const LikelihoodField& field, const PosePrior& prior,
                                     std::int32_t reach, double step, std::int32_t turns) {
  const double resolution = field.geometry().resolution;
  const double per_fit = beam_weight_ / LikelihoodField::kBest;
  blocks_.clear();
  for (std::int32_t turn = -turns; turn <= turns; ++turn) {
    const std::span<const CellIndex> cells = placed(turn + turns, count);
    for (std::int32_t y = -reach; y <= reach; y += kBlock) {
      for (std::int32_t x = -reach; x <= reach; x += kBlock) {
        std::int64_t sum = 0;
        for (const CellIndex& c : cells) sum += field.bound({c.x + x, c.y + y});
        double guess = -std::numeric_limits<double>::infinity();
        for (std::int32_t v = y; v < y + kBlock; ++v) {
          for (std::int32_t u = x; u < x + kBlock; ++u) {
            guess = std::max(guess, prior.log_likelihood({u * resolution, v * resolution, turn * step}));
          }
        }
        blocks_.push_back({per_fit * static_cast<double>(sum) + guess, turn, {x, y}});
      }
    }
  }
  std::stable_sort(blocks_.begin(), blocks_.end(), [](const Block& a, const Block& b) { return a.bound > b.bound; });
}

}  // namespace scrubjay
