#include <algorithm>
#include <scrubjay/simulation/roomba_body.hpp>

#include "battery_pack.hpp"
#include "disc_motion.hpp"
#include "infrared_sensing.hpp"
#include "light_sensing.hpp"

namespace scrubjay::sim {
namespace {

constexpr auto kAllCliffs = static_cast<std::uint8_t>((1u << kCliffSensorCount) - 1u);

}  // namespace

struct RoombaBody::State {
  State(const World& w, const SegmentIndex& i, const RobotSpec& s, const NoiseProfile& n, const Random& random,
        const SystematicErrors& errors, const Pose2& start, const RobotFaults& f)
      : world(w),
        index(i),
        spec(s),
        faults(f),
        light(s, n, errors, random.fork(kLight)),
        motion(w, i, s, n, errors, random, start, light.reach()) {
    senses.battery = charged_battery(spec.battery, faults.battery);
  }

  void suffer();
  void feel_motion();
  void feel_bumper();
  void feel_floor();
  void feel_wall(const SinCos& turn);

  const World& world;
  const SegmentIndex& index;
  RobotSpec spec;
  RobotFaults faults;
  Hindrance hindrance;
  LightSensing light;
  DiscMotion motion;
  BodySenses senses;
};

RoombaBody::RoombaBody(const World& world, const SegmentIndex& index, const RobotSpec& spec, const NoiseProfile& noise,
                       const Random& random, const Pose2& start, const RobotFaults& faults)
    : state_(std::make_unique<State>(world, index, spec, noise, random, draw_errors(noise, index, random), start,
                                     faults)) {}

RoombaBody::~RoombaBody() = default;

void RoombaBody::place(const Pose2& pose) {
  state_->motion.place(pose);
}

const Truth& RoombaBody::truth() const {
  return state_->motion.truth();
}

const BodySenses& RoombaBody::tick(const WheelSpeeds& wanted) {
  State& s = *state_;
  s.suffer();
  s.motion.roll(wanted, kTick, s.hindrance);
  s.feel_bumper();
  s.motion.settle(s.senses.bump_left || s.senses.bump_right);
  s.feel_motion();
  s.feel_floor();
  const Pose2& pose = s.motion.truth().pose;
  const SinCos turn = sin_cos(pose.yaw);
  if (s.spec.model.has_light_sensors) s.light.sense(pose.position(), turn, s.motion.surroundings(), s.senses);
  s.feel_wall(turn);
  if (s.world.dock || !s.world.virtual_walls.empty()) {
    sense_infrared(s.world, s.index, s.spec.infrared, pose, s.senses);
  }
  use_battery(s.spec, s.motion.speeds(), s.senses.docked, kTick, s.senses.battery);
  return s.senses;
}

void RoombaBody::place_others(std::span<const Disc> others) {
  state_->motion.place_others(others);
}

/// The faults of the tick that begins.
void RoombaBody::State::suffer() {
  const double time = static_cast<double>(motion.truth().ticks) * kTick;
  hindrance.lifted = faults.lifted.contains(time);
  for (std::size_t i = 0; i < 2; ++i) hindrance.wheel_stuck[i] = faults.stuck_wheel[i].contains(time);
}

void RoombaBody::State::feel_motion() {
  senses.left_rolled = motion.rolled().left;
  senses.right_rolled = motion.rolled().right;
  senses.wheel_blocked = motion.wheel_blocked();
  senses.making_way = motion.making_way();
  senses.wheel_drop_left = motion.wheel_dropped()[0];
  senses.wheel_drop_right = motion.wheel_dropped()[1];
}

void RoombaBody::State::feel_bumper() {
  senses.bump_left = senses.bump_right = false;
  const Surroundings& surroundings = motion.surroundings();
  if (surroundings.clearance() >= spec.model.radius) return;
  const Pose2& pose = motion.truth().pose;
  const BumperModel& bumper = spec.model.bumper;
  for (const NearSegment& near : surroundings.segments()) {
    if (near.distance >= spec.model.radius) continue;
    const Point2 contact = near.nearest - pose.position();
    const double bearing = angle_difference(atan2(contact.y(), contact.x()), pose.yaw);
    senses.bump_left |= bearing >= bumper.half_from && bearing <= bumper.half_to;
    senses.bump_right |= -bearing >= bumper.half_from && -bearing <= bumper.half_to;
  }
}

void RoombaBody::State::feel_floor() {
  const Pose2& pose = motion.truth().pose;
  senses.cliff_flags = hindrance.lifted ? kAllCliffs : std::uint8_t{0};
  if (!hindrance.lifted && !world.cliffs.empty()) {
    for (std::size_t i = 0; i < spec.model.cliff_sensors.size(); ++i) {
      if (motion.surroundings().over_cliff(pose * spec.model.cliff_sensors[i])) {
        senses.cliff_flags |= static_cast<std::uint8_t>(1u << i);
      }
    }
  }
  senses.dirt = world.dirt.empty() ? std::uint8_t{0} : motion.surroundings().dirt(pose.position());
}

void RoombaBody::State::feel_wall(const SinCos& turn) {
  const WallSensorSpec& wall = spec.wall;
  const Surroundings& surroundings = motion.surroundings();
  const Pose2& pose = motion.truth().pose;
  senses.wall_signal = 0.0;
  senses.wall = false;
  if (surroundings.clearance() > wall.mount.position().norm() + wall.max_range) return;
  const Point2 mount = wall.mount.position();
  const Point2 origin = pose.position() + Point2(turn.cos * mount.x() - turn.sin * mount.y(),
                                                 turn.sin * mount.x() + turn.cos * mount.y());
  const Point2 along = direction(pose.yaw + wall.mount.yaw);
  double range = wall.max_range;
  for (const NearSegment& near : surroundings.segments()) range = std::min(range, ray_hit(near.segment, origin, along));
  if (range >= wall.max_range) return;
  senses.wall = range >= wall.min_range;
  senses.wall_signal = wall.max_signal * (1.0 - range / wall.max_range);
}

}  // namespace scrubjay::sim
