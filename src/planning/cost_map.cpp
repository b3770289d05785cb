#include <algorithm>
#include <cmath>
#include <cstddef>
#include <scrubjay/error.hpp>
#include <scrubjay/planning/cost_map.hpp>
#include <string>
#include <utility>

namespace scrubjay {
namespace {

constexpr std::uint8_t kObstacle = 1;
// So that two squared distances add up to less than an std::int16_t holds.
constexpr std::int32_t kMaxReach = 126;
// Rows worked on at a time: their columns stay in the cache between the two passes.
constexpr std::int32_t kBandHeight = 64;

/// Log-odds at or above this are an obstacle.
LogOdds obstacle_from(const CostMapParams& params) {
  return params.through_unknown ? kOccupiedLogOdds : static_cast<LogOdds>(kFreeLogOdds + 1);
}

TravelCost cost_at(double distance, const CostMapParams& params) {
  const double beyond = distance - params.radius - params.margin;
  if (beyond < 0.0) return kNoWay;
  if (beyond >= params.comfort) return 0;
  const double left = 1.0 - beyond / params.comfort;
  return static_cast<TravelCost>(std::min(254.0, std::floor((params.dearness - 1.0) * kCostUnit * left * left + 0.5)));
}

std::ptrdiff_t offset(const GridGeometry& grid, CellIndex cell) {
  return static_cast<std::ptrdiff_t>(grid.index(cell));
}

/// The first cell of a row that differs from what it becomes, and the one past the last.
struct Difference {
  std::int32_t begin = 0;
  std::int32_t end = 0;
};

/// Writes the classes of `count` cells, and tells where they differ from what was there.
Difference take_row(const LogOdds* cells, std::uint8_t* classes, std::int32_t count, LogOdds obstacle) {
  unsigned differs = 0;
  for (std::int32_t i = 0; i < count; ++i) {
    differs |= static_cast<unsigned>(classes[i] != static_cast<std::uint8_t>(cells[i] >= obstacle));
  }
  if (differs == 0) return {};
  const auto changed = [&](std::int32_t i) { return classes[i] != static_cast<std::uint8_t>(cells[i] >= obstacle); };
  Difference difference{0, count};
  while (!changed(difference.begin)) ++difference.begin;
  while (!changed(difference.end - 1)) --difference.end;
  for (std::int32_t i = difference.begin; i < difference.end; ++i) {
    classes[i] = static_cast<std::uint8_t>(cells[i] >= obstacle);
  }
  return difference;
}

}  // namespace

CostMap::CostMap(const CostMapParams& params) : params_(params) {}

CellRect CostMap::update(GridView<const LogOdds> map, const CellRect& changed) {
  const CellRect all = cells_of(map.geometry);
  const bool known = geometry_.size() > 0 && geometry_.resolution == map.geometry.resolution;
  if (!known) start_over(map.geometry);
  CellRect dirty = known ? follow(map.geometry) : all;
  dirty = bounding(dirty, take_classes(map, known ? intersection(changed, all) : all));
  if (dirty.empty()) return {};
  dirty = intersection(grown(dirty, reach_), all);
  recompute(dirty);
  return dirty;
}

void CostMap::start_over(const GridGeometry& geometry) {
  const double reach = std::ceil((params_.radius + params_.margin + params_.comfort) / geometry.resolution);
  if (!(reach <= kMaxReach)) {
    throw Error("CostMapParams: radius + margin + comfort is " + std::to_string(reach) + " cells of " +
                std::to_string(geometry.resolution) + " m; want at most " + std::to_string(kMaxReach));
  }
  geometry_ = geometry;
  reach_ = static_cast<std::int32_t>(reach);
  cost_at_.resize(static_cast<std::size_t>(reach_ * reach_ + 1));
  for (std::size_t squared = 0; squared < cost_at_.size(); ++squared) {
    cost_at_[squared] = cost_at(std::sqrt(static_cast<double>(squared)) * geometry.resolution, params_);
  }
  obstacles_.assign(geometry.size(), params_.through_unknown ? 0 : kObstacle);
  costs_.assign(geometry.size(), params_.through_unknown ? TravelCost{0} : kNoWay);
  fence_off(cells_of(geometry));
}

/// Moves what is known to where the map has it now. Returns the cells that may have obstacles near that they had not.
CellRect CostMap::follow(const GridGeometry& geometry) {
  if (geometry == geometry_) return {};
  const GridGeometry old = geometry_;
  const std::vector<std::uint8_t> old_obstacles = std::move(obstacles_);
  const std::vector<TravelCost> old_costs = std::move(costs_);
  start_over(geometry);
  const Point2 move = (old.origin - geometry.origin) / geometry.resolution;
  const CellIndex corner{static_cast<std::int32_t>(std::lround(move.x())),
                         static_cast<std::int32_t>(std::lround(move.y()))};
  const CellRect kept = intersection({corner, {corner.x + old.width, corner.y + old.height}}, cells_of(geometry));
  for (std::int32_t y = kept.low.y; y < kept.high.y && !kept.empty(); ++y) {
    const auto from = offset(old, {kept.low.x - corner.x, y - corner.y});
    const auto to = offset(geometry, {kept.low.x, y});
    std::copy_n(old_obstacles.begin() + from, kept.high.x - kept.low.x, obstacles_.begin() + to);
    std::copy_n(old_costs.begin() + from, kept.high.x - kept.low.x, costs_.begin() + to);
  }
  // What is new is unknown, as what lay outside was: it changes nothing, but old obstacles now reach into it. A map
  // that lost cells is no case of ours, but must not be wrong.
  const bool shrank = kept.high.x - kept.low.x < old.width || kept.high.y - kept.low.y < old.height;
  return params_.through_unknown || shrank ? kept : CellRect{};
}

/// Returns the tight rectangle of the cells that became obstacles or ceased to be.
CellRect CostMap::take_classes(GridView<const LogOdds> map, const CellRect& rect) {
  const LogOdds obstacle = obstacle_from(params_);
  CellRect changed;
  for (std::int32_t y = rect.low.y; y < rect.high.y && !rect.empty(); ++y) {
    const std::size_t begin = geometry_.index({rect.low.x, y});
    const Difference row = take_row(map.cells + begin, obstacles_.data() + begin, rect.high.x - rect.low.x, obstacle);
    changed = bounding(changed, {{rect.low.x + row.begin, y}, {rect.low.x + row.end, y + 1}});
  }
  return changed;
}

void CostMap::recompute(const CellRect& rect) {
  for (std::int32_t y = rect.low.y; y < rect.high.y; y += kBandHeight) {
    recompute_band({{rect.low.x, y}, {rect.high.x, std::min(rect.high.y, y + kBandHeight)}});
  }
  fence_off(rect);
}

void CostMap::fence_off(const CellRect& rect) {
  if (!params_.within) return;
  for (std::int32_t y = rect.low.y; y < rect.high.y; ++y) {
    for (std::int32_t x = rect.low.x; x < rect.high.x; ++x) {
      if (!params_.within->contains(geometry_.center({x, y}))) costs_[geometry_.index({x, y})] = kNoWay;
    }
  }
}

/// Leaves, for each cell of the band and `reach_` cells on both sides of it, the distance to the next obstacle of its
/// column, cut at reach_ + 1, in above_ (rows of `width`, the first `reach_` rows being those below the band).
void CostMap::sum_up_columns(const CellRect& band, std::int32_t left, std::int32_t width) {
  const std::int32_t rows = band.high.y - band.low.y + 2 * reach_;
  const auto stride = static_cast<std::size_t>(width);
  const auto far = static_cast<std::uint8_t>(reach_ + 1);
  const std::uint8_t outside = params_.through_unknown ? far : 0;
  above_.assign(static_cast<std::size_t>(rows) * stride, outside);

  const std::int32_t first = std::max(0, left);
  const std::int32_t last = std::min(geometry_.width, left + width);
  for (std::int32_t row = 0; row < rows; ++row) {
    const std::int32_t y = band.low.y - reach_ + row;
    if (y < 0 || y >= geometry_.height) continue;
    const std::uint8_t* obstacles = obstacles_.data() + geometry_.index({first, y});
    std::uint8_t* out = above_.data() + static_cast<std::size_t>(row) * stride + (first - left);
    for (std::int32_t i = 0; i < last - first; ++i) out[i] = obstacles[i] != 0 ? std::uint8_t{0} : far;
  }
  // Upwards, then downwards: each a step from the row before.
  const auto step = [&](std::int32_t from, std::int32_t to) {
    const std::uint8_t* before = above_.data() + static_cast<std::size_t>(from) * stride;
    std::uint8_t* row = above_.data() + static_cast<std::size_t>(to) * stride;
    for (std::size_t i = 0; i < stride; ++i) {
      row[i] = std::min(row[i], static_cast<std::uint8_t>(before[i] + 1));
    }
  };
  for (std::int32_t row = 1; row < rows; ++row) step(row - 1, row);
  for (std::int32_t row = rows - 1; row > 0; --row) step(row, row - 1);
}

void CostMap::recompute_band(const CellRect& band) {
  const std::int32_t left = band.low.x - reach_;
  const std::int32_t width = band.high.x - band.low.x + 2 * reach_;
  const std::int32_t cells = band.high.x - band.low.x;
  sum_up_columns(band, left, width);
  squared_.resize(static_cast<std::size_t>(width));
  nearest_.resize(static_cast<std::size_t>(cells));
  const auto limit = static_cast<std::int16_t>(reach_ * reach_);
  for (std::int32_t y = band.low.y; y < band.high.y; ++y) {
    const std::uint8_t* column =
        above_.data() + static_cast<std::size_t>(y - band.low.y + reach_) * static_cast<std::size_t>(width);
    for (std::size_t i = 0; i < squared_.size(); ++i) {
      squared_[i] = static_cast<std::int16_t>(column[i] * column[i]);
    }
    std::fill(nearest_.begin(), nearest_.end(), limit);
    for (std::int32_t dx = -reach_; dx <= reach_; ++dx) {
      const std::int16_t* from = squared_.data() + reach_ + dx;
      const auto across = static_cast<std::int16_t>(dx * dx);
      for (std::size_t i = 0; i < nearest_.size(); ++i) {
        nearest_[i] = std::min(nearest_[i], static_cast<std::int16_t>(from[i] + across));
      }
    }
    TravelCost* costs = costs_.data() + geometry_.index({band.low.x, y});
    for (std::size_t i = 0; i < nearest_.size(); ++i) costs[i] = cost_at_[static_cast<std::size_t>(nearest_[i])];
  }
}

}  // namespace scrubjay
