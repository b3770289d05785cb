#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <scrubjay/error.hpp>
#include <scrubjay/grid/traversal.hpp>
#include <scrubjay/world/score.hpp>

#include "disc_lattice.hpp"

namespace scrubjay {
namespace {

constexpr int kNodesPerCell = 4;
constexpr std::uint32_t kReached = DiscLattice::kFirstOwn;
constexpr std::int32_t kNone = -1;

/// The world's shape in the map frame.
struct Outline {
  std::vector<Segment2> solid;
  std::vector<Polygon> cliffs;
};

Outline outline_in_map(const World& world, const Pose2& start) {
  const Pose2 map_from_world = inverse(start);
  Outline outline;
  for (const SolidSegment& solid : solid_segments(world)) {
    outline.solid.push_back({map_from_world * solid.segment.a, map_from_world * solid.segment.b});
  }
  for (Polygon cliff : world.cliffs) {
    for (Point2& corner : cliff) corner = map_from_world * corner;
    outline.cliffs.push_back(std::move(cliff));
  }
  return outline;
}

/// Cells around all of the outline and the map's origin, with room for the disc; the map's origin is a corner of cells.
GridGeometry cells_around(const Outline& outline, double robot_radius, double resolution) {
  Point2 low{0.0, 0.0};
  Point2 high{0.0, 0.0};
  const auto take = [&](const Point2& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  };
  for (const Segment2& segment : outline.solid) {
    take(segment.a);
    take(segment.b);
  }
  for (const Polygon& cliff : outline.cliffs) std::for_each(cliff.begin(), cliff.end(), take);
  const auto first_cell = [&](double p) { return std::floor((p - robot_radius) / resolution) - 1.0; };
  const auto end_cell = [&](double p) { return std::ceil((p + robot_radius) / resolution) + 1.0; };
  GridGeometry cells;
  cells.resolution = resolution;
  cells.origin = {first_cell(low.x()) * resolution, first_cell(low.y()) * resolution};
  const double width = end_cell(high.x()) - first_cell(low.x());
  const double height = end_cell(high.y()) - first_cell(low.y());
  if (!(width * height * kNodesPerCell * kNodesPerCell < static_cast<double>(kMostNodes))) {
    throw Error("the world's truth would take " + std::to_string(width * height) + " cells; want a larger resolution");
  }
  cells.width = static_cast<std::int32_t>(width);
  cells.height = static_cast<std::int32_t>(height);
  return cells;
}

/// Nodes on all corners of a quarter cell: node (0, 0) on the corner of cell (0, 0).
GridGeometry nodes_of(const GridGeometry& cells) {
  GridGeometry nodes;
  nodes.resolution = cells.resolution / kNodesPerCell;
  nodes.origin = cells.origin.array() - 0.5 * nodes.resolution;
  nodes.width = kNodesPerCell * cells.width + 1;
  nodes.height = kNodesPerCell * cells.height + 1;
  return nodes;
}

/// The free node nearest to the map's origin, within half a cell of it.
CellIndex start_node(const DiscLattice& lattice, const World& world, const Pose2& start, double radius) {
  char place[64];
  std::snprintf(place, sizeof place, "start (%.3f, %.3f) is ", start.x, start.y);
  for (const Furniture& furniture : world.furniture) {
    for (const Polygon& part : furniture.parts) {
      if (contains(part, start.position())) {
        throw Error(place + std::string("inside of the ") + furniture.name + "; want a place on the floor");
      }
    }
  }
  const CellIndex origin = lattice.geometry.cell_at({0.0, 0.0});
  constexpr int kReach = kNodesPerCell / 2;
  int nearest = kReach * kReach + 1;
  CellIndex found;
  for (int dy = -kReach; dy <= kReach; ++dy) {
    for (int dx = -kReach; dx <= kReach; ++dx) {
      const CellIndex node{origin.x + dx, origin.y + dy};
      if (dx * dx + dy * dy >= nearest || lattice[node] != DiscLattice::kFree) continue;
      nearest = dx * dx + dy * dy;
      found = node;
    }
  }
  if (nearest <= kReach * kReach) return found;
  char want[96];
  std::snprintf(want, sizeof want, "closer than %.4f m to a wall or cliff; want a place where the robot fits", radius);
  throw Error(std::string(place) + want);
}

/// The part of a segment inside of one cell; `next` links the pieces of a cell.
struct WallPiece {
  Segment2 segment;
  std::int32_t next = kNone;
};

/// Cuts walls where they cross from cell to cell.
class WallPieces {
 public:
  explicit WallPieces(const GridGeometry& cells) : cells_(cells), first_(cells.size(), kNone) {}

