/// \file
/// Which basins lie beside each other, and how wide they are open to one another.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "basins.hpp"

namespace scrubjay {

/// Where two basins meet; where they do so at several places, the widest of them.
struct Saddle {
  SquaredClearance clearance = 0;
  std::size_t cell = 0;
};

/// Basins and their saddles, as they are joined. A basin that takes in others keeps its label.
class BasinGraph {
 public:
  using Neighbours = std::map<BasinLabel, Saddle>;

  /// Of a grid as in flood_basins.
  BasinGraph(GridView<const BasinLabel> basins, GridView<const SquaredClearance> clearance);

  /// One more than the largest label that there was.
  BasinLabel end() const { return static_cast<BasinLabel>(areas_.size()); }
  /// The basin that it is part of now; 0 of what was dropped.
  BasinLabel basin(BasinLabel label) const;
  bool is_basin(BasinLabel label) const { return label != 0 && into_[label] == label; }
  std::size_t area(BasinLabel basin) const { return areas_[basin]; }  ///< [cells]
  const Neighbours& neighbours(BasinLabel basin) const { return neighbours_[basin]; }

  /// Makes `small` part of its neighbour `large`.
  void join(BasinLabel small, BasinLabel large);
  /// Makes a basin part of none.
  void drop(BasinLabel basin);
  /// Joins each basin of fewer cells to the one that it is widest open to, the smallest first, and drops it where it
  /// has no neighbour.
  void join_small(std::size_t least_area);

 private:
  void connect(BasinLabel a, BasinLabel b, const Saddle& saddle);
  BasinLabel widest_open(BasinLabel basin) const;

  std::vector<BasinLabel> into_;
  std::vector<std::size_t> areas_;
  std::vector<Neighbours> neighbours_;
};

}  // namespace scrubjay
