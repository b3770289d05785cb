/// \file
/// Follow the edges of walls and furniture (Krapinec, FER Zagreb, 2025, phase 6).
#pragma once

#include <scrubjay/behavior/behavior.hpp>
#include <scrubjay/behavior/edge_sense.hpp>
#include <scrubjay/behavior/loop_closure.hpp>
#include <scrubjay/behavior/outlook.hpp>
#include <scrubjay/geometry/random.hpp>
#include <scrubjay/robot/robot_model.hpp>

namespace scrubjay {

/// Speeds are the thesis's. Ranges are light ranges from a sensor [m], chosen for the sensors' bearings: beside a wall
/// at `gap`, the side sensor reads 0.065 m and the next one 0.17 m.
struct EdgeFollowParams {
  double forward_speed = 0.1;           ///< [m/s]
  double turn_rate = 0.5;               ///< [rad/s]
  double gap = 0.025;                   ///< kept between shell and edge [m]
  double gain = 20.0;                   ///< turn per error of the side range [rad/s per m]; damped about 0.7 at 0.1 m/s
  double ahead_range = 0.06;            ///< something this near in front is an inside corner
  double clear_range = 0.14;            ///< aligned once the front sees nothing this near
  double lost_range = 0.115;            ///< the edge is lost beyond this side range
  double glance_angle = radians(35.0);  ///< turned towards a lost edge to look for it [rad]
  double glance_spacing = radians(60.0);  ///< of the way around an outer corner between two glances [rad]
  double dark_step = 0.01;            ///< kept off farther after each touch: the surface is darker than it seems [m]
  double cliff_gap = 0.06;            ///< kept off farther from a cliff: wheels are nearer to it than the shell [m]
  double cliff_turn = radians(40.0);  ///< turned away from a cliff at least, after driving back [rad]
  double retreat = 0.05;              ///< driven back from a cliff or a virtual wall, and on while it is sensed [m]
  double longest_retreat = 4.0;       ///< ... but no longer than this, since something behind may hold it [s]
  double full_turn = 2.0 * kPi;       ///< turned this far without an edge, forget it [rad]; the thesis's hundred turns
  double look_distance = 1.0;         ///< along a known edge between two looks for unknown floor [m]
  double worthwhile = 0.15;           ///< unknown floor that a drive must cross, or it was in vain [m]
  double least_drive = 0.1;           ///< a shorter drive over open floor ends in following what is in the way [m]
  int patience = 8;                   ///< drives in vain, in a row, before it ends
  bool one_edge = false;              ///< it ends with the first edge: closed, or left because it leads nowhere
  Side preferred_side = Side::Left;
  LoopClosureParams closure{};
};

/// `edge-follow`: drives to an edge, once around it, and on over unknown floor to the next one.
///
///                edge met           only the side sees it           edge lost
///        Seek ---------------> Align --------------------> Follow ------------> Orbit --a part of the way--> GlanceIn
///        ^  |                  ^ ^ ^                       |   ^                | |                             |
///        |  |                  | | +-- ahead, or touched --+   +-- seen again --+ |                             |
///        |  |                  | |                                                |                             |
///        |  |                  | +----------------- something ahead --------------+                             v
///        |  |                  +----------------- something ahead ------------------------------------------ GlanceOut
///        |  |                                                       Follow or Orbit <--turned back, way clear---+
///        |  +-- known edge, and unknown floor in sight -----+
///        +------- turned ------- Turn <---------------------+
///
///   Align, Follow, Orbit, Glance --loop closed, or known edge; and unknown floor in sight--> Turn
///   Align, Follow, Orbit, Glance --known edge, closed once more-------------------------> Turn
///   Orbit, Align                 --a full circle and no edge, or no way out-------------> Turn
///   any but Turn                 --cliff, virtual wall--> Retreat --> Align (a cliff is an edge), Turn (a fence isn't)
///   Seek                         --`patience` drives in vain, in a row--> Done
///
/// An outer corner or a table leg is passed by orbiting the edge's last seen point; every now and then the robot turns
/// towards it to look (the thesis's zig-zag). Too narrow a gap shows as something ahead: aligning makes its other side
/// the edge that is followed. An edge that was followed before, or is closed without unknown floor in sight, is
/// followed only until there is some.
class EdgeFollow final : public Behavior {
 public:
  EdgeFollow(const RobotModel& robot, Random random, const EdgeFollowParams& params = {});

  Decision decide(const Situation& situation) override;
  /// Edges that were followed all the way around.
  int loops_closed() const { return loops_closed_; }

 private:
  enum class State : std::uint8_t { Seek, Turn, Retreat, Align, Follow, Orbit, GlanceIn, GlanceOut, Done };

  void locate_edge(const Pose2& pose, const EdgeView& view);
  void transition(const Situation& now, const EdgeView& view);
  void seek(const Situation& now, const EdgeView& view);
  void begin_seek(const Situation& now);
  void retreat(const Situation& now);
  void align(const Situation& now, const EdgeView& view);
  void follow(const EdgeView& view);
  void orbit(const Situation& now, const EdgeView& view);
  void glance_in(const EdgeView& view);
  void glance_out(const EdgeView& view);

  Decision act(const Situation& now, const EdgeView& view) const;
  double follow_turn(const EdgeView& view) const;
  double orbit_turn(const Pose2& pose) const;

  void enter(State state);
  void begin_edge(const Situation& now);
  void end_drive();
  void meet_edge(const Situation& now);
  void begin_retreat(const Situation& now);
  void go_round(const Situation& now);
  void leave_edge(const Situation& now, double obstacle);
  bool turn_to_unknown(const Situation& now, double obstacle);
  void turn_to(double heading);
  bool ahead(const EdgeView& view) const;
  bool clear(const EdgeView& view) const;
  bool edge_seen(const EdgeView& view) const { return view.side <= params_.lost_range; }
  bool following() const { return state_ >= State::Retreat && state_ <= State::GlanceOut; }
  Point2 edge_in_robot(const Pose2& pose) const;

  RobotModel robot_;
  Random random_;
  EdgeFollowParams params_;
  double target_side_range_;  // of the side sensor, beside a wall at the gap

  State state_ = State::Seek;
  Side side_;
  Point2 edge_{0.0, 0.0};  // last point seen of the edge, in the map
  double turned_ = 0.0;    // in this state, towards the edge [rad]
  double orbited_ = 0.0;   // since the edge was last seen, towards it [rad]
  double last_yaw_ = 0.0;
  double target_heading_ = 0.0;
  Point2 retreat_from_{0.0, 0.0};
  double retreat_stamp_ = 0.0;
  double least_turn_ = 0.0;       // to be turned away before the edge counts as aligned [rad]
  bool fenced_ = false;           // retreating from a virtual wall
  double extra_gap_ = 0.0;        // beside a dark surface
  bool touching_ = false;         // as of the last tick
  bool new_edge_ = true;          // the loop around it hasn't begun yet
  bool known_ = false;            // it was followed before
  Point2 sought_from_{0.0, 0.0};  // where the drive over open floor began
  double last_way_ = 0.0;         // driven on it so far [m]
  double unknown_crossed_ = 0.0;  // ... over unknown floor [m]
  double looked_at_ = 0.0;        // length of the way around it when it last looked for unknown floor [m]
  int in_vain_ = 0;               // drives over open floor, in a row, that found nothing
  int loops_closed_ = 0;
  LoopClosure closure_;
};

}  // namespace scrubjay
