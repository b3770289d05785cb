#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <octomap/OcTree.h>

#include <io/temporary_folder.hpp>
#include <random>
#include <scrubjay/error.hpp>
#include <scrubjay/io/octomap_file.hpp>

namespace scrubjay {
namespace {

using testing::HasSubstr;

OccupancyGrid random_map(unsigned seed, std::int32_t width, std::int32_t height, double resolution) {
  OccupancyGrid map;
  map.geometry = {resolution, {-7 * resolution, -3 * resolution}, width, height};
  std::mt19937 random(seed);
  for (std::size_t i = 0; i < map.geometry.size(); ++i) {
    map.cells.push_back(static_cast<Occupancy>(static_cast<int>(random() % 102) - 1));
  }
  return map;
}

/// What a voxel should be: 1 occupied, 0 free, -1 unknown.
int wanted(const OccupancyGrid& map, CellIndex cell, int layer, int layers) {
  if (!map.geometry.contains(cell) || layer < 0 || layer >= layers) return -1;
  const Occupancy value = map.view()[cell];
  if (value >= 65) return 1;
  return value >= 0 && value <= 19 && layer == 0 ? 0 : -1;
}

int found(const octomap::OcTree& tree, const Point2& center, int layer) {
  const double z = (layer + 0.5) * tree.getResolution();
  const octomap::OcTreeNode* node = tree.search(center.x(), center.y(), z);
  if (node == nullptr) return -1;
  return tree.isNodeOccupied(node) ? 1 : 0;
}

void expect_same(const octomap::OcTree& tree, const OccupancyGrid& map, int layers) {
  ASSERT_NEAR(tree.getResolution(), map.geometry.resolution, 1e-9);
  for (CellIndex cell{-2, 0}; cell.x < map.geometry.width + 2; ++cell.x) {
    for (cell.y = -2; cell.y < map.geometry.height + 2; ++cell.y) {
      for (int layer = -2; layer < layers + 2; ++layer) {
        ASSERT_EQ(found(tree, map.geometry.center(cell), layer), wanted(map, cell, layer, layers))
            << cell.x << ", " << cell.y << ", " << layer;
      }
    }
  }
}

TEST(OctomapFileTest, IsReadBackByOctoMapVoxelByVoxel) {
  const TemporaryFolder folder;
  for (unsigned seed = 0; seed < 5; ++seed) {
    const double resolution = seed % 2 == 0 ? 0.05 : 0.1;
    const OccupancyGrid map = random_map(seed, 31, 17, resolution);
    write_octomap(folder / "map.bt", map, 6 * resolution);
    octomap::OcTree tree(1.0);
    ASSERT_TRUE(tree.readBinary((folder / "map.bt").string()));
    expect_same(tree, map, 6);
  }
}

TEST(OctomapFileTest, IsTheSameFileForTheSameMap) {
  const TemporaryFolder folder;
  const OccupancyGrid map = random_map(9, 40, 40, 0.05);
  write_octomap(folder / "a.bt", map, 0.5);
  write_octomap(folder / "b.bt", map, 0.5);
  EXPECT_EQ(content_of(folder / "a.bt"), content_of(folder / "b.bt"));
  EXPECT_EQ(folder.file_count(), 2u) << "and nothing is left beside it";
}

TEST(OctomapFileTest, RoundsTheHeightUpToWholeVoxels) {
  const TemporaryFolder folder;
  const OccupancyGrid map = random_map(3, 5, 5, 0.05);
  for (const auto& [height, layers] : {std::pair{0.01, 1}, {0.05, 1}, {0.051, 2}, {0.15, 3}, {1.0, 20}}) {
    write_octomap(folder / "map.bt", map, height);
    octomap::OcTree tree(1.0);
    ASSERT_TRUE(tree.readBinary((folder / "map.bt").string()));
    expect_same(tree, map, layers);
  }
}

TEST(OctomapFileTest, MovesAMapThatLiesBetweenVoxelsToTheNearest) {
  const TemporaryFolder folder;
  OccupancyGrid map = random_map(4, 6, 6, 0.1);
  OccupancyGrid moved = map;
  moved.geometry.origin += Point2(0.03, -0.04);
  write_octomap(folder / "moved.bt", moved, 0.1);
  octomap::OcTree tree(1.0);
  ASSERT_TRUE(tree.readBinary((folder / "moved.bt").string()));
  expect_same(tree, map, 1);
}

TEST(OctomapFileTest, PrintsNothing) {
  const TemporaryFolder folder;
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  write_octomap(folder / "map.bt", random_map(1, 10, 10, 0.05), 1.0);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(OctomapFileTest, RefusesWhatNoTreeCanHold) {
  const TemporaryFolder folder;
  const auto complaint = [&](const OccupancyGrid& map, double height) {
    return message_of([&] { write_octomap(folder / "map.bt", map, height); });
  };
  const OccupancyGrid map = random_map(1, 4, 4, 0.05);
  EXPECT_THAT(complaint(map, 0.0), HasSubstr("height is 0; want a positive length in metres"));
  EXPECT_THAT(complaint(map, std::nan("")), HasSubstr("height is nan"));
  OccupancyGrid far = map;
  far.geometry.origin.x() = 1700.0;
  EXPECT_THAT(complaint(far, 1.0), HasSubstr("want less than 1638 m"));
  EXPECT_THAT(message_of([&] { write_octomap(folder / "no/map.bt", map, 1.0); }), HasSubstr("no/map.bt"));
  EXPECT_EQ(folder.file_count(), 0u);
}

}  // namespace
}  // namespace scrubjay
