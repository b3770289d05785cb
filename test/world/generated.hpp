/// \file
/// Random segments and houses, the same everywhere.
#pragma once

#include <scrubjay/geometry/random.hpp>
#include <scrubjay/world/world.hpp>
#include <vector>

namespace scrubjay::test {

inline Point2 random_point(Random& random, double low, double high) {
  const double x = random.uniform(low, high);
  return {x, random.uniform(low, high)};
}

/// Segments of all slopes up to `length` long in a square of `side` metres; every third is axis-parallel, every tenth
/// begins where the one before ended.
inline std::vector<SolidSegment> random_segments(Random& random, std::size_t count, double side, double length) {
  std::vector<SolidSegment> segments;
  for (std::size_t i = 0; i < count; ++i) {
    const Point2 a = i % 10 == 9 ? segments.back().segment.b : random_point(random, 0.0, side);
    Point2 along = random_point(random, -length, length);
    if (i % 3 == 0) along[static_cast<int>(i / 3 % 2)] = 0.0;
    segments.push_back({{a, a + along}, static_cast<std::uint32_t>(i)});
  }
  return segments;
}

/// A house of `rooms` x `rooms` square rooms of `side` metres, each wall with a doorway, each room with furniture:
/// about eight segments a room.
inline World random_house(Random& random, int rooms, double side) {
  World world;
  for (int i = 0; i <= rooms; ++i) {
    for (int j = 0; j < rooms; ++j) {
      const double line = i * side;
      const double from = j * side;
      const double door = from + random.uniform(0.3, side - 1.2);
      const bool outer = i == 0 || i == rooms;
      const double end = from + side;
      if (outer) {
        world.walls.push_back({{{line, from}, {line, end}}});
        world.walls.push_back({{{from, line}, {end, line}}});
      } else {
        world.walls.push_back({{{line, from}, {line, door}}});
        world.walls.push_back({{{line, door + 0.9}, {line, end}}});
        world.walls.push_back({{{from, line}, {door, line}}});
        world.walls.push_back({{{door + 0.9, line}, {end, line}}});
      }
      if (i == rooms) continue;
      const Point2 center = Point2(line, from) + random_point(random, 1.0, side - 1.0);
      const Point2 size = random_point(random, 0.4, 1.2);
      world.furniture.push_back({"box", {box(center, size, random.uniform(0.0, 1.0))}});
    }
  }
  return world;
}

}  // namespace scrubjay::test
