#include <gtest/gtest.h>

#include <scrubjay/exploration/floor_layer.hpp>

namespace scrubjay {
namespace {

GridGeometry map_at(double x, double y, std::int32_t width, std::int32_t height) {
  GridGeometry map;
  map.origin = {x, y};
  map.width = width;
  map.height = height;
  return map;
}

TEST(FloorLayerTest, HoldsNothingUntilItIsWritten) {
  FloorLayer<int> layer(7);
  EXPECT_EQ((layer[{0, 0}]), 7);
  layer.follow(map_at(0.0, 0.0, 3, 2));
  EXPECT_EQ((layer[{2, 1}]), 7);
  EXPECT_EQ((layer[{3, 1}]), 7) << "outside";
}

TEST(FloorLayerTest, KeepsItsValuesInPlaceWhenTheMapGrows) {
  FloorLayer<int> layer;
  layer.follow(map_at(0.0, 0.0, 3, 2));
  layer.at({0, 1}) = 5;
  layer.at({2, 0}) = 6;
  layer.follow(map_at(-0.2, -0.1, 10, 8));
  EXPECT_EQ((layer[{4, 3}]), 5);
  EXPECT_EQ((layer[{6, 2}]), 6);
  int sum = 0;
  for (std::int32_t y = 0; y < 8; ++y) {
    for (std::int32_t x = 0; x < 10; ++x) sum += layer[{x, y}];
  }
  EXPECT_EQ(sum, 11) << "and nothing elsewhere";
}

}  // namespace
}  // namespace scrubjay
