#include "world_formats.hpp"

namespace scrubjay {

World world_from_houseexpo(const YamlField& root) {
  WorldShapes shapes;
  World world;
  if (root.has("id")) world.name = root.at("id").text();
  Wall outline{shapes.points(root.at("verts"), 3)};
  if (outline.points.front() != outline.points.back()) outline.points.push_back(outline.points.front());
  world.walls.push_back(std::move(outline));
  return world;
}

}  // namespace scrubjay
