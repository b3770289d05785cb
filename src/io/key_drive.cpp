#include <algorithm>
#include <scrubjay/io/key_drive.hpp>

namespace scrubjay {
namespace {

enum class Order : std::uint8_t { Stop, Forward, Backward, Left, Right, Faster, Slower, Quit };

Order order_of(const Key& key) {
  switch (key.kind) {
    case Key::Kind::Up:
      return Order::Forward;
    case Key::Kind::Down:
      return Order::Backward;
    case Key::Kind::Left:
      return Order::Left;
    case Key::Kind::Right:
      return Order::Right;
    case Key::Kind::Escape:
    case Key::Kind::Other:
      return Order::Stop;
    case Key::Kind::Character:
      break;
  }
  constexpr char kCtrlD = 4;
  switch (key.character) {
    case 'w':
    case 'W':
      return Order::Forward;
    case 's':
    case 'S':
      return Order::Backward;
    case 'a':
    case 'A':
      return Order::Left;
    case 'd':
    case 'D':
      return Order::Right;
    case '+':
    case '=':  // the same key, without shift
      return Order::Faster;
    case '-':
      return Order::Slower;
    case 'q':
    case 'Q':
    case kCtrlD:
      return Order::Quit;
    default:
      return Order::Stop;
  }
}

KeyDriver::Held reason_to_hold(const Frame& frame) {
  if (frame.wheel_dropped()) return KeyDriver::Held::WheelHangs;
  if (frame.cliff_flags != 0) return KeyDriver::Held::Cliff;
  if (frame.bumped()) return KeyDriver::Held::Bumped;
  if (frame.battery.charging) return KeyDriver::Held::OnTheCharger;
  return KeyDriver::Held::No;
}

/// Tells the robot to stop, whatever happens.
class StopAtTheEnd {
 public:
  explicit StopAtTheEnd(Robot& robot) : robot_(robot) {}
  StopAtTheEnd(const StopAtTheEnd&) = delete;
  StopAtTheEnd& operator=(const StopAtTheEnd&) = delete;
  ~StopAtTheEnd() { robot_.stop(); }

 private:
  Robot& robot_;
};

}  // namespace

void KeyDriver::hold(Axis& axis, int sign, double now) const {
  const bool repeated = axis.sign == sign && now - axis.pressed < params_.repeat_interval;
  axis = {sign, now, now + (repeated ? params_.repeated_hold : params_.first_hold)};
}

void KeyDriver::press(const Key& key, double now) {
  switch (order_of(key)) {
    case Order::Forward:
      return hold(forward_, 1, now);
    case Order::Backward:
      return hold(forward_, -1, now);
    case Order::Left:
      return hold(left_, 1, now);
    case Order::Right:
      return hold(left_, -1, now);
    case Order::Faster:
      tenths_ = std::min(10, tenths_ + 1);
      return;
    case Order::Slower:
      tenths_ = std::max(1, tenths_ - 1);
      return;
    case Order::Quit:
      quit_ = true;
      [[fallthrough]];
    case Order::Stop:
      return let_go();
  }
}

void KeyDriver::let_go() {
  forward_ = left_ = {};
}

Motion KeyDriver::motion(const Frame& frame) {
  if (frame.stamp > forward_.until) forward_ = {};
  if (frame.stamp > left_.until) left_ = {};
  held_ = reason_to_hold(frame);
  if (held_ == Held::WheelHangs) let_go();
  // A key that is held on counts again once the way is free.
  if ((held_ == Held::Bumped || held_ == Held::Cliff) && forward_.sign > 0) forward_ = {};
  return {speed() * params_.max_speed * forward_.sign, speed() * params_.max_turn * left_.sign};
}

bool heed_keys_in_silence(KeyDriver& driver, const KeySource& keys) {
  const auto pressed = keys();
  if (!pressed) return false;
  for (const Key& key : *pressed) driver.press(key, 0.0);
  driver.let_go();
  return !driver.quit();
}

DriveEnd drive_by_keys(Robot& robot, KeyDriver& driver, const KeySource& keys, const DriveView& view,
                       const std::stop_token& stop) {
  const StopAtTheEnd stop_at_the_end(robot);
  std::optional<double> last;
  while (!stop.stop_requested()) {
    const std::optional<Frame> frame = robot.next();
    if (!frame && stop.stop_requested()) return DriveEnd::Stopped;
    if (!frame && driver.quit()) return DriveEnd::Quit;
    const auto pressed = keys();
    if (!pressed) return DriveEnd::KeyboardGone;
    if (!frame) return DriveEnd::RobotGone;
    // What was pressed while nobody saw what the robot does, isn't meant for now; but whoever quits, quits.
    const bool blind = last && frame->stamp - *last > driver.params().silence;
    last = frame->stamp;
    for (const Key& key : *pressed) driver.press(key, frame->stamp);
    if (driver.quit()) return DriveEnd::Quit;
    if (blind) driver.let_go();
    const Motion motion = driver.motion(*frame);
    robot.drive(motion);
    if (view) view(*frame, motion, driver);
  }
  return DriveEnd::Stopped;
}

}  // namespace scrubjay
