#include <array>
#include <scrubjay/io/world_reader.hpp>
#include <scrubjay/world/score.hpp>

namespace scrubjay {
namespace {

/// Steps along the corners of cells, counter-clockwise from +x.
constexpr std::array<CellIndex, 4> kSteps{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

/// Walks the border between free cells and others, with the free ones on the left.
class BorderWalk {
 public:
  explicit BorderWalk(const OccupancyGrid& map)
      : map_(map), columns_(map.geometry.width + 1), walked_(4 * corner({0, map.geometry.height + 1}), false) {}

  /// Whether a step from that corner of cells runs along the border and hasn't been walked.
  bool open(CellIndex at, int heading) const { return !walked_[edge(at, heading)] && is_border(at, heading); }

  /// All of the closed border that starts with this step: its corners, the first one again at the end.
  Wall follow(CellIndex start, int start_heading) {
    Wall wall;
    CellIndex at = start;
    int heading = start_heading;
    int before = -1;
    do {
      if (heading != before) wall.points.push_back(point(at));
      walked_[edge(at, heading)] = true;
      at = {at.x + kSteps[static_cast<std::size_t>(heading)].x, at.y + kSteps[static_cast<std::size_t>(heading)].y};
      before = heading;
      heading = next_heading(at, heading);
    } while (!(at == start && heading == start_heading));
    wall.points.push_back(wall.points.front());
    return wall;
  }

 private:
  bool free(std::int32_t x, std::int32_t y) const {
    if (!map_.geometry.contains({x, y})) return false;
    const Occupancy value = map_.cells[map_.geometry.index({x, y})];
    return value >= kFree && value <= kFreeUpTo;
  }
  bool is_border(CellIndex at, int heading) const {
    switch (heading) {
      case 0:
        return free(at.x, at.y) && !free(at.x, at.y - 1);
      case 1:
        return free(at.x - 1, at.y) && !free(at.x, at.y);
      case 2:
        return free(at.x - 1, at.y - 1) && !free(at.x - 1, at.y);
      default:
        return free(at.x, at.y - 1) && !free(at.x - 1, at.y - 1);
    }
  }
  /// Left before straight before right: where free cells meet at a corner only, they stay apart.
  int next_heading(CellIndex at, int heading) const {
    for (const int turn : {1, 0, 3}) {
      if (is_border(at, (heading + turn) % 4)) return (heading + turn) % 4;
    }
    return heading;  // not reached: a border goes on
  }
  std::size_t corner(CellIndex at) const {
    return static_cast<std::size_t>(at.y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(at.x);
  }
  std::size_t edge(CellIndex at, int heading) const { return 4 * corner(at) + static_cast<std::size_t>(heading); }
  Point2 point(CellIndex at) const { return map_.geometry.origin + map_.geometry.resolution * Point2(at.x, at.y); }

  const OccupancyGrid& map_;
  std::int32_t columns_;
  std::vector<bool> walked_;  ///< by corner and heading
};

}  // namespace

World world_from_map(const OccupancyGrid& map) {
  World world;
  BorderWalk walk(map);
  // Every closed border runs to the right along the top of something solid, somewhere.
  for (std::int32_t y = 0; y <= map.geometry.height; ++y) {
    for (std::int32_t x = 0; x <= map.geometry.width; ++x) {
      // The first step of a border that this finds starts a run: a step before it would have been found first.
      if (walk.open({x, y}, 0)) world.walls.push_back(walk.follow({x, y}, 0));
    }
  }
  return world;
}

}  // namespace scrubjay
