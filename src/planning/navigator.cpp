#include <algorithm>
#include <cmath>
#include <limits>
#include <scrubjay/grid/traversal.hpp>
#include <scrubjay/planning/navigator.hpp>

namespace scrubjay {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();
// Turns and detours make a way take longer than its length at full speed, by up to about this factor.
constexpr double kSlowness = 4.0;

/// True if the line passes a cell in `within` where the disc can't be.
bool runs_into(GridView<const TravelCost> costs, const CellRect& within, const Point2& from, const Point2& to) {
  bool hit = false;
  visit_line(costs.geometry, from, to,
             [&](CellIndex cell) { hit = hit || (within.contains(cell) && costs[cell] == kNoWay); });
  return hit;
}

}  // namespace

Navigator::Navigator(const RobotModel& robot, const NavigatorParams& params)
    : params_(params), search_(2.0 * robot.radius), tracker_(robot, params.tracker) {}

void Navigator::set_out(const Point2& goal, std::optional<double> heading) {
  goal_ = goal;
  heading_ = heading;
  travel_ = Travel::Driving;
  has_path_ = false;
  tracker_.follow({});
  nearest_stamp_.reset();
  best_stamp_.reset();
  nearest_ = best_ = kFar;
  longest_ = 0.0;
}

void Navigator::go_to(const Point2& goal, std::optional<double> heading) {
  set_out(goal, heading);
}

void Navigator::go_along(const std::vector<CellIndex>& way, GridView<const TravelCost> costs) {
  set_out(costs.geometry.center(way.back()), std::nullopt);
  take(way, costs);
}

void Navigator::take(const std::vector<CellIndex>& way, GridView<const TravelCost> costs) {
  std::vector<Point2> path = simplify(costs, way);
  path.back() = goal_;  // which may lie beside its cell's centre
  tracker_.follow(std::move(path), heading_);
  has_path_ = true;
  nearest_ = tracker_.remaining();
  longest_ = std::max(longest_, nearest_);
}

bool Navigator::find_path(const Pose2& pose, GridView<const TravelCost> costs) {
  const CellIndex from = costs.geometry.cell_at(pose.position());
  const std::vector<CellIndex> way = search_.find(costs, from, costs.geometry.cell_at(goal_));
  if (way.empty()) return false;
  take(way, costs);
  return true;
}

/// True if the disc can't be somewhere on the path any more. While it is being let out of such a place, that is so with
/// every change near by, and the way out is found anew.
bool Navigator::blocked(GridView<const TravelCost> costs, const CellRect& changed) const {
  if (changed.empty()) return false;
  const std::span<const Point2> ahead = tracker_.ahead();
  for (std::size_t i = 1; i < ahead.size(); ++i) {
    if (runs_into(costs, changed, ahead[i - 1], ahead[i])) return true;
  }
  return false;
}

/// True if the rest of the path didn't become shorter for too long, or if path after path was tried without getting
/// nearer to the goal than before, for longer than the longest of them takes.
bool Navigator::stalled(double stamp) {
  const double left = tracker_.remaining();
  if (!nearest_stamp_ || left < nearest_ - params_.progress) {
    nearest_ = left;
    nearest_stamp_ = stamp;
  }
  if (!best_stamp_ || left < best_ - params_.progress) {
    best_ = left;
    best_stamp_ = stamp;
  }
  const double longest_way = params_.patience + kSlowness * longest_ / tracker_.params().max_linear;
  return stamp - *nearest_stamp_ > params_.patience || stamp - *best_stamp_ > longest_way;
}

Navigator::Step Navigator::step(const Situation& now, GridView<const TravelCost> costs, const CellRect& costs_changed) {
  if (travel_ != Travel::Driving) return {{}, travel_};
  const Pose2& pose = now.estimate.pose;
  const bool there = (goal_ - pose.position()).norm() <= params_.tracker.reached;
  if (there && !heading_) {
    travel_ = Travel::Arrived;
    return {{}, travel_};
  }
  const bool replan =
      !has_path_ || tracker_.off_path(pose.position()) > params_.off_path || blocked(costs, costs_changed);
  if (replan && !there && !find_path(pose, costs)) {
    travel_ = Travel::NoWay;
    return {{}, travel_};
  }
  if (!has_path_) {
    tracker_.follow({goal_}, heading_);
    has_path_ = true;
  }
  const PathTracker::Step step = tracker_.track(pose);
  if (step.arrived)
    travel_ = Travel::Arrived;
  else if (stalled(now.frame.stamp))
    travel_ = Travel::Stalled;
  return {travel_ == Travel::Driving ? step.motion : Motion{}, travel_};
}

}  // namespace scrubjay
