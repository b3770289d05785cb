/// \file
/// Maps as OctoMap's binary trees (`.bt`), for 3-D planners and octovis.
#pragma once

#include <cstdint>
#include <filesystem>
#include <scrubjay/mapping/occupancy_grid.hpp>

namespace scrubjay {

/// Writes `map` as a tree of voxels as large as its cells, whole or not at all.
///
/// An occupied cell (65 and more, as in nav2) is a wall from the floor, z = 0, up to `height` [m], in whole voxels. A
/// free one (0 to 19) is free in the layer on the floor alone: no robot that maps in the plane has seen the air above,
/// and a planner must not take for free what nobody saw. All else stays unknown. Cells lie where they lay, to the
/// nearest voxel; a map whose origin is a multiple of its resolution, as ours are, moves by nothing.
///
/// Throws Error if `height` isn't positive, or the map reaches farther than the 32768 voxels from the origin that a
/// tree can hold; and Error (Kind::Failure) if the file can't be written.
void write_octomap(const std::filesystem::path& path, const OccupancyGrid& map, double height);

/// What the head of a tree's file tells.
struct OctomapHead {
  double resolution = 0.0;  ///< side of a voxel [m]
  std::uint64_t nodes = 0;  ///< of the tree
};

/// Throws Error if the file can't be read, or begins otherwise than a binary tree's.
OctomapHead read_octomap_head(const std::filesystem::path& path);

}  // namespace scrubjay
