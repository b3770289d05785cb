#include <scrubjay/behavior/random_walk.hpp>

namespace scrubjay {

void OptionRun::begin(WalkOption option, double stamp) {
  option_ = option;
  begun_ = true;
  const double duration = option == WalkOption::Forward ? params_.forward_distance / params_.forward_speed
                                                        : params_.turn_angle / params_.turn_rate;
  end_stamp_ = stamp + duration;
}

bool OptionRun::running(const Frame& frame) const {
  if (!begun_ || frame.stamp >= end_stamp_) return false;
  const bool touched = frame.bumped() || frame.cliff_flags != 0 || frame.virtual_wall;
  return option_ != WalkOption::Forward || !touched;
}

Decision OptionRun::decision() const {
  switch (option_) {
    case WalkOption::Forward:
      return {{params_.forward_speed, 0.0}, "forward"};
    case WalkOption::TurnLeft:
      return {{0.0, params_.turn_rate}, "turning left"};
    case WalkOption::TurnRight:
      return {{0.0, -params_.turn_rate}, "turning right"};
  }
  return {};
}

Decision RandomWalk::decide(const Situation& situation) {
  const Frame& frame = situation.frame;
  if (!run_.running(frame)) {
    run_.begin(choose(sense_(frame), random_), frame.stamp);
    // A blind forward against something stands for a tick instead of pushing.
    if (!run_.running(frame)) return {{}, "blocked"};
  }
  return run_.decision();
}

WalkOption Random2::choose(const Obstacles&, Random& random) {
  return random.below(2) == 0 ? WalkOption::Forward : WalkOption::TurnLeft;
}

WalkOption Random3::choose(const Obstacles&, Random& random) {
  return static_cast<WalkOption>(random.below(3));
}

WalkOption RandomLook::choose(const Obstacles& obstacles, Random& random) {
  if (obstacles.ahead) return WalkOption::TurnLeft;
  return random.below(2) == 0 ? WalkOption::Forward : WalkOption::TurnLeft;
}

WalkOption RandomAware::choose(const Obstacles& obstacles, Random& random) {
  if (obstacles.left && obstacles.right) {
    if (state_ == State::Walking) {
      state_ = State::Turning;
      turning_ = random.below(2) == 0 ? WalkOption::TurnLeft : WalkOption::TurnRight;
    }
    return turning_;
  }
  state_ = State::Walking;
  WalkOption open[3];
  std::uint32_t count = 0;
  if (!obstacles.ahead) open[count++] = WalkOption::Forward;
  if (!obstacles.left) open[count++] = WalkOption::TurnLeft;
  if (!obstacles.right) open[count++] = WalkOption::TurnRight;
  return open[random.below(count)];
}

}  // namespace scrubjay
