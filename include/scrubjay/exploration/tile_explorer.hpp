/// \file
/// `tiles`: drive to the frontier tile in sight that promises most, over way points, and back when there is none.
#pragma once

#include <optional>
#include <scrubjay/behavior/behavior.hpp>
#include <scrubjay/behavior/scan_guard.hpp>
#include <scrubjay/exploration/given_up.hpp>
#include <scrubjay/exploration/tile_goals.hpp>
#include <scrubjay/exploration/tile_map.hpp>
#include <scrubjay/geometry/bounds.hpp>
#include <scrubjay/planning/cost_map.hpp>
#include <scrubjay/planning/navigator.hpp>
#include <scrubjay/planning/path_search.hpp>
#include <scrubjay/robot/robot_model.hpp>
#include <span>
#include <vector>

namespace scrubjay {

struct TileExplorerParams {
  TileParams tiles;
  double ideal_distance = 1.5;             ///< d*, to a goal [m] (Bologna, 2023/24: 1 to 2)
  bool extended_common_visibility = true;  ///< any number of way points; the original allows one
  double reach = 0.75;                     ///< a goal must have floor for the robot this near to its centre [m]
  double look_time = 1.0;                  ///< to stand at a goal before it is judged: five turns of an LDS-01 [s]
  /// A settled goal that is a frontier again is tried again if the map has changed there. Tiles are places of their
  /// own.
  GivenUpParams settled{.place = 0.1};
  /// Its radius is replaced by the robot's. The margin is wide: a lidar sees through gaps that are hard to drive
  /// through.
  CostMapParams costs{.margin = 0.05};
  NavigatorParams navigator;
  std::optional<Bounds2> within;  ///< floor to stay on, in the map's frame; goals outside are left
};

/// The exploration of a student project on a TurtleBot3 (Bologna, 2023/24), with the extension that it names and leaves
/// undone. What a goal is, tile_map.hpp says, which one is next, tile_goals.hpp. Between way points, shortest paths
/// over the map are driven: a line that is clear for a ray may be none for a disc.
///
///     Looking --time is up--> (choose) --a goal--> Driving --seen, no way, held--> (choose)
///        ^                       |  |                 |
///        |                       |  `--none in sight--+--> GoingBack --arrived--> (choose)
///        `-------- arrived ------+--------------------'
///                                `--no goal at all, or the history is exhausted--> Done
///
/// Walking back, the original looks for a goal at every place. With any number of way points, places that hang together
/// with where the robot is over open tiles show nothing new: they are passed over.
///
/// A goal that can't be reached, or stays undecided when looked at from near by, is given up until the map around it
/// changes.
class TileExplorer final : public Behavior {
 public:
  /// Throws Error if the robot has no lidar.
  explicit TileExplorer(const RobotModel& robot, const TileExplorerParams& params = {});

  Decision decide(const Situation& situation) override;
  /// Frontier tiles, as of the last choice.
  std::span<const Leftover> leftovers() const override { return leftovers_; }
  std::span<const Point2> plan() const override { return goal_ ? navigator_.path() : std::span<const Point2>(); }

 private:
  enum class State : std::uint8_t { Looking, Driving, GoingBack, Done };

  Decision look(const Situation& now);
  Decision drive(const Situation& now);
  Decision go_back(const Situation& now);
  Decision choose(const Situation& now);
  void choose_next(const Situation& now);
  bool next_leg(const Situation& now);
  bool go_back_a_step(const Situation& now);
  void find_ways(const Situation& now);
  bool set_out_for_goal(const Situation& now, const TileWay& way);
  bool set_out_for_leg(const Situation& now);
  bool set_out_for(const Situation& now, const Point2& place);
  std::optional<CellIndex> reachable_near(GridView<const LogOdds> map, const Point2& place) const;
  Navigator::Step navigate(const Situation& now);
  void stand_and_look(double stamp);
  void settle(const Situation& now, CellIndex tile);
  bool settled(const Situation& now, CellIndex tile) const;
  void list_leftovers(const Situation& now);
  bool outside(CellIndex tile) const;
  CellIndex goal_tile() const { return tiles_.geometry().cell_at(*goal_); }

  TileExplorerParams params_;
  TileMap tiles_;
  CostMap costs_;
  CellRect costs_changed_;
  PathSearch search_;
  Navigator navigator_;
  ScanGuard guard_;

  State state_ = State::Looking;
  std::optional<double> look_until_;  // none before the first piece of map [s]
  std::optional<Point2> goal_;        // centre of the tile
  std::vector<Point2> legs_;          // way points, and the goal, to be driven to one after the other
  std::size_t leg_ = 0;
  GoalHistory history_;
  GivenUp settled_;  // goals that were seen, or can't be
  std::vector<Leftover> leftovers_;
};

}  // namespace scrubjay
