/// \file
/// Which frontier tile to go to next, over which way points, and where to go back to when none is left.
#pragma once

#include <optional>
#include <scrubjay/exploration/tile_map.hpp>
#include <span>
#include <vector>

namespace scrubjay {

/// P = exp(-(d* - d)^2) * F, for a tile `distance` d away with a share F of undecided cells; d* is the `ideal` distance
/// [m] (Bologna, 2023/24).
double tile_priority(double distance, double undecided_share, double ideal);

struct TileGoal {
  CellIndex tile;
  double distance = 0.0;  ///< from the robot to its centre, as the crow flies [m]
  double priority = 0.0;
};

/// The tiles as goals, the first one the best: highest priority, then nearest, then by row and column.
std::vector<TileGoal> ranked_goals(const TileMap& map, std::span<const CellIndex> tiles, const Point2& robot,
                                   double ideal_distance);

/// A goal, and the tiles to pass before it.
struct TileWay {
  TileGoal goal;
  std::vector<CellIndex> way_points;
};

/// Any number of way points.
inline constexpr int kAnyNumber = 1 << 30;

/// The goal to go to from tile `from`, and how.
///
/// A goal with a wall on the straight line is put off. If there is no other, one behind a wall is taken that can be
/// reached over a way point: an open tile that sees both robot and goal (common visibility), the one nearest to the
/// goal. Up to here that is the original, with `max_way_points` = 1. Extended common visibility goes on: way points are
/// open tiles each of which sees the next, as few as lead to any goal, and of such chains the shortest one. Of the
/// goals that need equally few, the first of `ranked` is taken. None if none can be reached like this.
std::optional<TileWay> choose_goal(const TileMap& map, CellIndex from, std::span<const TileGoal> ranked,
                                   int max_way_points);

/// The open tiles that hang together with a tile, edge to edge or corner to corner, and that tile, by index. Extended
/// common visibility finds the same goals from all of them.
std::vector<bool> connected_tiles(const TileMap& map, CellIndex from);

/// Past goals, and the way back through them (backtracking).
class GoalHistory {
 public:
  /// A goal was settled here; walking back, if it was going on, is over.
  void remember(const Point2& place);
  /// Where to go back to next. The first time, that is the nearest past goal, and those after it are dropped; then the
  /// one before it, and so on. None when the history is exhausted.
  std::optional<Point2> step_back(const Point2& robot);

 private:
  std::vector<Point2> past_;
  bool walking_back_ = false;
};

}  // namespace scrubjay
