#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <scrubjay/error.hpp>
#include <scrubjay/planning/path_search.hpp>
#include <string>
#include <utility>

#include "lattice.hpp"

namespace scrubjay {

using namespace lattice;

void PathSearch::begin(GridView<const TravelCost> costs, CellIndex from) {
  const std::size_t size = costs.geometry.size();
  if (std::max(costs.geometry.width, costs.geometry.height) > kMaxSide) {
    throw Error("the map is " + std::to_string(costs.geometry.width) + " x " + std::to_string(costs.geometry.height) +
                " cells; paths are searched on maps of up to " + std::to_string(kMaxSide) + " cells a side");
  }
  constexpr Label kLast = std::numeric_limits<Label>::max() - kMaxLabels;
  if (stored_.size() != size || used_ > kLast - base_) {
    stored_.assign(size, std::numeric_limits<Label>::max());
    base_ = 0;
  } else {
    base_ += used_;
  }
  used_ = 0;
  costs_ = costs;
  for (std::size_t i = 0; i < offsets_.size(); ++i) {
    offsets_[i] = kDirections[i].x + static_cast<std::ptrdiff_t>(kDirections[i].y) * costs.geometry.width;
  }
  from_ = from;
  free_ = 0;
  settled_ = 0;
  ways_out_.clear();
  for (auto& bucket : buckets_) bucket.clear();
}

bool PathSearch::reached(CellIndex cell) const {
  return label_of(cell) < kMaxLabels;
}

/// Labels the impassable cells around the start, and lists the passable ones that they lead to.
void PathSearch::find_ways_out() {
  using Place = std::pair<Label, std::size_t>;
  std::priority_queue<Place, std::vector<Place>, std::greater<>> open;
  const GridGeometry& grid = costs_.geometry;
  const double reach = let_out_ / grid.resolution;
  set_label(grid.index(from_), 0);
  open.push({0, grid.index(from_)});
  while (!open.empty()) {
    const auto [label, index] = open.top();
    open.pop();
    if (label != label_at(index)) continue;
    used_ = std::max(used_, label + kMaxStep);
    const auto width = static_cast<std::size_t>(grid.width);
    const CellIndex cell{static_cast<std::int32_t>(index % width), static_cast<std::int32_t>(index / width)};
    for (int direction = 0; direction < 8; ++direction) {
      const CellIndex next = neighbour(cell, direction);
      const double dx = next.x - from_.x;
      const double dy = next.y - from_.y;
      if (!grid.contains(next) || dx * dx + dy * dy > reach * reach) continue;
      const Label candidate = label + way_out_cost(direction);
      if (costs_[next] != kNoWay) {
        ways_out_.push_back({next, candidate});
      } else if (candidate < label_of(next)) {
        set_label(grid.index(next), candidate);
        open.push({candidate, grid.index(next)});
      }
    }
  }
  std::sort(ways_out_.begin(), ways_out_.end(), [&grid](const WayOut& a, const WayOut& b) {
    return a.label != b.label ? a.label < b.label : grid.index(a.cell) < grid.index(b.cell);
  });
  if (!ways_out_.empty()) free_ = ways_out_.front().label;
}

template <typename Estimate>
void PathSearch::search(const Estimate& estimate, CellIndex to) {
  const auto seed = [&](CellIndex cell, Label label) {
    return Seed{cell, label, label + estimate(static_cast<std::uint32_t>(cell.x), static_cast<std::uint32_t>(cell.y))};
  };
  goal_ = costs_.contains(to) ? place_of(to) : kNowhere;
  if (costs_[from_] != kNoWay) {
    run(estimate, std::array{seed(from_, 0)});
    return;
  }
  find_ways_out();
  max_label_ += free_;
  const double side = 2.0 * let_out_ / costs_.geometry.resolution;
  const auto island = static_cast<std::size_t>(side * side);
  std::vector<Seed> seeds;
  for (std::size_t i = 0; i < ways_out_.size() && settled_ < island; ++i) {
    if (reached(ways_out_[i].cell)) continue;
    seeds.clear();
    const Label last = ways_out_[i].label + way_out_cost(0);
    for (std::size_t k = i; k < ways_out_.size() && ways_out_[k].label <= last; ++k) {
      if (!reached(ways_out_[k].cell)) seeds.push_back(seed(ways_out_[k].cell, ways_out_[k].label));
    }
    std::stable_sort(seeds.begin(), seeds.end(), [](const Seed& a, const Seed& b) { return a.total < b.total; });
    run(estimate, seeds);
    if (costs_.contains(to) && reached(to)) return;
  }
}

std::vector<CellIndex> PathSearch::find(GridView<const TravelCost> costs, CellIndex from, CellIndex to) {
  if (!costs.contains(from) || cost_of(costs, to) == kNoWay) return {};
  begin(costs, from);
  max_label_ = kLongestWay;
  search(OctileDistance{to}, to);
  return way_to(to);
}

void PathSearch::spread(GridView<const TravelCost> costs, CellIndex from, double max_cost) {
  if (!costs.contains(from)) {
    stored_.clear();
    return;
  }
  begin(costs, from);
  const double most = max_cost / costs.geometry.resolution * kLabelsPerCell;
  max_label_ = static_cast<Label>(std::clamp(most, 0.0, double{kLongestWay}));
  search(NoEstimate{}, {-1, -1});
}

double PathSearch::cost_to(CellIndex cell) const {
  if (stored_.empty() || !costs_.contains(cell)) return kNever;
  const Label label = label_of(cell);
  const bool there = cell == from_ || (label <= max_label_ && costs_[cell] != kNoWay);
  if (!there) return kNever;
  return (label - std::min(free_, label)) / kLabelsPerCell * costs_.geometry.resolution;
}

std::vector<CellIndex> PathSearch::path_to(CellIndex cell) const {
  if (cost_to(cell) == kNever) return {};
  return way_to(cell);
}

/// The neighbour from which the way came: the one whose label and step make up the cell's.
CellIndex PathSearch::step_back(CellIndex cell) const {
  const Label label = label_of(cell);
  for (int direction = 0; direction < 8; ++direction) {
    const CellIndex before = neighbour(cell, direction);
    if (!costs_.contains(before)) continue;
    const std::uint32_t step = step_cost(costs_, cell, direction);
    if (step != 0 && step <= label && label_of(before) == label - step) return before;
  }
  for (int direction = 0; direction < 8; ++direction) {
    const CellIndex before = neighbour(cell, direction);
    const std::uint32_t step = way_out_cost(direction);
    if (!costs_.contains(before) || costs_[before] != kNoWay || step > label) continue;
    if (label_of(before) == label - step) return before;
  }
  return from_;  // not reached: every label but the first came from somewhere
}

std::vector<CellIndex> PathSearch::way_to(CellIndex cell) const {
  if (!reached(cell)) return {};
  std::vector<CellIndex> way{cell};
  while (!(way.back() == from_)) way.push_back(step_back(way.back()));
  std::reverse(way.begin(), way.end());
  return way;
}

}  // namespace scrubjay
