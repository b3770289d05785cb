#include <cmath>
#include <scrubjay/io/hand_check.hpp>
#include <scrubjay/odometry/differential_drive.hpp>
#include <scrubjay/oi/quirks.hpp>
#include <scrubjay/oi/sensor_views.hpp>

namespace scrubjay {
namespace {

using oi::PacketId;

constexpr double kEnoughRolled = 60.0;  // about a quarter of a turn, which no bump on the robot gives [mm]

}  // namespace

std::string_view instruction(HandStep step) {
  switch (step) {
    case HandStep::BumpLeft:
      return "press the bumper on the left, and let go";
    case HandStep::BumpRight:
      return "press the bumper on the right, and let go";
    case HandStep::Lift:
      return "lift the robot, so that both wheels hang down";
    case HandStep::TurnLeft:
      return "turn the left wheel by hand, half a turn";
    case HandStep::TurnRight:
      return "turn the right wheel by hand, half a turn";
  }
  return "";
}

void HandCheck::end_step(HandResult result) {
  results_[at_] = result;
  ++at_;
  begun_ = seen_open_ = pressed_ = other_pressed_ = false;
  rolled_ = {};
}

void HandCheck::skip() {
  if (!done()) end_step(HandResult::NotFelt);
}

void HandCheck::update(const oi::Sensors& sensors, double stamp) {
  if (done()) return;
  if (!begun_) since_ = stamp;
  begun_ = true;
  roll(sensors);
  const oi::BumpsAndWheelDrops shell = oi::bumps_and_wheel_drops(sensors);
  const std::size_t asked = at_;
  switch (step()) {
    case HandStep::BumpLeft:
      feel_bumper(shell.bump_left, shell.bump_right);
      break;
    case HandStep::BumpRight:
      feel_bumper(shell.bump_right, shell.bump_left);
      break;
    case HandStep::Lift:
      if (shell.wheel_drop_left && shell.wheel_drop_right) end_step(HandResult::Felt);
      break;
    case HandStep::TurnLeft:
      if (rolled_[0] >= kEnoughRolled && rolled_[0] > rolled_[1]) end_step(HandResult::Felt);
      break;
    case HandStep::TurnRight:
      if (rolled_[1] >= kEnoughRolled && rolled_[1] > rolled_[0]) end_step(HandResult::Felt);
      break;
  }
  if (at_ != asked || stamp - since_ < patience_) return;
  const bool left = step() == HandStep::TurnLeft;
  const bool turns = left || step() == HandStep::TurnRight;
  const bool other = turns ? rolled_[left ? 1 : 0] >= kEnoughRolled : other_pressed_;
  end_step(other ? HandResult::OtherSide : HandResult::NotFelt);
}

/// The other side may give way as well: who presses with a palm presses both.
void HandCheck::feel_bumper(bool pressed, bool other) {
  other_pressed_ = other_pressed_ || (other && !pressed);
  if (pressed) {
    pressed_ = seen_open_;
  } else if (pressed_) {
    end_step(HandResult::Felt);
  } else {
    seen_open_ = true;
  }
}

void HandCheck::roll(const oi::Sensors& sensors) {
  if (model_ == oi::Model::Create2) {
    const std::array<std::int32_t, 2> now{sensors[PacketId::LeftEncoderCounts], sensors[PacketId::RightEncoderCounts]};
    const double per_count = 1000.0 * DifferentialDrive{}.metres_per_count();
    for (std::size_t i = 0; i < now.size() && rolled_before_; ++i) {
      rolled_[i] += per_count * std::abs(oi::encoder_difference(now[i], counts_[i]));
    }
    counts_ = now;
    rolled_before_ = true;
    return;
  }
  // Distance and angle since the frame before; a Roomba 400 gives half the wheels' difference in place of the angle.
  const double middle = sensors[PacketId::Distance];
  const double angle = sensors[PacketId::Angle];
  const double half =
      model_ == oi::Model::Roomba400 ? angle : 0.5 * 1000.0 * DifferentialDrive{}.wheel_separation * radians(angle);
  rolled_[0] += std::fabs(middle - half);
  rolled_[1] += std::fabs(middle + half);
}

}  // namespace scrubjay
