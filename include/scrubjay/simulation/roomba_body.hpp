/// \file
/// A simulated Roomba without its firmware: wheels, shell and senses in a world.
#pragma once

#include <memory>
#include <scrubjay/simulation/body_senses.hpp>
#include <scrubjay/simulation/disc.hpp>
#include <scrubjay/simulation/noise.hpp>
#include <scrubjay/simulation/robot_faults.hpp>
#include <scrubjay/simulation/robot_spec.hpp>
#include <scrubjay/simulation/truth.hpp>
#include <scrubjay/world/segment_index.hpp>
#include <scrubjay/world/world.hpp>
#include <span>

namespace scrubjay::sim {

/// Time advances by ticks of this [s], the Open Interface's stream interval.
inline constexpr double kTick = 0.015;

/// Same world, spec, noise and generator: same senses to the bit.
class RoombaBody {
 public:
  /// `world` and `index` (of the world's solid segments) must outlive it, and may be shared with others.
  RoombaBody(const World& world, const SegmentIndex& index, const RobotSpec& spec, const NoiseProfile& noise,
             const Random& random, const Pose2& start, const RobotFaults& faults = {});
  ~RoombaBody();

  /// One tick with these wheel speeds wanted. The senses are good until the next.
  const BodySenses& tick(const WheelSpeeds& wanted);
  /// Somebody carries it to `pose`, in the world's frame; its wheels don't turn.
  void place(const Pose2& pose);
  /// Where other robots are now: they block it, and it feels and sees them. Always as many; good until the next call.
  void place_others(std::span<const Disc> others);
  const Truth& truth() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace scrubjay::sim
