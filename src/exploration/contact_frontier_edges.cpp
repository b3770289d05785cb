// What a ContactFrontier does where something is in its way: follow the edge, back off, turn away.
#include <algorithm>
#include <cmath>
#include <scrubjay/exploration/contact_frontier.hpp>
#include <scrubjay/grid/traversal.hpp>

namespace scrubjay {
namespace {

constexpr double kEscape = 4.0;  // times as patient as along other edges
constexpr double kLook = 0.5;    // between two looks at the map [s]

}  // namespace

bool ContactFrontier::edge_known(const Pose2& pose) const {
  bool known = false;
  visit_disc(trail_.geometry(), pose.position(), params_.followed, [&](CellIndex cell) { known |= trail_[cell] != 0; });
  return known;
}

void ContactFrontier::begin_edge(const Situation& now) {
  state_ = State::Edge;
  escaping_ = false;
  edge_.emplace(robot_, random_.fork(random_.next()), params_.edge);
  freed_ = gain_.freed();
  freed_way_ = way_;
  freed_stamp_ = now.frame.stamp;
}

Decision ContactFrontier::follow_edge(const Situation& now) {
  if (forbidden(now.frame) || now.frame.cliff_flags != 0 || now.frame.virtual_wall) {
    turn_back(now);
    return retreat(now);
  }
  if (now.frame.stamp - held_stamp_ > params_.held) {
    held_stamp_ = now.frame.stamp;
    begin_turn(now);
    return turn(now);
  }
  const Decision decision = edge_->decide(now);
  const CellIndex here = now.map.geometry.cell_at(now.estimate.pose.position());
  if (trail_.contains(here)) trail_.at(here) = 1;
  if (now.frame.stamp - look_stamp_ >= kLook) {
    catch_up(now);
    if (escaping_ && find_lane(now, params_.near)) return drive(now);
  }
  if (gain_.freed() > freed_ + 2) {
    freed_ = gain_.freed();
    freed_way_ = way_;
    freed_stamp_ = now.frame.stamp;
  }
  const double patience = escaping_ ? kEscape : 1.0;
  const bool in_vain = way_ - freed_way_ > patience * params_.edge_in_vain ||
                       now.frame.stamp - freed_stamp_ > patience * params_.edge_patience;
  const bool out = !costs_.allowed(now.estimate.pose.position());
  if (!decision.done && !in_vain && !out && !lost()) return decision;
  state_ = State::Choose;
  return {{}, "choosing"};
}

void ContactFrontier::begin_retreat(const Situation& now) {
  state_ = State::Retreat;
  retreat_from_ = now.estimate.pose.position();
  retreat_stamp_ = now.frame.stamp;
}

Decision ContactFrontier::retreat(const Situation& now) {
  const bool forbidden = now.frame.cliff_flags != 0 || now.frame.virtual_wall || now.frame.bumped();
  const double way = (now.estimate.pose.position() - retreat_from_).norm();
  const bool enough = way >= params_.retreat && !forbidden;
  // By the clock, since something behind it may hold it.
  if (enough) state_ = State::Choose;
  if (!enough && now.frame.stamp - retreat_stamp_ > params_.longest_retreat) begin_turn(now);
  return {{-params_.retreat_speed, 0.0}, "backing off"};
}

/// Something holds it before and behind: on the spot it can always turn.
void ContactFrontier::begin_turn(const Situation& now) {
  state_ = State::Turn;
  const double angle = random_.uniform(radians(60.0), kPi) * (random_.below(2) == 0 ? 1.0 : -1.0);
  heading_ = wrap_angle(now.estimate.pose.yaw + angle);
  deadline_ = now.frame.stamp + kPi / params_.edge.turn_rate + 2.0;
}

Decision ContactFrontier::turn(const Situation& now) {
  const double error = angle_difference(heading_, now.estimate.pose.yaw);
  if (std::fabs(error) < radians(5.0) || now.frame.stamp > deadline_) state_ = State::Choose;
  return {{0.0, std::clamp(3.0 * error, -params_.edge.turn_rate, params_.edge.turn_rate)}, "turning away"};
}

}  // namespace scrubjay
