/// \file
/// A check of bumpers and wheels by the user's hands: what to do next, and whether the robot felt it.
#pragma once

#include <array>
#include <cstdint>
#include <scrubjay/oi/model.hpp>
#include <scrubjay/oi/sensors.hpp>
#include <string_view>

namespace scrubjay {

/// In the order in which they are asked for.
enum class HandStep : std::uint8_t { BumpLeft, BumpRight, Lift, TurnLeft, TurnRight };
inline constexpr std::size_t kHandSteps = 5;

enum class HandResult : std::uint8_t {
  NotAsked,
  Felt,
  NotFelt,    ///< not in time, or passed over
  OtherSide,  ///< the other side's sensor answered instead
};

/// What the user is to do, in a few words, as "press the bumper on the left".
std::string_view instruction(HandStep step);

/// Goes from step to step as the robot feels each. A bumper has to be felt open, pressed and open again: one that is
/// stuck passes no step.
class HandCheck {
 public:
  /// `patience`: for each step [s].
  explicit HandCheck(oi::Model model, double patience = 30.0) : model_(model), patience_(patience) {}

  /// All values of the next frame, and its stamp [s].
  void update(const oi::Sensors& sensors, double stamp);
  /// Passes over the step.
  void skip();

  bool done() const { return at_ == kHandSteps; }
  /// What is asked for; not when done.
  HandStep step() const { return static_cast<HandStep>(at_); }
  HandResult result(HandStep step) const { return results_[static_cast<std::size_t>(step)]; }

 private:
  void end_step(HandResult result);
  void feel_bumper(bool pressed, bool other);
  void feel_wheels(const oi::Sensors& sensors);
  void roll(const oi::Sensors& sensors);

  oi::Model model_;
  double patience_;
  std::size_t at_ = 0;
  std::array<HandResult, kHandSteps> results_{};
  bool begun_ = false;
  double since_ = 0.0;      // this step's first frame
  bool seen_open_ = false;  // a bumper
  bool pressed_ = false;
  bool other_pressed_ = false;
  bool rolled_before_ = false;            // there are readings to compare with
  std::array<std::int32_t, 2> counts_{};  // encoders, left and right
  std::array<double, 2> rolled_{};        // in this step, whichever way [mm]
};

}  // namespace scrubjay