  void add(const Segment2& segment) {
    cuts_.assign({0.0, 1.0});
    cut(segment, 0);
    cut(segment, 1);
    std::sort(cuts_.begin(), cuts_.end());
    const Point2 along = segment.b - segment.a;
    for (std::size_t i = 1; i < cuts_.size(); ++i) {
      const Segment2 piece{segment.a + cuts_[i - 1] * along, segment.a + cuts_[i] * along};
      const std::size_t cell = cells_.index(cells_.cell_at(0.5 * (piece.a + piece.b)));
      pieces_.push_back({piece, first_[cell]});
      first_[cell] = static_cast<std::int32_t>(pieces_.size()) - 1;
    }
  }
  bool any(std::size_t cell) const { return first_[cell] != kNone; }
  /// The piece of the cell within `radius` of `p`, or null.
  const Segment2* within(std::size_t cell, const Point2& p, double radius) const {
    for (std::int32_t i = first_[cell]; i != kNone; i = pieces_[static_cast<std::size_t>(i)].next) {
      const Segment2& segment = pieces_[static_cast<std::size_t>(i)].segment;
      if (squared_distance(segment, p) <= radius * radius) return &segment;
    }
    return nullptr;
  }

 private:
  void cut(const Segment2& segment, int axis) {
    const double a = (segment.a[axis] - cells_.origin[axis]) / cells_.resolution;
    const double b = (segment.b[axis] - cells_.origin[axis]) / cells_.resolution;
    for (double line = std::floor(std::min(a, b)) + 1.0; line < std::max(a, b); line += 1.0) {
      cuts_.push_back(std::clamp((line - a) / (b - a), 0.0, 1.0));
    }
  }

  const GridGeometry& cells_;
  std::vector<std::int32_t> first_;
  std::vector<WallPiece> pieces_;
  std::vector<double> cuts_;
};

/// Numbers boundaries by the size of the blocked lattice around them, largest first.
class Boundaries {
 public:
  explicit Boundaries(DiscLattice& lattice) : lattice_(lattice) {}

  /// A provisional number, from 0 on, of the boundary at `p`.
  std::size_t at(const Point2& p) {
    const CellIndex node = lattice_.geometry.cell_at(p);
    if (lattice_[node] == DiscLattice::kBlocked) {
      sizes_.push_back(flood(lattice_, node, kFirst + static_cast<std::uint32_t>(sizes_.size()), Neighbours::Eight));
    }
    return lattice_[node] - kFirst;
  }
  /// Final numbers, from 1 on, by provisional ones.
  std::vector<std::uint16_t> ranks() const {
    if (sizes_.size() > std::numeric_limits<std::uint16_t>::max()) {
      throw Error("the world has " + std::to_string(sizes_.size()) + " separate obstacles; want at most 65535");
    }
    std::vector<std::size_t> order(sizes_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return sizes_[a] > sizes_[b]; });
    std::vector<std::uint16_t> ranks(sizes_.size());
    for (std::size_t i = 0; i < order.size(); ++i) ranks[order[i]] = static_cast<std::uint16_t>(i + 1);
    return ranks;
  }

