/// \file
/// `contact-frontier`: the unknown floor of a house, found by a robot that can only feel and see a hand's breadth.
#pragma once

#include <optional>
#include <scrubjay/behavior/behavior.hpp>
#include <scrubjay/behavior/edge_follow.hpp>
#include <scrubjay/exploration/feelers.hpp>
#include <scrubjay/exploration/felt_costs.hpp>
#include <scrubjay/exploration/lanes.hpp>
#include <scrubjay/exploration/leftover_borders.hpp>
#include <scrubjay/exploration/pending_change.hpp>
#include <scrubjay/exploration/sweep_gain.hpp>
#include <scrubjay/exploration/wall_axis.hpp>
#include <scrubjay/geometry/bounds.hpp>
#include <scrubjay/geometry/random.hpp>
#include <scrubjay/planning/path_search.hpp>
#include <scrubjay/planning/path_tracker.hpp>
#include <scrubjay/robot/robot_model.hpp>
#include <vector>

namespace scrubjay {

/// Our own choice, tried on the worlds of this repository and on HouseExpo's plans.
struct ContactFrontierParams {
  /// How lanes are driven: a robot that turns on the spot as often as this does it briskly. The speed is known_speed.
  PathTrackerParams tracker{.max_angular = 1.5, .braking = 0.25, .reached = 0.03};
  std::optional<Bounds2> within;  ///< in the map's frame; floor outside is left
  /// How an edge is followed: as fast as it holds.
  EdgeFollowParams edge{
      .forward_speed = 0.15, .turn_rate = 0.75, .ahead_range = 0.08, .glance_spacing = radians(80.0), .one_edge = true};
  /// Of ways over known floor: beside walls they are dear, since touching one costs a turn. The radius is the robot's.
  CostMapParams costs{.margin = 0.0, .comfort = 0.15, .dearness = 2.5, .through_unknown = true};
  LaneParams lanes;
  double known_speed = 0.45;  ///< over known floor [m/s]
  /// Over unknown floor [m/s]. A cliff's corner may come under a side sensor first, 7 cm before it comes under a wheel:
  /// so fast, braking by 0.3 m/s^2, it stops before that.
  double unknown_speed = 0.19;
  double braking = 0.25;         ///< counted on [m/s^2]
  double touch_way = 0.015;      ///< something this near ahead counts as touched [m]
  double least_room = 0.012;     ///< it enters no gap that leaves it less than this, left and right together [m]
  double before_dock = 0.1;      ///< kept off from what is seen behind a dock that it faces [m]
  double push = 0.05;            ///< driven on against a bumper that stays closed, it is touched again [m]
  double retreat = 0.05;         ///< driven back from what was touched [m]
  double retreat_speed = 0.1;    ///< [m/s]
  double longest_retreat = 4.0;  ///< ... but no longer than this, since something behind may hold it [s]
  double followed = 0.15;        ///< within this of where it followed an edge, what it touches is that edge [m]
  double edge_in_vain = 1.0;     ///< along an edge that shows nothing new for so long, it turns away [m]
  double edge_patience = 40.0;   ///< ... or after this time [s]
  double held = 15.0;            ///< held at one place for so long by an edge, it turns away [s]
  double near = 2.5;             ///< lanes that begin within this are driven first [m]
  double most_refuted = 0.125;   ///< it is lost once so many of the walls that it was sure of are none any more ...
  double least_refuted = 60.0;   ///< ... and so many at least: where legs stand close, a few are mistaken [cells]
  double least_leftover = 0.15;  ///< shorter borders of unknown floor aren't worth a word [m]
  int escapes = 3;               ///< it feels its way out of where it has no way on so often, in a row
};

/// Drives lanes over unknown floor, each where it sweeps most for its time; follows each edge that it meets once
/// around; and ends when the disc could sweep nothing more that is unknown.
///
///     Choose --a lane--> Travel --at its beginning--> Lane --driven--> Choose
///     Travel, Lane --touched: an edge that is new--> Edge --closed, or nothing new along it--> Choose
///     Travel, Lane --touched: an edge that it knows--> Retreat
///     Travel, Lane, Edge --cliff, virtual wall, dock, too narrow--> Retreat --far enough--> Choose
///     Retreat, Edge --held at one place--> Turn --turned--> Choose
///     Choose --shut in--> Edge, to feel its way out --a lane--> Travel
///     Choose --nothing left to sweep, or lost--> Done
///
/// Only what a disc can sweep counts: unknown cells under the disc at a place that it can reach if all unknown floor is
/// free. Frontiers (Yamauchi, *A Frontier-Based Approach for Autonomous Exploration*, 1997) that no disc can sweep are
/// left, with the reason.
///
/// It can't know its pose better than it is told. With a pose that drifts it finds new floor where it was before, for
/// ever; it notices by the walls that it drives through, and ends.
class ContactFrontier final : public Behavior {
 public:
  ContactFrontier(const RobotModel& robot, Random random, const ContactFrontierParams& params = {});

