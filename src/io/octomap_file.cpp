#include <fmt/format.h>
#include <octomap/OcTree.h>

#include <cmath>
#include <scrubjay/error.hpp>
#include <scrubjay/io/atomic_file.hpp>
#include <scrubjay/io/octomap_file.hpp>
#include <sstream>

#include "file_content.hpp"

namespace scrubjay {
namespace {

constexpr Occupancy kOccupiedFrom = 65;  // nav2's thresholds, as in map.yaml
constexpr Occupancy kFreeTo = 19;
constexpr double kVoxels = 32768.0;  // of a tree, either way from the origin along each axis

/// Key of the voxel whose lower end is nearest to `edge` [m].
int first_key(double edge, double resolution) {
  return static_cast<int>(std::floor(edge / resolution + 0.5) + kVoxels);
}

void check_extent(const std::filesystem::path& path, const GridGeometry& geometry, double height) {
  if (!(height > 0.0))
    throw Error(fmt::format("{}: height is {}; want a positive length in metres", path.string(), height));
  const double reach = kVoxels * geometry.resolution;
  const Point2 end = geometry.origin + geometry.resolution * Point2(geometry.width, geometry.height);
  const double farthest = std::max({-geometry.origin.x(), -geometry.origin.y(), end.x(), end.y(), height});
  if (!(farthest + geometry.resolution < reach)) {
    throw Error(fmt::format(
        "{}: the map reaches {:.0f} m from its origin; want less than {:.0f} m, all that OctoMap holds at {} m a voxel",
        path.string(), farthest, reach, geometry.resolution));
  }
}

octomap::OcTree tree_of(const OccupancyGrid& map, double height) {
  const GridGeometry& geometry = map.geometry;
  octomap::OcTree tree(geometry.resolution);
  const int left = first_key(geometry.origin.x(), geometry.resolution);
  const int bottom = first_key(geometry.origin.y(), geometry.resolution);
  const int floor = first_key(0.0, geometry.resolution);
  // A height of whole voxels may be a rounding error more than that.
  const int layers = std::max(1, static_cast<int>(std::ceil(height / geometry.resolution - 1e-6)));
  const auto set = [&](std::int32_t x, std::int32_t y, int layer, float log_odds) {
    const auto key = [](int index) { return static_cast<octomap::key_type>(index); };
    constexpr bool kInnerNodesLater = true;
    tree.setNodeValue(octomap::OcTreeKey(key(left + x), key(bottom + y), key(floor + layer)), log_odds,
                      kInnerNodesLater);
  };
  std::size_t i = 0;
  for (std::int32_t y = 0; y < geometry.height; ++y) {
    for (std::int32_t x = 0; x < geometry.width; ++x) {
      const Occupancy cell = map.cells[i++];
      if (cell >= kOccupiedFrom) {
        for (int layer = 0; layer < layers; ++layer) set(x, y, layer, tree.getClampingThresMaxLog());
      } else if (cell >= 0 && cell <= kFreeTo) {
        set(x, y, 0, tree.getClampingThresMinLog());
      }
    }
  }
  tree.updateInnerOccupancy();
  tree.prune();
  return tree;
}

}  // namespace

void write_octomap(const std::filesystem::path& path, const OccupancyGrid& map, double height) {
  check_extent(path, map.geometry, height);
  const octomap::OcTree tree = tree_of(map, height);
  // OctoMap's own writer makes the same head, and talks to stderr.
  std::ostringstream stream;
  stream << fmt::format("# Octomap OcTree binary file\nid {}\nsize {}\nres {}\ndata\n", tree.getTreeType(), tree.size(),
                        tree.getResolution());
  tree.writeBinaryData(stream);
  write_file_atomically(path, stream.view());
}

OctomapHead read_octomap_head(const std::filesystem::path& path) {
  const std::vector<std::uint8_t> file = read_file(path);
  const std::string text(file.begin(), file.end());
  constexpr std::string_view kTitle = "# Octomap OcTree binary file\n";
  const std::size_t data = text.find("\ndata\n");
  OctomapHead head;
  if (text.starts_with(kTitle) && data != text.npos) {
    std::istringstream lines(text.substr(kTitle.size(), data + 1 - kTitle.size()));
    for (std::string key, value; lines >> key >> value;) {
      std::istringstream number(value);
      if (key == "size") number >> head.nodes;
      if (key == "res") number >> head.resolution;
    }
  }
  if (head.resolution > 0.0) return head;
  throw Error(fmt::format("{}: no head of a binary OctoMap tree; want its title, size, res and data", path.string()));
}

}  // namespace scrubjay
