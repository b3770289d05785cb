#include <algorithm>
#include <cmath>
#include <scrubjay/simulation/roomba_body.hpp>

#include "contact_physics.hpp"
#include "drive_train.hpp"
#include "infrared_sensing.hpp"
#include "light_sensing.hpp"
#include "surroundings.hpp"

namespace scrubjay::sim {
namespace {

// The bumper closes this far before the shell stops [m]: whatever blocks the robot is felt.
constexpr double kBumperTravel = 1e-3;

enum Stream : std::uint64_t { kErrors, kDrive, kLight, kBumps };

}  // namespace

struct RoombaBody::State {
  State(const World& w, const SegmentIndex& i, const RobotSpec& s, const NoiseProfile& n, const Random& random,
        const SystematicErrors& errors, const Pose2& start)
      : world(w),
        index(i),
        spec(s),
        noise(n),
        bump_random(random.fork(kBumps)),
        drive(s, n, errors, random.fork(kDrive)),
        light(s, n, errors, random.fork(kLight)),
        physics(i.segments(), s.model.radius - kBumperTravel, n.wall_friction),
        surroundings(w, i, errors.albedo, light.reach()) {
    truth.pose = start;
    senses.battery = {spec.battery.full_voltage, 0.0, spec.battery.capacity, spec.battery.capacity, 25.0, false};
    surroundings.move_to(start.position());
  }

  void move(const WheelSpeeds& wanted);
  double make_way(const Roll& roll);
  void account(const Roll& roll, double progress);
  void feel_bumper();
  void feel_floor();
  void feel_wall(const SinCos& turn);
  void feel_battery();

