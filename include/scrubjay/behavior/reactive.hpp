/// \file
/// Drive until something is ahead, turn until nothing is (Krapinec, FER Zagreb, 2025, phase 5).
#pragma once

#include <scrubjay/behavior/behavior.hpp>
#include <scrubjay/behavior/obstacles.hpp>

namespace scrubjay {

struct ReactiveParams {
  double forward_speed = 0.1;  ///< [m/s]
  double turn_rate = 0.5;      ///< [rad/s]; positive turns left, always
};

/// `reactive`. Can go round for ever in some rooms: worlds/reactive_trap.yaml is one.
///
///     Forward --something ahead--> Turning --nothing in the way--> Forward
class Reactive final : public Behavior {
 public:
  explicit Reactive(const RobotModel& robot, const ReactiveParams& params = {}) : params_(params), sense_(robot) {}

  Decision decide(const Situation& situation) override {
    const Obstacles obstacles = sense_(situation.frame);
    if (state_ == State::Forward && obstacles.ahead) state_ = State::Turning;
    if (state_ == State::Turning && !obstacles.ahead) state_ = State::Forward;
    if (state_ == State::Forward) return {{params_.forward_speed, 0.0}, "forward"};
    return {{0.0, params_.turn_rate}, "turning"};
  }

 private:
  enum class State : std::uint8_t { Forward, Turning };

  ReactiveParams params_;
  ObstacleSense sense_;
  State state_ = State::Forward;
};

}  // namespace scrubjay
