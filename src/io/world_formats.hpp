/// \file
/// The text formats of worlds, told apart.
#pragma once

#include <scrubjay/world/world.hpp>

#include "yaml_field.hpp"

namespace scrubjay {

/// Reads points and lengths of worlds, and keeps count of them.
class WorldShapes {
 public:
  Point2 point(const YamlField& field);
  /// At least `least` points.
  std::vector<Point2> points(const YamlField& field, std::size_t least);
  static Pose2 pose(const YamlField& field);
  static double length(const YamlField& field);
  static double angle(const YamlField& field);

 private:
  std::size_t count_ = 0;
};

/// Our own format (docs/worlds.md).
World world_from_yaml(const YamlField& root);
/// HouseExpo: `verts` is the outline of the free space, one closed wall.
World world_from_houseexpo(const YamlField& root);

}  // namespace scrubjay
