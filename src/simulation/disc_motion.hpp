/// \file
/// A round robot on two wheels, moving among walls: what all simulated bodies have in common.
#pragma once

#include <array>
#include <scrubjay/simulation/disc.hpp>
#include <scrubjay/simulation/truth.hpp>
#include <span>

#include "contact_physics.hpp"
#include "drive_train.hpp"
#include "surroundings.hpp"

namespace scrubjay::sim {

/// Which of a robot's random numbers go where. A new reader gets a new stream: those of the others stay the same.
enum Stream : std::uint64_t { kErrors, kDrive, kLight, kBumps, kLidar };

/// The errors that this robot has in this run.
SystematicErrors draw_errors(const NoiseProfile& noise, const SegmentIndex& index, const Random& robot);

/// What keeps a robot's wheels from moving it, besides what is in its way.
struct Hindrance {
  bool lifted = false;                ///< it hangs in somebody's hands
  std::array<bool, 2> wheel_stuck{};  ///< left, right
};

/// Wheels, floor and contact. What a robot's sensors tell of it is up to its body.
class DiscMotion {
 public:
  /// The shell is felt this far before it stops [m]: whatever blocks the robot is felt.
  static constexpr double kContactTravel = 1e-3;

  /// `world` and `index` must outlive this; `reach` is how far the body looks for its surroundings [m]. `robot` is the
  /// generator of the whole robot.
  DiscMotion(const World& world, const SegmentIndex& index, const RobotSpec& spec, const NoiseProfile& noise,
             const SystematicErrors& errors, const Random& robot, const Pose2& start, double reach);

  /// What else is on the floor now, besides the world: it blocks, and is seen. Good until the next call.
  void place_others(std::span<const Disc> others);
  /// Rolls for `dt` [s] with these wheel speeds wanted, as far as nothing holds the robot; then looks around.
  void roll(const WheelSpeeds& wanted, double dt, const Hindrance& hindrance = {});
  /// Ends a tick: counts the contact that begins and lets it turn the robot, and finds out which wheels hang.
  void settle(bool in_contact);

  /// Puts the robot elsewhere. No way is counted.
  void place(const Pose2& pose);

  const Truth& truth() const { return truth_; }
  const Surroundings& surroundings() const { return surroundings_; }
  /// By the encoders' account, since the start; forwards is positive.
  const WheelTravel& rolled() const { return rolled_; }
  const WheelSpeeds& speeds() const { return drive_.speeds(); }
  /// Left, right: turning against something that holds.
  const std::array<bool, 2>& wheel_blocked() const { return wheel_blocked_; }
  /// The robot's middle moves.
  bool making_way() const { return making_way_; }
  /// Left, right: no floor under the wheel. The robot hangs, and stays where it is.
  const std::array<bool, 2>& wheel_dropped() const { return wheel_dropped_; }

 private:
  double make_way(const Roll& roll, double dt);
  void account(const Roll& roll, double progress);
  bool hanging() const { return lifted_ || wheel_dropped_[0] || wheel_dropped_[1]; }

  double radius_;
  double wheel_offset_;
  double carpet_slip_;
  double push_slip_;
  double bump_kick_;
  bool has_cliffs_;
  Random bump_random_;
  DriveTrain drive_;
  ContactPhysics physics_;
  Surroundings surroundings_;
  Truth truth_;
  WheelTravel rolled_;
  std::array<bool, 2> wheel_blocked_{};
  std::array<bool, 2> wheel_dropped_{};
  bool making_way_ = false;
  bool lifted_ = false;
  bool was_in_contact_ = false;
};

}  // namespace scrubjay::sim
