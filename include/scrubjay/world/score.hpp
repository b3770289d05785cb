/// \file
/// What a map is worth, compared with the truth.
#pragma once

#include <cstdint>
#include <scrubjay/geometry/stamped_pose.hpp>
#include <scrubjay/grid/grid_view.hpp>
#include <scrubjay/world/world.hpp>
#include <span>
#include <vector>

namespace scrubjay {

/// A cell is known as free up to this value, and occupied from kOccupiedFrom on (nav2's map saver: 0.25 and 0.65).
inline constexpr Occupancy kFreeUpTo = 25;
inline constexpr Occupancy kOccupiedFrom = 65;

/// How far the bumper gives: a disc passes a gap that is this much too narrow on either side [m].
inline constexpr double kBumperGive = 0.001;

/// The truth about a world in cells, in the map frame of a robot that started at `start`.
///
/// "Reachable" is what the robot's disc can sweep from its start: a cell counts when its centre is swept and nothing
/// solid runs through it. Where the disc fits is decided on a lattice of a quarter cell, by exact distances to the
/// segments (kBumperGive aside) and to cliffs, which it may not overhang. A piece of wall "faces" reachable space when
/// the disc can touch it, to within a node of the lattice; walls that touch, or that the disc can't pass between, are
/// one boundary.
struct GroundTruth {
  struct Cell {
    bool reachable = false;      ///< its centre can be swept, and it is no wall
    bool wall = false;           ///< something solid, or a cliff's edge, runs through it
    bool facing = false;         ///< ... that the disc can touch
    std::uint16_t boundary = 0;  ///< which boundary a facing wall belongs to, from 1 on; 0 where not facing
  };
  GridGeometry geometry;             ///< its origin is a multiple of the resolution
  std::vector<Cell> cells;           ///< row-major
  std::uint16_t boundary_count = 0;  ///< boundaries that face reachable space: 1 is the largest
  std::size_t reachable_count = 0;
};

/// Throws Error if the disc doesn't fit at `start`, if `resolution` is more than the disc's diameter, or if the world
/// is too large for that resolution. Where walls don't close a world, its truth ends about a disc beyond the last of
/// them.
GroundTruth ground_truth(const World& world, const Pose2& start, double robot_radius, double resolution);

/// Figures from 0 to 1; a ratio over nothing is 1.
struct MapScore {
  double coverage = 0.0;              ///< reachable cells known as free / reachable cells
  double iou = 0.0;                   ///< known-free and reachable / known-free or reachable
  double wall_recall = 0.0;           ///< facing wall cells with an occupied cell within one cell / facing wall cells
  double wall_precision = 0.0;        ///< occupied cells with a wall cell within one cell / occupied cells
  double followed_wall_recall = 0.0;  ///< the same recall over the boundaries that the robot followed
  double followed_wall_precision = 0.0;  ///< the same precision without occupied cells near other boundaries only
};

/// `map` holds nav_msgs values in the frame and resolution of `truth` (its extent may differ; where its cells don't
/// line up with those of `truth`, centres decide). Throws Error if the resolutions differ. `followed` has the numbers
/// of the boundaries that the robot followed; empty: all of them.
MapScore score_map(GridView<const Occupancy> map, const GroundTruth& truth,
                   const std::vector<std::uint16_t>& followed = {});

/// The boundaries along which a robot drove: it was within a hand's breadth of half of their facing walls at least.
/// `trajectory` is in the map's frame, dense enough that the robot hardly moves between two poses.
std::vector<std::uint16_t> followed_boundaries(const GroundTruth& truth, std::span<const StampedPose> trajectory,
                                               double robot_radius);

/// Where a robot starts in a plan that doesn't say: a metre from the walls in the largest part of the world that the
/// disc can reach, or as far from them as there is room, heading 0. Of such places the one with the lowest y, then x: a
/// corner, where any robot senses something to begin with. What is open to the outside, or inside of furniture or a
/// cliff, doesn't count. Throws Error if the disc fits nowhere else.
Pose2 starting_pose(const World& world, double robot_radius);

}  // namespace scrubjay