  Decision decide(const Situation& situation) override;
  std::span<const Leftover> leftovers() const override { return leftovers_; }
  std::span<const Point2> plan() const override {
    return state_ == State::Travel ? tracker_.ahead() : std::span<const Point2>();
  }

 private:
  enum class State : std::uint8_t { Choose, Travel, Lane, Edge, Retreat, Turn, Done };

  void watch(const Situation& now);
  void catch_up(const Situation& now);
  void choose(const Situation& now);
  void set_out(const Situation& now, const Lane& lane);
  void begin_lane(const Situation& now);
  void begin_edge(const Situation& now);
  bool find_lane(const Situation& now, double reach);
  bool shut_in(const GridGeometry& map) const;
  Decision drive(const Situation& now);
  Decision follow_edge(const Situation& now);
  Decision retreat(const Situation& now);
  void begin_turn(const Situation& now);
  Decision turn(const Situation& now);
  bool touched(const Situation& now);
  bool forbidden(const Frame& frame) const;
  void meet(const Situation& now, bool no_edge);
  void turn_back(const Situation& now);
  void begin_retreat(const Situation& now);
  void end_lane(const Situation& now);
  bool edge_known(const Pose2& pose) const;
  double allowed_speed(const Situation& now) const;
  double time_for(double way) const;
  bool lost() const;
  void end(const Situation& now);

  RobotModel robot_;
  Random random_;
  ContactFrontierParams params_;

  SweepGain gain_;
  FeltCosts costs_;
  PathSearch search_;
  PathTracker tracker_;
  PendingChange changes_;           // since the layers were brought up to date
  FloorLayer<std::uint8_t> trail_;  // where it followed edges

  State state_ = State::Choose;
  Lane lane_;
  std::optional<EdgeFollow> edge_;
  Motion motion_;  // as of the last tick
  bool was_bumped_ = false;
  std::uint8_t last_cliff_flags_ = 0;
  double pushed_ = 0.0;      // way that it meant to drive on with the bumper pressed [m]
  double deadline_ = 0.0;    // of this drive [s]
  double look_stamp_ = 0.0;  // when the layers were brought up to date [s]
  Pose2 last_pose_;
  double last_stamp_ = 0.0;
  WallAxis walls_;
  double way_ = 0.0;        // driven so far [m]
  std::int64_t freed_ = 0;  // cells when the edge last showed something new
  double freed_way_ = 0.0;
  double freed_stamp_ = 0.0;
  Point2 retreat_from_{0.0, 0.0};
  double retreat_stamp_ = 0.0;
  double heading_ = 0.0;      // to turn to [rad]
  Point2 held_at_{0.0, 0.0};  // where it has been since held_stamp_, but for 2 cm
  double held_stamp_ = 0.0;
  bool escaping_ = false;         // feeling its way out of where it is shut in
  int escapes_ = 0;               // since it last found a lane by itself
  std::int64_t forgiven_at_ = 0;  // cells freed when it last forgave what it had felt
  std::vector<Leftover> leftovers_;
};

}  // namespace scrubjay
