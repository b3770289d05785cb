/// \file
/// Where a disc fits among segments: a lattice of places for its centre, as labels to flood.
#pragma once

#include <cstdint>
#include <scrubjay/grid/grid_view.hpp>
#include <scrubjay/world/world.hpp>
#include <vector>

namespace scrubjay {

/// Labels of the nodes of a square lattice; floods may use others from kFirstOwn on.
///
/// A node is the centre of a cell of `geometry`. The outermost ring is always blocked, so that floods end there without
/// looking for the border.
struct DiscLattice {
  static constexpr std::uint32_t kFree = 0;
  static constexpr std::uint32_t kBlocked = 1;
  static constexpr std::uint32_t kFirstOwn = 2;

  GridGeometry geometry;
  std::vector<std::uint32_t> labels;

  /// All free, but for the outermost ring. Throws Error if that is too much for memory (see kMostNodes).
  explicit DiscLattice(const GridGeometry& nodes);

  std::uint32_t& operator[](CellIndex node) { return labels[geometry.index(node)]; }
  std::uint32_t operator[](CellIndex node) const { return labels[geometry.index(node)]; }
  /// Whether an inner node has this label and one of its four neighbours hasn't.
  bool on_rim(CellIndex node, std::uint32_t label) const;
};

/// 256 MiB of labels: 100 x 100 m at 1.25 cm.
inline constexpr std::size_t kMostNodes = std::size_t{1} << 26;

/// Blocks every node nearer to the segment than `radius`.
void block_near(DiscLattice& lattice, const Segment2& segment, double radius);
/// Blocks every node inside of the polygon.
void block_inside(DiscLattice& lattice, const Polygon& polygon);

enum class Neighbours { Four, Eight };

/// Gives the label `to` to all that is connected with `seed` and has its label; returns how many nodes that were.
std::size_t flood(DiscLattice& lattice, CellIndex seed, std::uint32_t to, Neighbours neighbours);

}  // namespace scrubjay
