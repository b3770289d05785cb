#include <algorithm>
#include <cmath>
#include <scrubjay/simulation/simulated_turtlebot.hpp>

#include "battery_pack.hpp"
#include "disc_motion.hpp"
#include "lidar_sensing.hpp"

namespace scrubjay::sim {
namespace {

constexpr double kSight = 0.1;  // how far beyond its shell a body without near senses looks for contact [m]

/// The noise of this kind of robot: steps and dead band of the profiles are those of a Create 2's motors, while these
/// servos hold any speed to within 0.229 turns a minute (XL430-W250, e-manual), 0.8 mm/s.
NoiseProfile without_speed_steps(NoiseProfile noise) {
  noise.speed_step = 0.0;
  noise.speed_deadband = 0.0;
  return noise;
}

/// A wheel's encoder, which reads whole counts.
class CountedWheel {
 public:
  /// Travel since the call before, when the wheel has rolled as far as that since the start [m].
  double advance(double rolled, double metres_per_count) {
    const auto count = static_cast<std::int64_t>(std::floor(rolled / metres_per_count));
    const std::int64_t step = count - count_;
    count_ = count;
    return static_cast<double>(step) * metres_per_count;
  }

 private:
  std::int64_t count_ = 0;
};

}  // namespace

struct SimulatedTurtlebot::State {
  State(const World& world, const SegmentIndex& index, const RobotSpec& s, const NoiseProfile& noise,
        const Random& random, const Pose2& start, const TurtlebotOptions& options)
      : spec(s),
        motion(world, index, s, noise, draw_errors(noise, index, random), random, start, s.model.radius + kSight),
        battery(charged_battery(s.battery, 1.0)) {
    if (s.model.lidar) {
      lidar.emplace(index, *s.model.lidar, noise, random.fork(kLidar), kTick, options.motion_distortion, start);
    }
  }

  RobotSpec spec;
  DiscMotion motion;
  std::optional<LidarSensing> lidar;
  WheelSpeeds wanted;
  CountedWheel left;
  CountedWheel right;
  Battery battery;
};

SimulatedTurtlebot::SimulatedTurtlebot(const World& world, const SegmentIndex& index, const RobotSpec& spec,
                                       const NoiseProfile& noise, const Random& random, const Pose2& start,
                                       const TurtlebotOptions& options)
    : state_(std::make_unique<State>(world, index, spec, without_speed_steps(noise), random, start, options)) {}

SimulatedTurtlebot::~SimulatedTurtlebot() = default;

const Truth& SimulatedTurtlebot::truth() const {
  return state_->motion.truth();
}

std::optional<Frame> SimulatedTurtlebot::next() {
  State& s = *state_;
  const RobotModel& model = s.spec.model;
  s.motion.roll(s.wanted, kTick);
  s.motion.settle(s.motion.surroundings().clearance() < model.radius);
  use_battery(s.spec, s.motion.speeds(), false, kTick, s.battery);

  Frame frame;
  // Whole milliseconds divided once, so that it is the double that a recording gives back.
  frame.stamp = static_cast<double>(20 * s.motion.truth().ticks) / 1000.0;
  frame.left_travel = s.left.advance(s.motion.rolled().left, model.drive.metres_per_count());
  frame.right_travel = s.right.advance(s.motion.rolled().right, model.drive.metres_per_count());
  frame.battery = s.battery;
  if (s.lidar) frame.scan = s.lidar->tick(s.motion.truth().pose, frame.stamp);
  return frame;
}

void SimulatedTurtlebot::drive(const Motion& motion) {
  const RobotModel& model = state_->spec.model;
  const bool sound = std::isfinite(motion.linear) && std::isfinite(motion.angular);
  const double linear = sound ? motion.linear : 0.0;
  const double angular = sound ? motion.angular : 0.0;
  const double half = 0.5 * model.drive.wheel_separation * angular;
  const double excess =
      std::max({1.0, std::fabs(linear) / model.max_linear_speed, std::fabs(angular) / model.max_angular_speed,
                (std::fabs(linear) + std::fabs(half)) / model.max_wheel_speed});
  state_->wanted = {(linear - half) / excess, (linear + half) / excess};
}

void SimulatedTurtlebot::stop() {
  state_->wanted = {};
}

}  // namespace scrubjay::sim
