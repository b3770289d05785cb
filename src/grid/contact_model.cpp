#include <algorithm>
#include <cmath>
#include <scrubjay/grid/contact_model.hpp>
#include <scrubjay/grid/traversal.hpp>

namespace scrubjay {
namespace {

bool apart(const Pose2& a, const Pose2& b, double distance) {
  const double dx = a.x - b.x;
  const double dy = a.y - b.y;
  return !(dx * dx + dy * dy < distance * distance);  // NaN is far from everything, so that a mapper notices it
}

/// The arc of bearings that a bump leaves open, between two bearings in the robot's frame [rad].
struct Bearings {
  double from;
  double to;
};

/// Both halves close for a contact that both can feel: their overlap.
Bearings contact_bearings(const Frame& frame, const BumperModel& bumper) {
  if (frame.bump_left && frame.bump_right) return {bumper.half_from, -bumper.half_from};
  if (frame.bump_left) return {-bumper.half_from, bumper.half_to};
  return {-bumper.half_to, bumper.half_from};
}

}  // namespace

ContactModel::ContactModel(const RobotModel& robot, const ContactModelParams& params)
    : robot_(robot),
      params_(params),
      swept_(log_odds(params.swept)),
      lit_(log_odds(params.lit)),
      beam_(log_odds(params.beam)),
      no_floor_(log_odds(params.no_floor)),
      bumped_(log_odds(params.bumped)),
      bumped_blindly_(log_odds(params.bumped_blindly)) {}

bool ContactModel::moved(const Pose2& pose) const {
  return !last_swept_ || apart(pose, *last_swept_, params_.travel_step);
}

bool ContactModel::turned(const Pose2& pose) const {
  // Robots that tell whole degrees turn by just that much: no rounding error may decide.
  constexpr double kTie = 1e-9;
  return !last_sensed_ || std::fabs(angle_difference(pose.yaw, last_sensed_->yaw)) >= params_.turn_step - kTie ||
         apart(pose, *last_sensed_, params_.travel_step);
}

bool ContactModel::bump_began(const Frame& frame) const {
  return (frame.bump_left && !was_bumped_left_) || (frame.bump_right && !was_bumped_right_);
}

bool ContactModel::cliff_began(const Frame& frame) const {
  return (frame.cliff_flags & ~last_cliff_flags_) != 0;
}

bool ContactModel::wants(const Frame& frame, const Pose2& pose) const {
  return moved(pose) || turned(pose) || bump_began(frame) || cliff_began(frame);
}

void ContactModel::integrate(const Frame& frame, const Pose2& pose, GridView<LogOdds> grid) {
  if (moved(pose)) {
    mark_swept(pose, grid);
    last_swept_ = pose;
  }
  const bool sense = turned(pose);
  if (sense && robot_.has_light_sensors) mark_light(frame, pose, grid);
  if (frame.cliff_flags != 0 && (cliff_began(frame) || sense)) mark_cliffs(frame, pose, grid);
  if (frame.bumped() && (bump_began(frame) || sense)) mark_bump(frame, pose, grid);
  if (sense) last_sensed_ = pose;
  was_bumped_left_ = frame.bump_left;
  was_bumped_right_ = frame.bump_right;
  last_cliff_flags_ = frame.cliff_flags;
}

void ContactModel::mark_swept(const Pose2& pose, GridView<LogOdds> grid) const {
  // Cells that the shell only grazes may hold the wall that it grazes.
  const double certain = robot_.radius - params_.grazed * grid.geometry.resolution;
  visit_disc(grid.geometry, pose.position(), certain, [&](CellIndex c) { update_cell(grid[c], swept_); });
}

void ContactModel::mark_light(const Frame& frame, const Pose2& pose, GridView<LogOdds> grid) const {
  for (std::size_t i = 0; i < frame.light_signal.size(); ++i) {
    const double range = robot_.light.range(frame.light_signal[i]);
    if (range > params_.max_light_range) continue;
    const Pose2 sensor = pose * robot_.light.mount[i];
    const Point2 hit = sensor.position() + range * direction(sensor.yaw);
    const CellIndex end = grid.geometry.cell_at(hit);
    visit_line(grid.geometry, sensor.position(), hit, [&](CellIndex c) {
      if (grid.contains(c)) update_cell(grid[c], c == end ? lit_ : beam_);
    });
  }
}

void ContactModel::mark_cliffs(const Frame& frame, const Pose2& pose, GridView<LogOdds> grid) const {
  for (std::size_t i = 0; i < robot_.cliff_sensors.size(); ++i) {
    if ((frame.cliff_flags >> i & 1) == 0) continue;
    const CellIndex cell = grid.geometry.cell_at(pose * robot_.cliff_sensors[i]);
    if (grid.contains(cell)) update_cell(grid[cell], no_floor_);
  }
}

void ContactModel::mark_bump(const Frame& frame, const Pose2& pose, GridView<LogOdds> grid) const {
  const Bearings open = contact_bearings(frame, robot_.bumper);
  Bearings arc = open;
  LogOdds evidence = bumped_blindly_;
  // The nearest light return within the arc tells which part of it was hit: half the space to its neighbours.
  double nearest = params_.touch_range;
  for (std::size_t i = 0; robot_.has_light_sensors && i < frame.light_signal.size(); ++i) {
    const double bearing = robot_.light.mount[i].yaw;
    const double range = robot_.light.range(frame.light_signal[i]);
    if (range >= nearest || bearing < open.from || bearing > open.to) continue;
    constexpr double kHalfSpacing = radians(12.5);
    arc = {std::max(open.from, bearing - kHalfSpacing), std::min(open.to, bearing + kHalfSpacing)};
    evidence = bumped_;
    nearest = range;
  }
  // Just outside of the shell: what was hit can't be under the robot.
  const double shell = robot_.radius + 0.25 * grid.geometry.resolution;
  visit_arc(grid.geometry, pose.position(), shell, pose.yaw + arc.from, pose.yaw + arc.to, [&](CellIndex c) {
    if (grid.contains(c)) update_cell(grid[c], evidence);
  });
}

}  // namespace scrubjay
