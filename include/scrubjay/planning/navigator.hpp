/// \file
/// Reaches goals over a map that is still being made.
#pragma once

#include <optional>
#include <scrubjay/behavior/behavior.hpp>
#include <scrubjay/planning/cost_map.hpp>
#include <scrubjay/planning/path_search.hpp>
#include <scrubjay/planning/path_tracker.hpp>
#include <span>
#include <vector>

namespace scrubjay {

enum class Travel : std::uint8_t {
  Driving,
  Arrived,
  NoWay,   ///< the map leaves no way to the goal
  Stalled  ///< no nearer to the goal for too long: something holds the robot that the map doesn't show
};

struct NavigatorParams {
  PathTrackerParams tracker;
  double off_path = 0.15;  ///< farther off than this, a new path is found [m]
  double patience = 15.0;  ///< without getting nearer by `progress`, it has stalled [s]
  double progress = 0.05;  ///< [m]
};

/// Finds a path, simplifies it, tracks it, and finds another one when a new wall stands in it.
///
/// It keeps its path as long as that is free, even if a shorter one appears: so it never wavers between two.
class Navigator {
 public:
  explicit Navigator(const RobotModel& robot, const NavigatorParams& params = {});

  /// Sets out for a point, to end with this heading, if any. The path is found with the next step.
  void go_to(const Point2& goal, std::optional<double> heading = std::nullopt);
  /// Sets out along a way that was found already, from about where the robot is; not empty.
  void go_along(const std::vector<CellIndex>& way, GridView<const TravelCost> costs);
  struct Step {
    Motion motion;
    Travel travel = Travel::Driving;
  };
  /// `costs` are those of `now.map`; `costs_changed` is what CostMap::update returned for it. Once it isn't Driving any
  /// more, it stays so until it is sent elsewhere. Before it is sent anywhere, it has Arrived.
  Step step(const Situation& now, GridView<const TravelCost> costs, const CellRect& costs_changed);
  std::span<const Point2> path() const { return tracker_.ahead(); }  ///< what is still to be driven
  const Point2& goal() const { return goal_; }

 private:
  void set_out(const Point2& goal, std::optional<double> heading);
  void take(const std::vector<CellIndex>& way, GridView<const TravelCost> costs);
  bool find_path(const Pose2& pose, GridView<const TravelCost> costs);
  bool blocked(GridView<const TravelCost> costs, const CellRect& changed) const;
  bool stalled(double stamp);

  NavigatorParams params_;
  PathSearch search_;
  PathTracker tracker_;
  Point2 goal_{0.0, 0.0};
  std::optional<double> heading_;
  Travel travel_ = Travel::Arrived;
  bool has_path_ = false;
  // Progress: what is left of this path, and of any to this goal, at its least; and when that was.
  std::optional<double> nearest_stamp_;
  double nearest_ = 0.0;
  std::optional<double> best_stamp_;
  double best_ = 0.0;
  double longest_ = 0.0;  // of the paths found for this goal [m]
};

}  // namespace scrubjay
