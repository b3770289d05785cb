#include <algorithm>
#include <cmath>
#include <scrubjay/error.hpp>
#include <scrubjay/exploration/tile_explorer.hpp>
#include <scrubjay/grid/traversal.hpp>

#include "left_words.hpp"

namespace scrubjay {
namespace {

constexpr const char* kOutside = "out of bounds";
constexpr const char* kHidden = "no way point sees it";

CostMapParams costs_for(const RobotModel& robot, const TileExplorerParams& params) {
  if (!robot.lidar) throw Error("strategy tiles: the robot has no lidar; want one that has");
  CostMapParams costs = params.costs;
  costs.radius = robot.radius;
  costs.within = params.within;
  return costs;
}

bool in_sight(GridView<const LogOdds> map, const Point2& from, const Point2& to) {
  bool clear = true;
  visit_line(map.geometry, from, to,
             [&](CellIndex cell) { clear = clear && !(map.contains(cell) && map[cell] >= kOccupiedLogOdds); });
  return clear;
}

}  // namespace

TileExplorer::TileExplorer(const RobotModel& robot, const TileExplorerParams& params)
    : params_(params),
      tiles_(params.tiles),
      costs_(costs_for(robot, params)),
      navigator_(robot, params.navigator),
      guard_(robot),
      settled_(params.settled) {}

Decision TileExplorer::decide(const Situation& situation) {
  guard_.sense(situation.frame);
  tiles_.update(situation.map, situation.changed);
  costs_changed_ = costs_.update(situation.map, situation.changed);
  switch (state_) {
    case State::Looking:
      return look(situation);
    case State::Driving:
      return drive(situation);
    case State::GoingBack:
      return go_back(situation);
    case State::Done:
      break;
  }
  return {{}, "done", true};
}

Decision TileExplorer::look(const Situation& now) {
  if (!look_until_) {
    if (now.changed.empty()) return {{}, "waiting for a map"};
    history_.remember(now.estimate.pose.position());
    look_until_ = now.frame.stamp + params_.look_time;
  }
  if (now.frame.stamp < *look_until_) return {{}, "looking"};
  if (goal_) {
    settle(now, goal_tile());
    history_.remember(now.estimate.pose.position());
  }
  return choose(now);
}

Decision TileExplorer::drive(const Situation& now) {
  const Point2 position = now.estimate.pose.position();
  if (!now.changed.empty() && !tiles_.frontier(goal_tile())) {
    settle(now, goal_tile());
    history_.remember(position);
    return choose(now);
  }
  const double side = tiles_.geometry().resolution;
  const bool passing = leg_ + 1 < legs_.size() && (legs_[leg_] - position).squaredNorm() < side * side;
  if (passing && !next_leg(now)) return choose(now);
  const Navigator::Step step = navigate(now);
  switch (step.travel) {
    case Travel::Driving:
      break;
    case Travel::Arrived:
      if (leg_ + 1 == legs_.size()) {
        stand_and_look(now.frame.stamp);
        return {{}, "looking"};
      }
      if (!next_leg(now)) return choose(now);
      break;
    case Travel::NoWay:
      // As this way closed, one to other floor near by may be open yet.
      find_ways(now);
      if (set_out_for_leg(now)) break;
      [[fallthrough]];
    case Travel::Stalled:
      settle(now, goal_tile());
      return choose(now);
  }
  return {step.motion, leg_ + 1 < legs_.size() ? "to a way point" : "to a goal"};
}

/// On to the next way point, or the goal; settles the goal if there is no way.
bool TileExplorer::next_leg(const Situation& now) {
  ++leg_;
  find_ways(now);
  if (set_out_for_leg(now)) return true;
  settle(now, goal_tile());
  return false;
}

Decision TileExplorer::go_back(const Situation& now) {
  const Navigator::Step step = navigate(now);
  if (step.travel == Travel::Driving) return {step.motion, "going back"};
  return choose(now);
}

Decision TileExplorer::choose(const Situation& now) {
  goal_.reset();
  choose_next(now);
  list_leftovers(now);
  return {{}, state_ == State::Done ? "done" : "choosing", state_ == State::Done};
}

void TileExplorer::choose_next(const Situation& now) {
  std::vector<CellIndex> tiles = tiles_.frontiers();
  std::erase_if(tiles, [&](CellIndex tile) { return outside(tile) || settled(now, tile); });
  const Point2 position = now.estimate.pose.position();
  find_ways(now);
  std::vector<TileGoal> goals = ranked_goals(tiles_, tiles, position, params_.ideal_distance);
  const int most = params_.extended_common_visibility ? kAnyNumber : 1;
  while (const auto way = choose_goal(tiles_, tiles_.geometry().cell_at(position), goals, most)) {
    if (set_out_for_goal(now, *way)) return;
    settle(now, way->goal.tile);
    std::erase_if(goals, [&](const TileGoal& goal) { return goal.tile == way->goal.tile; });
  }
  if (goals.empty() || !go_back_a_step(now)) state_ = State::Done;
}

bool TileExplorer::go_back_a_step(const Situation& now) {
  const Point2 position = now.estimate.pose.position();
  // Over any number of way points, all tiles that hang together with this one see the same goals: none.
  std::vector<bool> searched;
  if (params_.extended_common_visibility) searched = connected_tiles(tiles_, tiles_.geometry().cell_at(position));
  while (const auto place = history_.step_back(position)) {
    const std::size_t tile = tiles_.geometry().index(tiles_.geometry().cell_at(*place));
    if (!searched.empty() && searched[tile]) continue;
    if (!set_out_for(now, *place)) continue;
    state_ = State::GoingBack;
    return true;
  }
  return false;
}

bool TileExplorer::set_out_for_goal(const Situation& now, const TileWay& way) {
  goal_ = tiles_.geometry().center(way.goal.tile);
  if (!reachable_near(now.map, *goal_)) {
    goal_.reset();
    return false;
  }
  legs_.clear();
  for (const CellIndex tile : way.way_points) legs_.push_back(tiles_.geometry().center(tile));
  legs_.push_back(*goal_);
  leg_ = 0;
  state_ = State::Driving;
  return set_out_for_leg(now);
}

/// To the next way point that the robot can get to, or to the goal.
bool TileExplorer::set_out_for_leg(const Situation& now) {
  for (; leg_ < legs_.size(); ++leg_) {
    if (set_out_for(now, legs_[leg_])) return true;
  }
  return false;
}

bool TileExplorer::set_out_for(const Situation& now, const Point2& place) {
  const auto cell = reachable_near(now.map, place);
  if (cell) navigator_.go_along(search_.path_to(*cell), costs_.view());
  return cell.has_value();
}

/// From where the robot is to everywhere.
void TileExplorer::find_ways(const Situation& now) {
  const GridView<const TravelCost> costs = costs_.view();
  search_.spread(costs, costs.geometry.cell_at(now.estimate.pose.position()));
}

/// The cell nearest to a place, and in sight of it, that the last spread of search_ got to: not what is near by as the
/// crow flies, and behind a wall.
std::optional<CellIndex> TileExplorer::reachable_near(GridView<const LogOdds> map, const Point2& place) const {
  const GridGeometry& grid = map.geometry;
  const CellRect around = cells_around(grid, place, params_.reach);
  std::optional<CellIndex> found;
  double least = params_.reach * params_.reach;
  for (std::int32_t y = around.low.y; y < around.high.y; ++y) {
    for (std::int32_t x = around.low.x; x < around.high.x; ++x) {
      const CellIndex cell{x, y};
      const double squared = (grid.center(cell) - place).squaredNorm();
      if (squared >= least || !costs_.passable(cell) || search_.cost_to(cell) == PathSearch::kNever) continue;
      if (!in_sight(map, grid.center(cell), place)) continue;
      least = squared;
      found = cell;
    }
  }
  return found;
}

Navigator::Step TileExplorer::navigate(const Situation& now) {
  Navigator::Step step = navigator_.step(now, costs_.view(), costs_changed_);
  step.motion = guard_.limit(step.motion);
  return step;
}

void TileExplorer::stand_and_look(double stamp) {
  state_ = State::Looking;
  look_until_ = stamp + params_.look_time;
}

/// The goal has been seen, or it can't be from here.
void TileExplorer::settle(const Situation& now, CellIndex tile) {
  settled_.remember(now.map, tiles_.geometry().center(tile), now.estimate.pose.position());
}

bool TileExplorer::settled(const Situation& now, CellIndex tile) const {
  return settled_.holds(now.map, tiles_.geometry().center(tile));
}

bool TileExplorer::outside(CellIndex tile) const {
  return params_.within && !params_.within->contains(tiles_.geometry().center(tile));
}

void TileExplorer::list_leftovers(const Situation& now) {
  leftovers_.clear();
  for (const CellIndex tile : tiles_.frontiers()) {
    const Point2 center = tiles_.geometry().center(tile);
    const char* why = state_ == State::Done ? kHidden : kNotYet;
    if (outside(tile)) {
      why = kOutside;
    } else if (settled(now, tile)) {
      why = reachable_near(now.map, center) ? kGivenUp : kTooNarrow;
    }
    leftovers_.push_back({center, tiles_.geometry().resolution, why});
  }
}

}  // namespace scrubjay
