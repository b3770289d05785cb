#include <algorithm>
#include <cmath>
#include <scrubjay/error.hpp>
#include <scrubjay/exploration/frontier_explorer.hpp>
#include <scrubjay/grid/traversal.hpp>

#include "left_words.hpp"

namespace scrubjay {
namespace {

constexpr int kLeastScans = 5;       // that a robot looks at before it says that nothing is to be seen
constexpr double kHere = 0.1;        // a place as near as this needs no driving [m]
constexpr double kMovingOn = 0.5;    // a frontier that only moves on isn't chosen anew more often than this [s]
constexpr double kSamePlace = 0.75;  // this near to the old goal, a frontier is what became of it [m]

constexpr const char* kOutOfBounds = "out of bounds";
constexpr const char* kNoWayThere = "no way there";

FrontierExplorerParams for_robot(const RobotModel& robot, FrontierExplorerParams params) {
  if (!robot.lidar) throw Error("strategy frontiers: the robot has no lidar; want one that has");
  params.costs.radius = robot.radius;
  params.costs.within = params.within;
  return params;
}

}  // namespace

FrontierExplorer::FrontierExplorer(const RobotModel& robot, const FrontierExplorerParams& params)
    : params_(for_robot(robot, params)),
      guard_(robot, params_.guard),
      costs_(params_.costs),
      navigator_(robot, params_.navigator),
      given_up_(params_.given_up) {}

Decision FrontierExplorer::decide(const Situation& now) {
  if (!start_) start_ = now.estimate.pose.position();
  guard_.sense(now.frame);
  const CellRect costs_changed = take_over(now);
  if (state_ == State::Looking) look(now);
  if (state_ == State::Driving && !now.changed.empty()) reconsider(now);
  switch (state_) {
    case State::Looking:
      return {{}, "looking"};
    case State::Driving:
      return {guard_.limit(drive(now, costs_changed)), "to a frontier"};
    case State::Done:
      break;
  }
  return {{}, "done", true};
}

// Keeps costs and frontiers up with the map. Returns the cells whose cost may have changed.
CellRect FrontierExplorer::take_over(const Situation& now) {
  if (now.changed.empty() && now.map.geometry == costs_.view().geometry) return {};
  frontiers_.update(now.map, now.changed);
  return costs_.update(now.map, now.changed);
}

void FrontierExplorer::look(const Situation& now) {
  if (!now.frame.scan) return;
  ++scans_;
  choose(now, scans_ > kLeastScans && now.frame.stamp - looking_since_ >= params_.look);
}

void FrontierExplorer::begin_to_look(const Situation& now) {
  state_ = State::Looking;
  looking_since_ = now.frame.stamp;
  scans_ = 0;
  goal_.reset();
}

void FrontierExplorer::reconsider(const Situation& now) {
  const double held = now.frame.stamp - chosen_stamp_;
  if (held >= params_.reconsider) return choose(now, false);
  if (!is_seen(now.map, *goal_)) return;
  const auto is_what_became_of_it = [&](const Frontier& frontier) {
    return (frontier.centroid - goal_->middle).squaredNorm() < kSamePlace * kSamePlace;
  };
  const auto frontiers = frontiers_.frontiers();
  if (held < kMovingOn && std::any_of(frontiers.begin(), frontiers.end(), is_what_became_of_it)) return;
  choose(now, false);
}

Motion FrontierExplorer::drive(const Situation& now, const CellRect& costs_changed) {
  const Navigator::Step step = navigator_.step(now, costs_.view(), costs_changed);
  switch (step.travel) {
    case Travel::Driving:
      return step.motion;
    case Travel::NoWay:
      given_up_.remember_seen(now.map, goal_->middle, now.frame.stamp);
      break;
    case Travel::Stalled:
      given_up_.remember(now.map, goal_->middle, now.estimate.pose.position());
      break;
    case Travel::Arrived:
      break;
  }
  begin_to_look(now);
  return {};
}

void FrontierExplorer::set_out(const Goal& goal) {
  goal_ = goal;
  state_ = State::Driving;
  navigator_.go_along(search_.path_to(goal.view), costs_.view());
}

// The next goal, if any. `has_looked`: the robot stood here for long enough to see all that can be seen from here.
void FrontierExplorer::choose(const Situation& now, bool has_looked) {
  chosen_stamp_ = now.frame.stamp;
  list_goals(now);
  if (has_looked) give_up_what_is_here(now);
  const Goal* best = best_goal();
  const Goal* old = goal_ && !is_seen(now.map, *goal_) ? old_goal() : nullptr;
  if (goal_ && old == nullptr) given_up_.remember_seen(now.map, goal_->middle, now.frame.stamp);
  if (best != nullptr && old != nullptr && best->cost > params_.better * old->cost) return;
  if (best != nullptr && !best->is_here) return set_out(*best);
  if (best == nullptr && has_looked) {
    if (!squeeze(now)) state_ = State::Done;
  } else if (state_ != State::Looking) {
    begin_to_look(now);
  }
}

// Takes the disc for smaller by half a cell if the way back to the start is closed; false if that is no help. Readings'
// noise thickens walls, and may close a passage behind the robot that it just fitted through. The guard keeps it from
// harm.
bool FrontierExplorer::squeeze(const Situation& now) {
  const CellIndex start = now.map.geometry.cell_at(*start_);
  if (params_.costs.margin < 0.0 || search_.cost_to(start) != PathSearch::kNever) return false;
  params_.costs.margin = -0.5 * now.map.geometry.resolution;
  costs_ = CostMap(params_.costs);
  costs_.update(now.map, cells_of(now.map.geometry));
  for (const Leftover& left : leftovers_) given_up_.forgive(left.where);
  begin_to_look(now);
  return true;
}

const FrontierExplorer::Goal* FrontierExplorer::best_goal() const {
  const auto better = [](const Goal& a, const Goal& b) { return a.score < b.score; };
  return goals_.empty() ? nullptr : &*std::min_element(goals_.begin(), goals_.end(), better);
}

// What has become of the goal that the robot drives to, if it is still there.
const FrontierExplorer::Goal* FrontierExplorer::old_goal() const {
  if (goals_.empty()) return nullptr;
  const auto away = [&](const Goal& goal) { return (goal.middle - goal_->middle).squaredNorm(); };
  const auto nearest =
      std::min_element(goals_.begin(), goals_.end(), [&](const Goal& a, const Goal& b) { return away(a) < away(b); });
  return away(*nearest) < kSamePlace * kSamePlace ? &*nearest : nullptr;
}

void FrontierExplorer::give_up_what_is_here(const Situation& now) {
  const std::size_t before = goals_.size();
  for (const Goal& goal : goals_) {
    if (goal.is_here) given_up_.remember(now.map, goal.middle, now.estimate.pose.position());
  }
  std::erase_if(goals_, [](const Goal& goal) { return goal.is_here; });
  if (goals_.size() < before && goals_.empty()) list_goals(now);  // others may be next, or it ends with these left
}

// All pieces of frontiers that are worth it: goals, or left for a reason.
void FrontierExplorer::list_goals(const Situation& now) {
  goals_.clear();
  leftovers_.clear();
  const GridGeometry& grid = now.map.geometry;
  const CellIndex here = grid.cell_at(now.estimate.pose.position());
  if (!grid.contains(here)) return;
  search_.spread(costs_.view(), here);
  const auto least_unknown =
      static_cast<std::size_t>(std::ceil(params_.min_unknown / (grid.resolution * grid.resolution)));
  const auto reach = static_cast<std::int32_t>(std::ceil(params_.piece / grid.resolution));
  for (const Frontier& frontier : frontiers_.frontiers()) {
    for (const FrontierPiece& piece : cut(frontier, reach)) {
      if (piece.length(grid.resolution) < params_.min_length) continue;
      if (borders_on_unknown(now.map, piece, least_unknown)) sort_in(now, piece);
    }
  }
}

void FrontierExplorer::sort_in(const Situation& now, const FrontierPiece& piece) {
  const GridGeometry& grid = now.map.geometry;
  const Point2 middle = grid.center(piece.middle);
  if (params_.within && !params_.within->contains(middle)) return leave(now, piece, kOutOfBounds);
  const auto view = approach_.nearest_reached(now.map, search_, piece.middle);
  if (!view) return leave(now, piece, kNoWayThere);
  if (!given_up_.holds(now.map, middle)) return add_goal(now, piece, *view);
  leave(now, piece, could_come(now.map, piece) ? kGivenUp : kTooNarrow);
}

// True if the disc fits on the free floor that leads to the piece, were there floor in the unknown.
bool FrontierExplorer::could_come(GridView<const LogOdds> map, const FrontierPiece& piece) {
  const double disc = params_.costs.radius + params_.costs.margin;
  return std::any_of(piece.cells.begin(), piece.cells.end(),
                     [&](CellIndex cell) { return approach_.nearest_reached(map, search_, cell, disc).has_value(); });
}

void FrontierExplorer::add_goal(const Situation& now, const FrontierPiece& piece, CellIndex view) {
  const GridGeometry& grid = now.map.geometry;
  const double cost = search_.cost_to(view);
  const double score = way_counts(now.map, view) * cost - params_.gain * piece.length(grid.resolution);
  Goal goal{{}, grid.center(piece.middle), view, cost, score, is_here(now, view)};
  for (const CellIndex cell : piece.cells) goal.cells.push_back(grid.center(cell));
  goals_.push_back(std::move(goal));
  leave(now, piece, kNotYet);
}

// What a metre of the way to a place counts: more where nothing is near that scans could be laid over.
double FrontierExplorer::way_counts(GridView<const LogOdds> map, CellIndex view) const {
  bool near_obstacle = false;
  visit_disc(map.geometry, map.geometry.center(view), params_.landmark,
             [&](CellIndex cell) { near_obstacle = near_obstacle || map[cell] >= kOccupiedLogOdds; });
  return near_obstacle ? 1.0 : params_.lost;
}

bool FrontierExplorer::is_here(const Situation& now, CellIndex view) const {
  const Point2 way = now.map.geometry.center(view) - now.estimate.pose.position();
  return way.norm() <= params_.navigator.tracker.reached + kHere;
}

void FrontierExplorer::leave(const Situation& now, const FrontierPiece& piece, const char* why) {
  const GridGeometry& grid = now.map.geometry;
  leftovers_.push_back({grid.center(piece.middle), piece.length(grid.resolution), why});
}

bool FrontierExplorer::is_seen(GridView<const LogOdds> map, const Goal& goal) const {
  const auto left = std::count_if(goal.cells.begin(), goal.cells.end(),
                                  [&](const Point2& cell) { return frontiers_.contains(map.geometry.cell_at(cell)); });
  return static_cast<double>(left) <= (1.0 - params_.gone) * static_cast<double>(goal.cells.size());
}

}  // namespace scrubjay
