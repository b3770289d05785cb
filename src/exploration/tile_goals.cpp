#include <algorithm>
#include <cmath>
#include <limits>
#include <scrubjay/exploration/tile_goals.hpp>
#include <tuple>

namespace scrubjay {
namespace {

constexpr std::uint32_t kNobody = std::numeric_limits<std::uint32_t>::max();

/// A tile that can be got to over the way points that lead back to the start.
struct Stop {
  CellIndex tile;
  double length = 0.0;             ///< of the way there [tiles]
  std::uint32_t before = kNobody;  ///< the stop that it is seen from
};

double between(CellIndex a, CellIndex b) {
  const double dx = a.x - b.x;
  const double dy = a.y - b.y;
  return std::sqrt(dx * dx + dy * dy);
}

/// Breadth first over open tiles that see each other; the stops of one level need the same number of way points.
class VisibilitySearch {
 public:
  VisibilitySearch(const TileMap& map, CellIndex from) : map_(map), seen_(map.geometry().size(), false) {
    stops_.push_back({from, 0.0, kNobody});
    if (map.geometry().contains(from)) seen_[map.geometry().index(from)] = true;
  }

  /// The first goal that a stop of this level sees, with its way.
  std::optional<TileWay> goal_in_sight(std::span<const TileGoal> ranked) const {
    for (const TileGoal& goal : ranked) {
      const std::uint32_t last = best_stop(goal.tile);
      if (last != kNobody) return way_to(goal, last);
    }
    return std::nullopt;
  }

  /// Goes on to the tiles that this level's stops see; false if there are none.
  bool next_level() {
    const std::size_t end = stops_.size();
    const GridGeometry& tiles = map_.geometry();
    for (std::int32_t y = 0; y < tiles.height; ++y) {
      for (std::int32_t x = 0; x < tiles.width; ++x) {
        const CellIndex tile{x, y};
        if (!map_.open(tile) || seen_[tiles.index(tile)]) continue;
        const std::uint32_t before = shortest(tile, end);
        if (before == kNobody) continue;
        stops_.push_back({tile, stops_[before].length + between(stops_[before].tile, tile), before});
      }
    }
    for (std::size_t i = end; i < stops_.size(); ++i) seen_[tiles.index(stops_[i].tile)] = true;
    level_begin_ = end;
    ++way_points_;
    return end < stops_.size();
  }

 private:
  /// One way point is to be near the goal, as in the original; more are to make the way short.
  std::uint32_t best_stop(CellIndex goal) const {
    if (way_points_ != 1) return shortest(goal, stops_.size());
    return best(goal, stops_.size(), [&](const Stop& stop) { return between(stop.tile, goal); });
  }
  std::uint32_t shortest(CellIndex tile, std::size_t end) const {
    return best(tile, end, [&](const Stop& stop) { return stop.length + between(stop.tile, tile); });
  }
  /// The stop of this level that sees the tile at the least cost.
  template <typename Cost>
  std::uint32_t best(CellIndex tile, std::size_t end, const Cost& cost) const {
    std::uint32_t found = kNobody;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = level_begin_; i < end; ++i) {
      const double now = cost(stops_[i]);
      if (now >= least || !map_.sees(stops_[i].tile, tile)) continue;
      least = now;
      found = static_cast<std::uint32_t>(i);
    }
    return found;
  }
  TileWay way_to(const TileGoal& goal, std::uint32_t last) const {
    TileWay way{goal, {}};
    for (std::uint32_t i = last; stops_[i].before != kNobody; i = stops_[i].before) {
      way.way_points.push_back(stops_[i].tile);
    }
    std::reverse(way.way_points.begin(), way.way_points.end());
    return way;
  }

  const TileMap& map_;
  std::vector<Stop> stops_;
  std::size_t level_begin_ = 0;
  int way_points_ = 0;
  std::vector<bool> seen_;
};

}  // namespace

double tile_priority(double distance, double undecided_share, double ideal) {
  const double off = ideal - distance;
  return exp(-off * off) * undecided_share;
}

std::vector<TileGoal> ranked_goals(const TileMap& map, std::span<const CellIndex> tiles, const Point2& robot,
                                   double ideal_distance) {
  std::vector<TileGoal> goals;
  goals.reserve(tiles.size());
  for (const CellIndex tile : tiles) {
    const double distance = std::sqrt((map.geometry().center(tile) - robot).squaredNorm());
    goals.push_back({tile, distance, tile_priority(distance, map.undecided_share(tile), ideal_distance)});
  }
  std::sort(goals.begin(), goals.end(), [](const TileGoal& a, const TileGoal& b) {
    return std::tuple(-a.priority, a.distance, a.tile.y, a.tile.x) <
           std::tuple(-b.priority, b.distance, b.tile.y, b.tile.x);
  });
  return goals;
}

std::optional<TileWay> choose_goal(const TileMap& map, CellIndex from, std::span<const TileGoal> ranked,
                                   int max_way_points) {
  if (ranked.empty()) return std::nullopt;
  VisibilitySearch search(map, from);
  for (int way_points = 0;; ++way_points) {
    if (auto way = search.goal_in_sight(ranked)) return way;
    if (way_points == max_way_points || !search.next_level()) return std::nullopt;
  }
}

std::vector<bool> connected_tiles(const TileMap& map, CellIndex from) {
  const GridGeometry& tiles = map.geometry();
  std::vector<bool> connected(tiles.size(), false);
  std::vector<CellIndex> left{from};
  if (tiles.contains(from)) connected[tiles.index(from)] = true;
  while (!left.empty()) {
    const CellIndex tile = left.back();
    left.pop_back();
    for (std::int32_t y = tile.y - 1; y <= tile.y + 1; ++y) {
      for (std::int32_t x = tile.x - 1; x <= tile.x + 1; ++x) {
        const CellIndex beside{x, y};
        if (!map.open(beside) || connected[tiles.index(beside)] || !map.sees(tile, beside)) continue;
        connected[tiles.index(beside)] = true;
        left.push_back(beside);
      }
    }
  }
  return connected;
}

void GoalHistory::remember(const Point2& place) {
  past_.push_back(place);
  walking_back_ = false;
}

std::optional<Point2> GoalHistory::step_back(const Point2& robot) {
  if (past_.empty()) return std::nullopt;
  if (!walking_back_) {
    const auto nearer = [&](const Point2& a, const Point2& b) {
      return (a - robot).squaredNorm() < (b - robot).squaredNorm();
    };
    past_.erase(std::min_element(past_.begin(), past_.end(), nearer) + 1, past_.end());
    walking_back_ = true;
  }
  const Point2 place = past_.back();
  past_.pop_back();
  return place;
}

}  // namespace scrubjay
