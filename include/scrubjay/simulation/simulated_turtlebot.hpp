/// \file
/// A simulated robot with wheel encoders and a lidar: TurtleBot3.
#pragma once

#include <memory>
#include <scrubjay/robot/robot.hpp>
#include <scrubjay/simulation/noise.hpp>
#include <scrubjay/simulation/robot_spec.hpp>
#include <scrubjay/simulation/truth.hpp>
#include <scrubjay/world/segment_index.hpp>
#include <scrubjay/world/world.hpp>

namespace scrubjay::sim {

struct TurtlebotOptions {
  /// Each beam is measured at its own time within the lidar's turn. Otherwise all are, at once, when the turn ends.
  bool motion_distortion = false;
};

/// Gives frames by itself, without an Open Interface: what its wheels rolled in whole encoder counts and, as often as
/// its lidar turns around, a scan. It has no bumper, and nothing that looks down: what it runs into is for the truth to
/// tell, and a cliff holds it for good.
///
/// A beam that meets nothing within range reads infinity; one that meets something too near to be measured, minus
/// infinity (REP-117). Lidars see what blocks a robot, and nothing else: neither docks nor cliffs.
///
/// Same world, spec, noise, generator and motions: same frames to the bit.
class SimulatedTurtlebot final : public Robot {
 public:
  /// Time advances by ticks of this [s]; the control board publishes as often.
  static constexpr double kTick = 0.020;

  /// `world` and `index` (of the world's solid segments) must outlive it, and may be shared with others.
  SimulatedTurtlebot(const World& world, const SegmentIndex& index, const RobotSpec& spec, const NoiseProfile& noise,
                     const Random& random, const Pose2& start, const TurtlebotOptions& options = {});
  ~SimulatedTurtlebot() override;

  /// Advances by a tick. There is no end. A scan's ranges are good until the next scan.
  std::optional<Frame> next() override;
  /// A motion beyond the base's linear or angular speed, or a wheel's, is slowed as a whole, so that the curve stays.
  /// What isn't a number stands still.
  void drive(const Motion& motion) override;
  void stop() override;

  /// `bumps` counts what it ran into. The reference stays good as long as the robot.
  const Truth& truth() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace scrubjay::sim
