#include <algorithm>
#include <cmath>
#include <scrubjay/error.hpp>
#include <scrubjay/world/score.hpp>
#include <scrubjay/world/segment_index.hpp>
#include <string>

#include "disc_lattice.hpp"

namespace scrubjay {
namespace {

constexpr double kRoomEnough = 1.0;     ///< from the walls [m]
constexpr double kCoarsestStep = 0.05;  ///< of the lattice on which places are compared [m]
constexpr std::uint32_t kOutside = DiscLattice::kFirstOwn;

/// Nodes around all segments, with room for the disc between them and the border.
GridGeometry nodes_around(std::span<const SolidSegment> segments, double robot_radius) {
  Point2 low = segments.front().segment.a;
  Point2 high = low;
  for (const SolidSegment& solid : segments) {
    low = low.cwiseMin(solid.segment.a).cwiseMin(solid.segment.b);
    high = high.cwiseMax(solid.segment.a).cwiseMax(solid.segment.b);
  }
  GridGeometry nodes;
  // At most half a radius, so that no wall is stepped over.
  nodes.resolution = std::min(kCoarsestStep, 0.5 * robot_radius);
  const double margin = robot_radius + 3.0 * nodes.resolution;
  nodes.origin = low.array() - margin;
  const Point2 count = (high - low).array() / nodes.resolution + 2.0 * margin / nodes.resolution;
  if (!(count.x() * count.y() < static_cast<double>(kMostNodes))) {
    throw Error("the world is too large to look for a place to start in; want a start");
  }
  nodes.width = static_cast<std::int32_t>(std::ceil(count.x()));
  nodes.height = static_cast<std::int32_t>(std::ceil(count.y()));
  return nodes;
}

/// Labels the parts that are open to each other; returns the label of the largest, or kFree if there is none.
std::uint32_t label_parts(DiscLattice& lattice) {
  std::uint32_t largest = DiscLattice::kFree;
  std::size_t largest_size = 0;
  std::uint32_t label = kOutside;
  for (std::int32_t y = 0; y < lattice.geometry.height; ++y) {
    for (std::int32_t x = 0; x < lattice.geometry.width; ++x) {
      if (lattice[{x, y}] != DiscLattice::kFree) continue;
      const std::size_t size = flood(lattice, {x, y}, ++label, Neighbours::Four);
      if (size <= largest_size) continue;
      largest = label;
      largest_size = size;
    }
  }
  return largest;
}

/// The first node with that label that has room enough, or else the one that is farthest from all segments.
Point2 roomy_node(const DiscLattice& lattice, std::uint32_t label, const SegmentIndex& index) {
  Point2 best{0.0, 0.0};
  double best_distance = -1.0;
  for (std::int32_t y = 0; y < lattice.geometry.height; ++y) {
    for (std::int32_t x = 0; x < lattice.geometry.width; ++x) {
      if (lattice[{x, y}] != label) continue;
      const Point2 p = lattice.geometry.center({x, y});
      const double distance = index.distance(p, kRoomEnough);
      if (distance >= kRoomEnough) return p;
      if (distance > best_distance) {
        best = p;
        best_distance = distance;
      }
      // Distance grows by a step a step at most: nodes that can't beat the best are passed over.
      x += std::max(0, static_cast<std::int32_t>((best_distance - distance) / lattice.geometry.resolution) - 1);
    }
  }
  return best;
}

}  // namespace

Pose2 starting_pose(const World& world, double robot_radius) {
  const SegmentIndex index(solid_segments(world));
  std::uint32_t largest = DiscLattice::kFree;
  if (!index.segments().empty() && robot_radius > kBumperGive) {
    DiscLattice lattice(nodes_around(index.segments(), robot_radius));
    const double radius = robot_radius - kBumperGive;
    for (const SolidSegment& solid : index.segments()) block_near(lattice, solid.segment, radius);
    for (const Furniture& furniture : world.furniture) {
      for (const Polygon& part : furniture.parts) block_inside(lattice, part);
    }
    for (const Polygon& cliff : world.cliffs) {
      for (std::size_t i = 0; i < cliff.size(); ++i) {
        block_near(lattice, {cliff[i], cliff[(i + 1) % cliff.size()]}, radius);
      }
      block_inside(lattice, cliff);
    }
    // The margin joins all that is open to the outside.
    flood(lattice, {1, 1}, kOutside, Neighbours::Four);
    largest = label_parts(lattice);
    if (largest != DiscLattice::kFree) {
      const Point2 place = roomy_node(lattice, largest, index);
      return {place.x(), place.y(), 0.0};
    }
  }
  throw Error("no closed room of the world has room for a robot of " + std::to_string(robot_radius) +
              " m radius; want one, or a start");
}

}  // namespace scrubjay
