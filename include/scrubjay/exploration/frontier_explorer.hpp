/// \file
/// `frontiers`: drive to where the unknown begins, until it begins nowhere that can be reached.
#pragma once

#include <optional>
#include <scrubjay/behavior/behavior.hpp>
#include <scrubjay/behavior/scan_guard.hpp>
#include <scrubjay/exploration/approach.hpp>
#include <scrubjay/exploration/frontier_map.hpp>
#include <scrubjay/exploration/frontier_piece.hpp>
#include <scrubjay/exploration/given_up.hpp>
#include <scrubjay/geometry/bounds.hpp>
#include <scrubjay/planning/cost_map.hpp>
#include <scrubjay/planning/navigator.hpp>
#include <scrubjay/planning/path_search.hpp>
#include <scrubjay/robot/robot_model.hpp>
#include <vector>

namespace scrubjay {

struct FrontierExplorerParams {
  NavigatorParams navigator;
  CostMapParams costs;  ///< their radius is the robot's; the margin goes when the way back is closed
  ScanGuardParams guard;
  GivenUpParams given_up;
  std::optional<Bounds2> within;  ///< floor to stay on, in the map's frame; frontiers outside are left
  double min_length = 0.15;       ///< shorter frontiers are readings' noise, and aren't told of [m]
  double min_unknown = 0.04;      ///< less unknown floor than this behind a frontier isn't worth a way [m^2]
  double piece = 1.5;             ///< longer frontiers are cut into pieces of about twice this [m]
  double gain = 0.3;              ///< what a metre of frontier is worth, in metres of way
  double landmark = 1.0;          ///< a place with no obstacle within this is one to lose one's pose at [m] ...
  double lost = 10.0;             ///< ... and each metre of the way there counts as many
  double gone = 0.5;              ///< a goal is as good as seen when this share of its frontier is none any more
  double look = 1.0;              ///< how long a robot stands and looks at what its scans don't change [s]
  double reconsider = 2.0;        ///< a goal is held for this long, unless it is gone [s]
  double better = 0.6;            ///< another one must cost less than this share of what is left to the old one
};

/// Goes to the piece of frontier that is best to go to, until there is none (Yamauchi 1997). The best is the one whose
/// cost less its gain is the least: cost is the length of the way that the disc would drive, gain the length of the
/// frontier (as a weighted difference, like Burgard, Moors, Stachniss, Schneider, *Coordinated Multi-Robot
/// Exploration*, 2005, eq. 5). Where all is to be seen in the end, gain is little reason to go far: Holz, Basilico,
/// Amigoni, Behnke, *Evaluating the Efficiency of Frontier-based Exploration Strategies*, 2010; Ericson, Pedro,
/// Jensfelt, *Information Gain Is Not All You Need*, 2025. It is a reason to go at all: frontiers of a few cells, and
/// those before a few unknown cells, are passed over. Places where the robot would see nothing to tell its pose by cost
/// more: it comes to know a hall from its walls inwards (localizability: Makarenko, Williams, Bourgault, Durrant-Whyte,
/// *An Experiment in Integrated Exploration*, 2002).
///
/// A goal is the place nearest to the middle of a piece, along free floor, where the disc can be. It is held until half
/// of the piece has been seen, or another one has become clearly cheaper. What doesn't vanish though the robot stands
/// there and looks, and what it can't get to, is remembered (GivenUp).
///
///     Looking --a goal--> Driving
///     Driving --seen, or another one is clearly better--> Driving
///     Driving --arrived, no way, stalled, no goal left--> Looking
///     Looking --no goal, and has looked for long enough--> Done
class FrontierExplorer final : public Behavior {
 public:
  /// Throws Error if the robot has no lidar.
  explicit FrontierExplorer(const RobotModel& robot, const FrontierExplorerParams& params = {});

  Decision decide(const Situation& situation) override;
  std::span<const Leftover> leftovers() const override { return leftovers_; }
  std::span<const Point2> plan() const override { return goal_ ? navigator_.path() : std::span<const Point2>(); }

 private:
  enum class State : std::uint8_t { Looking, Driving, Done };
  /// A piece of frontier, and where to see it from.
  struct Goal {
    std::vector<Point2> cells;  ///< the piece's: points, as a map that grows moves its cells
    Point2 middle;              ///< of the piece
    CellIndex view;             ///< passable, of the map when this was chosen
    double cost;                ///< of the way there [m]
    double score;               ///< cost less gain; the lowest is the best [m]
    bool is_here;               ///< the robot stands there, as good as
  };

  CellRect take_over(const Situation& now);
  void look(const Situation& now);
  void reconsider(const Situation& now);
  Motion drive(const Situation& now, const CellRect& costs_changed);
  void begin_to_look(const Situation& now);
  void set_out(const Goal& goal);
  void choose(const Situation& now, bool has_looked);
  bool squeeze(const Situation& now);
  const Goal* best_goal() const;
  const Goal* old_goal() const;
  void give_up_what_is_here(const Situation& now);

  void list_goals(const Situation& now);
  void sort_in(const Situation& now, const FrontierPiece& piece);
  void add_goal(const Situation& now, const FrontierPiece& piece, CellIndex view);
  bool could_come(GridView<const LogOdds> map, const FrontierPiece& piece);
  double way_counts(GridView<const LogOdds> map, CellIndex view) const;
  bool is_here(const Situation& now, CellIndex view) const;
  void leave(const Situation& now, const FrontierPiece& piece, const char* why);
  bool is_seen(GridView<const LogOdds> map, const Goal& goal) const;

  FrontierExplorerParams params_;
  ScanGuard guard_;
  CostMap costs_;
  FrontierMap frontiers_;
  PathSearch search_;
  Navigator navigator_;
  Approach approach_;
  GivenUp given_up_;

  State state_ = State::Looking;
  std::optional<Point2> start_;
  std::vector<Goal> goals_;  // all that can be reached, as of the last choice
  std::optional<Goal> goal_;
  double chosen_stamp_ = 0.0;
  double looking_since_ = 0.0;
  int scans_ = 0;  // since it began to look
  std::vector<Leftover> leftovers_;
};

}  // namespace scrubjay
