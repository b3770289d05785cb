/// \file
/// The four random strategies of Krapinec's thesis (FER Zagreb, 2025, phases 1 to 4): each knows a little more.
#pragma once

#include <scrubjay/behavior/behavior.hpp>
#include <scrubjay/behavior/obstacles.hpp>
#include <scrubjay/geometry/random.hpp>

namespace scrubjay {

/// Speeds are the thesis's; it names the sizes of a step "fixed" without figures, so these are ours.
struct RandomWalkParams {
  double forward_speed = 0.1;     ///< [m/s]
  double turn_rate = 0.5;         ///< [rad/s]
  double forward_distance = 0.3;  ///< of one option [m]
  double turn_angle = 0.5;        ///< of one option [rad]
};

/// One of the things that a random strategy can choose, done until it is complete or cut short.
enum class WalkOption : std::uint8_t { Forward, TurnLeft, TurnRight };

/// Carries options out.
///
///     Idle --begin--> Running --time is up, or a Forward touches something--> Idle
class OptionRun {
 public:
  explicit OptionRun(const RandomWalkParams& params) : params_(params) {}

  void begin(WalkOption option, double stamp);
  /// False when the option is over.
  bool running(const Frame& frame) const;
  WalkOption option() const { return option_; }
  Decision decision() const;

 private:
  RandomWalkParams params_;
  WalkOption option_ = WalkOption::Forward;
  double end_stamp_ = 0.0;
  bool begun_ = false;
};

/// What the four have in common: run an option, then choose the next.
class RandomWalk : public Behavior {
 public:
  RandomWalk(const RobotModel& robot, Random random, const RandomWalkParams& params = {})
      : sense_(robot), run_(params), random_(random) {}

  Decision decide(const Situation& situation) final;

 private:
  virtual WalkOption choose(const Obstacles& obstacles, Random& random) = 0;

  ObstacleSense sense_;
  OptionRun run_;
  Random random_;
};

/// `random-2`: forward, or turn left, by the toss of a coin.
class Random2 final : public RandomWalk {
 public:
  using RandomWalk::RandomWalk;

 private:
  WalkOption choose(const Obstacles& obstacles, Random& random) override;
};

/// `random-3`: forward, turn left, or turn right.
class Random3 final : public RandomWalk {
 public:
  using RandomWalk::RandomWalk;

 private:
  WalkOption choose(const Obstacles& obstacles, Random& random) override;
};

/// `random-look`: as random-2, but forward only if nothing is ahead.
class RandomLook final : public RandomWalk {
 public:
  using RandomWalk::RandomWalk;

 private:
  WalkOption choose(const Obstacles& obstacles, Random& random) override;
};

/// `random-aware`: as random-3, but never forward into something nor towards a side that is blocked; blocked on both
/// sides and ahead, it keeps turning the way it chose.
///
///     Walking --blocked on both sides--> Turning (one way) --a side is free--> Walking
class RandomAware final : public RandomWalk {
 public:
  using RandomWalk::RandomWalk;

 private:
  enum class State : std::uint8_t { Walking, Turning };

  WalkOption choose(const Obstacles& obstacles, Random& random) override;

  State state_ = State::Walking;
  WalkOption turning_ = WalkOption::TurnLeft;
};

}  // namespace scrubjay