  const World& world;
  const SegmentIndex& index;
  RobotSpec spec;
  NoiseProfile noise;
  Random bump_random;
  DriveTrain drive;
  LightSensing light;
  ContactPhysics physics;
  Surroundings surroundings;
  Truth truth;
  BodySenses senses;
};

RoombaBody::RoombaBody(const World& world, const SegmentIndex& index, const RobotSpec& spec, const NoiseProfile& noise,
                       const Random& random, const Pose2& start) {
  std::size_t pieces = 0;
  for (const SolidSegment& solid : index.segments()) pieces = std::max<std::size_t>(pieces, solid.piece + 1);
  const SystematicErrors errors = draw_errors(noise, pieces, random.fork(kErrors));
  state_ = std::make_unique<State>(world, index, spec, noise, random, errors, start);
}

RoombaBody::~RoombaBody() = default;

const Truth& RoombaBody::truth() const {
  return state_->truth;
}

const BodySenses& RoombaBody::tick(const WheelSpeeds& wanted) {
  State& s = *state_;
  ++s.truth.ticks;
  s.move(wanted);
  s.surroundings.move_to(s.truth.pose.position());
  s.feel_bumper();
  s.feel_floor();
  const SinCos turn = sin_cos(s.truth.pose.yaw);
  if (s.spec.model.has_light_sensors) {
    s.light.sense(s.truth.pose.position(), turn, s.surroundings, s.senses);
  }
  s.feel_wall(turn);
  if (s.world.dock || !s.world.virtual_walls.empty()) {
    sense_infrared(s.world, s.index, s.spec.infrared, s.truth.pose, s.senses);
  }
  s.feel_battery();
  return s.senses;
}

void RoombaBody::State::move(const WheelSpeeds& wanted) {
  const double slip =
      noise.carpet_slip > 0.0 ? noise.carpet_slip * surroundings.carpet_slip(truth.pose.position()) : 0.0;
  const Roll roll = drive.tick(wanted, slip, kTick);
  account(roll, make_way(roll));
}

/// Moves the robot, and says what share of the way it made that its wheels meant to.
double RoombaBody::State::make_way(const Roll& roll) {
  Pose2& pose = truth.pose;
  const bool hanging = senses.wheel_drop_left || senses.wheel_drop_right;
  if (hanging) return 0.0;
  const double middle = pose.yaw + 0.5 * roll.arc.turn;
  pose.yaw = wrap_angle(pose.yaw + roll.arc.turn);
  const double reach = chord(roll.arc);
  if (reach == 0.0) return 1.0;

  const Point2 step = reach * direction(middle);
  const bool free = surroundings.clearance() - spec.model.radius > std::fabs(reach);
  // With nothing in reach the arc is exact; Box2D has a say only where there is contact.
  const Point2 made = free ? step : Point2(physics.push(pose.position(), step, kTick) - pose.position());
  pose.x += made.x();
  pose.y += made.y();
  truth.distance += made.norm();
  return free ? 1.0 : std::clamp(made.dot(step) / step.squaredNorm(), 0.0, 1.0);
}

/// The encoders count what the wheels turned: all of it while they slip, less while they are held.
void RoombaBody::State::account(const Roll& roll, double progress) {
  const double held = (1.0 - progress) * (1.0 - noise.push_slip);
  const double lost = held * 0.5 * (roll.left + roll.right);
  senses.left_rolled += roll.left - lost;
  senses.right_rolled += roll.right - lost;
  const bool blocked = progress < 0.5;
  senses.wheel_blocked = {blocked && roll.left != 0.0, blocked && roll.right != 0.0};
  senses.making_way = !blocked && roll.arc.length != 0.0;
}

void RoombaBody::State::feel_bumper() {
  const bool was_pressed = senses.bump_left || senses.bump_right;
  senses.bump_left = senses.bump_right = false;
  if (surroundings.clearance() < spec.model.radius) {
    const BumperModel& bumper = spec.model.bumper;
    for (const NearSegment& near : surroundings.segments()) {
      if (near.distance >= spec.model.radius) continue;
      const Point2 contact = near.nearest - truth.pose.position();
      const double bearing = angle_difference(atan2(contact.y(), contact.x()), truth.pose.yaw);
      senses.bump_left |= bearing >= bumper.half_from && bearing <= bumper.half_to;
      senses.bump_right |= -bearing >= bumper.half_from && -bearing <= bumper.half_to;
    }
  }
  if (was_pressed || !(senses.bump_left || senses.bump_right)) return;
  ++truth.bumps;
  if (noise.bump_kick > 0.0) truth.pose.yaw = wrap_angle(truth.pose.yaw + noise.bump_kick * bump_random.normal());
}

void RoombaBody::State::feel_floor() {
  senses.cliff_flags = 0;
  senses.wheel_drop_left = senses.wheel_drop_right = false;
  if (!world.cliffs.empty()) {
    for (std::size_t i = 0; i < spec.model.cliff_sensors.size(); ++i) {
      if (surroundings.over_cliff(truth.pose * spec.model.cliff_sensors[i])) {
        senses.cliff_flags |= static_cast<std::uint8_t>(1u << i);
      }
    }
    senses.wheel_drop_left = surroundings.over_cliff(truth.pose * Point2(0.0, spec.wheel_drop_offset));
    senses.wheel_drop_right = surroundings.over_cliff(truth.pose * Point2(0.0, -spec.wheel_drop_offset));
  }
  senses.dirt = world.dirt.empty() ? std::uint8_t{0} : surroundings.dirt(truth.pose.position());
}

void RoombaBody::State::feel_wall(const SinCos& turn) {
  const WallSensorSpec& wall = spec.wall;
  senses.wall_signal = 0.0;
  senses.wall = false;
  if (surroundings.clearance() > wall.mount.position().norm() + wall.max_range) return;
  const Point2 mount = wall.mount.position();
  const Point2 origin = truth.pose.position() + Point2(turn.cos * mount.x() - turn.sin * mount.y(),
                                                       turn.sin * mount.x() + turn.cos * mount.y());
  const Point2 along = direction(truth.pose.yaw + wall.mount.yaw);
  double range = wall.max_range;
  for (const NearSegment& near : surroundings.segments()) range = std::min(range, ray_hit(near.segment, origin, along));
  if (range >= wall.max_range) return;
  senses.wall = range >= wall.min_range;
  senses.wall_signal = wall.max_signal * (1.0 - range / wall.max_range);
}

void RoombaBody::State::feel_battery() {
  const BatterySpec& pack = spec.battery;
  Battery& battery = senses.battery;
  const double effort = (std::fabs(drive.speeds().left) + std::fabs(drive.speeds().right)) / spec.model.max_wheel_speed;
  battery.charging = senses.docked && effort == 0.0 && battery.charge < battery.capacity;
  battery.current = battery.charging ? pack.charge_current : -(pack.idle_current + pack.drive_current * effort);
  constexpr double kHoursPerTick = kTick / 3600.0;
  battery.charge = std::clamp(battery.charge + battery.current * kHoursPerTick, 0.0, battery.capacity);
  battery.voltage = pack.empty_voltage + (pack.full_voltage - pack.empty_voltage) * battery.charge / battery.capacity;
}

}  // namespace scrubjay::sim
