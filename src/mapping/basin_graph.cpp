#include "basin_graph.hpp"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

namespace scrubjay {

BasinGraph::BasinGraph(GridView<const BasinLabel> basins, GridView<const SquaredClearance> clearance) {
  const std::size_t size = basins.geometry.size();
  const BasinLabel last = size == 0 ? 0 : *std::max_element(basins.cells, basins.cells + size);
  into_.resize(std::size_t{last} + 1);
  std::iota(into_.begin(), into_.end(), BasinLabel{0});
  areas_.resize(into_.size());
  neighbours_.resize(into_.size());
  const auto look = [&](std::size_t a, std::size_t b) {
    if (basins.cells[b] == basins.cells[a] || basins.cells[b] == 0) return;
    const std::size_t lower = clearance.cells[a] <= clearance.cells[b] ? a : b;
    connect(basins.cells[a], basins.cells[b], {clearance.cells[lower], lower});
  };
  for (std::size_t i = 0; i < size; ++i) {
    if (basins.cells[i] == 0) continue;
    ++areas_[basins.cells[i]];
    look(i, i + 1);
    look(i, i + static_cast<std::size_t>(basins.geometry.width));
  }
}

void BasinGraph::connect(BasinLabel a, BasinLabel b, const Saddle& saddle) {
  Saddle& widest = neighbours_[a][b];
  if (saddle.clearance > widest.clearance) widest = saddle;
  neighbours_[b][a] = widest;
}

BasinLabel BasinGraph::basin(BasinLabel label) const {
  while (into_[label] != label) label = into_[label];
  return label;
}

void BasinGraph::join(BasinLabel small, BasinLabel large) {
  for (const auto& [neighbour, saddle] : neighbours_[small]) {
    if (neighbour != large) connect(large, neighbour, saddle);
  }
  areas_[large] += areas_[small];
  drop(small);
  into_[small] = large;
}

void BasinGraph::drop(BasinLabel basin) {
  for (const auto& [neighbour, saddle] : neighbours_[basin]) neighbours_[neighbour].erase(basin);
  neighbours_[basin].clear();
  into_[basin] = 0;
}

void BasinGraph::join_small(std::size_t least_area) {
  std::set<std::pair<std::size_t, BasinLabel>> small;
  const auto add_if_small = [&](BasinLabel basin) {
    if (areas_[basin] < least_area) small.emplace(areas_[basin], basin);
  };
  for (BasinLabel label = 1; label < end(); ++label) {
    if (is_basin(label)) add_if_small(label);
  }
  while (!small.empty()) {
    const BasinLabel basin = small.extract(small.begin()).value().second;
    const BasinLabel large = widest_open(basin);
    if (large == 0) {
      drop(basin);
      continue;
    }
    small.erase({areas_[large], large});
    join(basin, large);
    add_if_small(large);
  }
}

BasinLabel BasinGraph::widest_open(BasinLabel basin) const {
  BasinLabel found = 0;
  SquaredClearance widest = 0;
  for (const auto& [neighbour, saddle] : neighbours_[basin]) {
    if (saddle.clearance <= widest) continue;
    found = neighbour;
    widest = saddle.clearance;
  }
  return found;
}

}  // namespace scrubjay