 private:
  static constexpr std::uint32_t kFirst = kReached + 1;
  DiscLattice& lattice_;
  std::vector<std::size_t> sizes_;
};

/// The nodes at the rim of what was reached. They are the nearest reached ones to every point outside: from a reached
/// node with four reached neighbours, one of those is nearer.
std::vector<CellIndex> rim_of(const DiscLattice& lattice) {
  std::vector<CellIndex> rim;
  for (std::int32_t y = 1; y < lattice.geometry.height - 1; ++y) {
    for (std::int32_t x = 1; x < lattice.geometry.width - 1; ++x) {
      if (lattice.on_rim({x, y}, kReached)) rim.push_back({x, y});
    }
  }
  return rim;
}

void mark_reachable(const DiscLattice& lattice, const std::vector<CellIndex>& rim, double radius, GroundTruth& truth) {
  const GridGeometry& cells = truth.geometry;
  for (std::int32_t y = 0; y < cells.height; ++y) {
    for (std::int32_t x = 0; x < cells.width; ++x) {
      const CellIndex middle{kNodesPerCell * x + kNodesPerCell / 2, kNodesPerCell * y + kNodesPerCell / 2};
      truth.cells[cells.index({x, y})].reachable = lattice[middle] == kReached;
    }
  }
  for (const CellIndex node : rim) {
    visit_disc(cells, lattice.geometry.center(node), radius,
               [&](CellIndex cell) { truth.cells[cells.index(cell)].reachable = true; });
  }
  for (GroundTruth::Cell& cell : truth.cells) {
    cell.reachable = cell.reachable && !cell.wall;
    truth.reachable_count += cell.reachable ? 1 : 0;
  }
}

void mark_facing(const DiscLattice& lattice, const std::vector<CellIndex>& rim, const WallPieces& pieces, double reach,
                 Boundaries& boundaries, GroundTruth& truth) {
  for (const CellIndex node : rim) {
    const Point2 p = lattice.geometry.center(node);
    const CellIndex low = truth.geometry.cell_at(p.array() - reach);
    const CellIndex high = truth.geometry.cell_at(p.array() + reach);
    for (std::int32_t y = std::max(low.y, 0); y <= std::min(high.y, truth.geometry.height - 1); ++y) {
      for (std::int32_t x = std::max(low.x, 0); x <= std::min(high.x, truth.geometry.width - 1); ++x) {
        const std::size_t index = truth.geometry.index({x, y});
        GroundTruth::Cell& cell = truth.cells[index];
        if (!cell.wall || cell.facing) continue;
        const Segment2* piece = pieces.within(index, p, reach);
        if (piece == nullptr) continue;
        cell.facing = true;
        cell.boundary = static_cast<std::uint16_t>(boundaries.at(0.5 * (piece->a + piece->b)));
      }
    }
  }
}

/// The edge of a cliff belongs into a map as a wall does; it can't be touched, so no robot must have found it.
void mark_cliff_edges(const std::vector<Polygon>& cliffs, GroundTruth& truth) {
  for (const Polygon& cliff : cliffs) {
    for (std::size_t i = 0; i < cliff.size(); ++i) {
      visit_line(truth.geometry, cliff[i], cliff[(i + 1) % cliff.size()], [&](CellIndex cell) {
        if (truth.geometry.contains(cell)) truth.cells[truth.geometry.index(cell)].wall = true;
      });
    }
  }
}

}  // namespace

GroundTruth ground_truth(const World& world, const Pose2& start, double robot_radius, double resolution) {
  if (!(robot_radius > kBumperGive)) {
    throw Error("the robot's radius is " + std::to_string(robot_radius) + "; want a positive length in metres");
  }
  // With larger cells the disc could step over a wall between two nodes.
  if (!(resolution > 0.0 && resolution <= 2.0 * robot_radius)) {
    throw Error("the resolution is " + std::to_string(resolution) +
                "; want a positive length up to the robot's diameter, " + std::to_string(2.0 * robot_radius) + " m");
  }
  const Outline outline = outline_in_map(world, start);
  const double radius = robot_radius - kBumperGive;
  GroundTruth truth;
  truth.geometry = cells_around(outline, robot_radius, resolution);
  truth.cells.resize(truth.geometry.size());

  DiscLattice lattice(nodes_of(truth.geometry));
  WallPieces pieces(truth.geometry);
  for (const Segment2& segment : outline.solid) {
    block_near(lattice, segment, radius);
    pieces.add(segment);
  }
  for (const Polygon& cliff : outline.cliffs) {
    for (std::size_t i = 0; i < cliff.size(); ++i)
      block_near(lattice, {cliff[i], cliff[(i + 1) % cliff.size()]}, radius);
    block_inside(lattice, cliff);
  }
  for (std::size_t i = 0; i < truth.cells.size(); ++i) truth.cells[i].wall = pieces.any(i);

  flood(lattice, start_node(lattice, world, start, radius), kReached, Neighbours::Four);
  const std::vector<CellIndex> rim = rim_of(lattice);
  mark_reachable(lattice, rim, radius, truth);
  Boundaries boundaries(lattice);
  mark_facing(lattice, rim, pieces, robot_radius + std::sqrt(2.0) * lattice.geometry.resolution, boundaries, truth);
  mark_cliff_edges(outline.cliffs, truth);
  const std::vector<std::uint16_t> ranks = boundaries.ranks();
  for (GroundTruth::Cell& cell : truth.cells) {
    if (cell.facing) cell.boundary = ranks[cell.boundary];
  }
  truth.boundary_count = static_cast<std::uint16_t>(ranks.size());
  return truth;
}

}  // namespace scrubjay
