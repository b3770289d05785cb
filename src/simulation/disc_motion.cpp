#include "disc_motion.hpp"

#include <algorithm>
#include <cmath>

namespace scrubjay::sim {

SystematicErrors draw_errors(const NoiseProfile& noise, const SegmentIndex& index, const Random& robot) {
  std::size_t pieces = 0;
  for (const SolidSegment& solid : index.segments()) pieces = std::max<std::size_t>(pieces, solid.piece + 1);
  return draw_errors(noise, pieces, robot.fork(kErrors));
}

DiscMotion::DiscMotion(const World& world, const SegmentIndex& index, const RobotSpec& spec, const NoiseProfile& noise,
                       const SystematicErrors& errors, const Random& robot, const Pose2& start, double reach)
    : radius_(spec.model.radius),
      wheel_offset_(spec.wheel_drop_offset),
      carpet_slip_(noise.carpet_slip),
      push_slip_(noise.push_slip),
      bump_kick_(noise.bump_kick),
      has_cliffs_(!world.cliffs.empty()),
      bump_random_(robot.fork(kBumps)),
      drive_(spec, noise, errors, robot.fork(kDrive)),
      physics_(index.segments(), spec.model.radius - kContactTravel, noise.wall_friction),
      surroundings_(world, index, errors.albedo, reach) {
  place(start);
}

void DiscMotion::place(const Pose2& pose) {
  truth_.pose = pose;
  surroundings_.move_to(pose.position());
}

void DiscMotion::place_others(std::span<const Disc> others) {
  physics_.place_others(others);
  surroundings_.place_others(others, truth_.pose.position());
}

void DiscMotion::roll(const WheelSpeeds& wanted, double dt, const Hindrance& hindrance) {
  ++truth_.ticks;
  lifted_ = hindrance.lifted;
  const double slip = carpet_slip_ > 0.0 ? carpet_slip_ * surroundings_.carpet_slip(truth_.pose.position()) : 0.0;
  const Roll roll = drive_.tick(wanted, slip, hindrance.wheel_stuck, dt);
  account(roll, make_way(roll, dt));
  wheel_blocked_[0] |= hindrance.wheel_stuck[0] && wanted.left != 0.0;
  wheel_blocked_[1] |= hindrance.wheel_stuck[1] && wanted.right != 0.0;
  surroundings_.move_to(truth_.pose.position());
}

/// Moves the robot, and says what share of the way it made that its wheels meant to.
double DiscMotion::make_way(const Roll& roll, double dt) {
  Pose2& pose = truth_.pose;
  if (lifted_) return 1.0;  // the wheels turn in the air
  if (hanging()) return 0.0;
  const double middle = pose.yaw + 0.5 * roll.arc.turn;
  pose.yaw = wrap_angle(pose.yaw + roll.arc.turn);
  const double reach = chord(roll.arc);
  if (reach == 0.0) return 1.0;

  const Point2 step = reach * direction(middle);
  const bool free = surroundings_.clearance() - radius_ > std::fabs(reach);
  // With nothing in reach the arc is exact; Box2D has a say only where there is contact.
  const Point2 made = free ? step : Point2(physics_.push(pose.position(), step, dt) - pose.position());
  pose.x += made.x();
  pose.y += made.y();
  truth_.distance += made.norm();
  return free ? 1.0 : std::clamp(made.dot(step) / step.squaredNorm(), 0.0, 1.0);
}

/// The encoders count what the wheels turned: all of it while they slip, less while they are held.
void DiscMotion::account(const Roll& roll, double progress) {
  const double held = (1.0 - progress) * (1.0 - push_slip_);
  const double lost = held * 0.5 * (roll.left + roll.right);
  rolled_.left += roll.left - lost;
  rolled_.right += roll.right - lost;
  const bool blocked = progress < 0.5;
  wheel_blocked_ = {blocked && roll.left != 0.0, blocked && roll.right != 0.0};
  making_way_ = !blocked && !lifted_ && roll.arc.length != 0.0;
}

void DiscMotion::settle(bool in_contact) {
  if (in_contact && !was_in_contact_) {
    ++truth_.bumps;
    if (bump_kick_ > 0.0) truth_.pose.yaw = wrap_angle(truth_.pose.yaw + bump_kick_ * bump_random_.normal());
  }
  was_in_contact_ = in_contact;
  wheel_dropped_ = {lifted_, lifted_};
  if (!has_cliffs_ || lifted_) return;
  wheel_dropped_ = {surroundings_.over_cliff(truth_.pose * Point2(0.0, wheel_offset_)),
                    surroundings_.over_cliff(truth_.pose * Point2(0.0, -wheel_offset_))};
}

}  // namespace scrubjay::sim
