/// \file
/// Driving a figure, leg by leg, by the estimated pose alone.
#pragma once

#include <array>
#include <scrubjay/behavior/behavior.hpp>

namespace scrubjay {

/// Straight on, then a turn on the spot.
struct Leg {
  double way = 0.0;   ///< [m]; 0 or more
  double turn = 0.0;  ///< to the left, as many whole turns as it takes [rad]
};

/// Slow enough for wheels not to slip on a hard floor, fast enough for motors that know no creeping; our own choice.
struct LegDriveParams {
  double speed = 0.2;          ///< [m/s]
  double turn_rate = 0.8;      ///< [rad/s]
  double slowest = 0.04;       ///< with which a way ends [m/s]
  double slowest_turn = 0.3;   ///< with which a turn ends [rad/s]
  double slowing = 0.15;       ///< towards the end of a way [m/s^2]
  double turn_slowing = 0.5;   ///< towards the end of a turn [rad/s^2]
  double rest = 0.5;           ///< standing before and after every part: wheels need time to come to rest [s]
  double steering = 3.0;       ///< turn rate per heading error [1/s]
  double line_steering = 1.5;  ///< heading error that is put up with per distance from the line [rad/m]
};

/// Drives up to four legs, and stops for good at what it feels in its way.
///
///     Resting --wheels are at rest--> Rolling --the way is done--> Resting --> Turning --the turn is done--> Resting
///        |                               |                                        |
///        +--after the last turn--> Done  +------- bump, cliff or no floor ------> Failed <-- from everywhere
///
/// A leg begins where the one before should have ended, so that what one overshoots the next makes good.
class LegDrive final : public Behavior {
 public:
  static constexpr std::size_t kMaxLegs = 4;

  /// Takes the first kMaxLegs of `legs`.
  explicit LegDrive(std::span<const Leg> legs, const LegDriveParams& params = {});

  Decision decide(const Situation& situation) override;

  /// Something was in the way.
  bool failed() const { return state_ == State::Failed; }

 private:
  enum class State : std::uint8_t { Resting, Rolling, Turning, Done, Failed };

  void follow_turn(const Pose2& pose);
  Decision rest(const Frame& frame);
  Decision roll(const Situation& situation);
  Decision turn(const Frame& frame);
  void begin_rest(const Frame& frame, State next);
  void end_leg();

  LegDriveParams params_;
  std::array<Leg, kMaxLegs> legs_{};
  std::size_t count_ = 0;
  std::size_t leg_ = 0;
  State state_ = State::Resting;
  State next_ = State::Rolling;
  bool started_ = false;
  double rest_stamp_ = 0.0;
  Pose2 line_;            // where this leg begins
  double heading_ = 0.0;  // all that was turned so far, whole turns included
  double wanted_ = 0.0;   // heading at the end of this leg's turn
  double last_yaw_ = 0.0;
};

}  // namespace scrubjay
