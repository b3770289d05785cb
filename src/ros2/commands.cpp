#include <algorithm>
#include <cmath>
#include <scrubjay/messages/cdr.hpp>
#include <scrubjay/messages/conversions.hpp>
#include <scrubjay/messages/create_msgs.hpp>
#include <scrubjay/messages/geometry_msgs.hpp>
#include <scrubjay/ros2/commands.hpp>

namespace scrubjay::ros {
namespace {

// What is beyond these is no wish but garbage.
constexpr double kAbsurdSpeed = 10.0;  // [m/s]
constexpr double kAbsurdTurn = 100.0;  // [rad/s]
constexpr double kAbsurdPlace = 1e5;   // [m]
constexpr std::size_t kMostOrders = 32;
constexpr double kNoteTicks = 64.0;  // a second

bool within(double value, double limit) {
  return std::fabs(value) <= limit;  // never true of what is not a number
}

/// With length 1, which rviz and people round; none if it is no rotation.
std::optional<Quaternion> normalized(const Quaternion& q) {
  const double length = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
  if (!(length > 0.5 && length < 2.0)) return std::nullopt;
  return Quaternion{q.x / length, q.y / length, q.z / length, q.w / length};
}

}  // namespace

void Commands::refuse(std::uint64_t CommandTally::*why) {
  const std::lock_guard lock(mutex_);
  ++(tally_.*why);
}

void Commands::order(const oi::Command& command) {
  const std::lock_guard lock(mutex_);
  append(command);
}

void Commands::order_leds(const std::function<void(oi::Leds&)>& change) {
  const std::lock_guard lock(mutex_);
  oi::Leds leds = leds_;
  change(leds);
  if (append(leds)) leds_ = leds;
}

bool Commands::append(const oi::Command& command) {
  if (orders_.size() == kMostOrders) {
    ++tally_.out_of_range;
    return false;
  }
  ++tally_.taken;
  orders_.push_back(command);
  return true;
}

std::vector<oi::Command> Commands::orders() {
  const std::lock_guard lock(mutex_);
  return std::exchange(orders_, {});
}

CommandTally Commands::tally() const {
  const std::lock_guard lock(mutex_);
  return tally_;
}

void Commands::take_velocity(double linear, double angular) {
  if (!within(linear, kAbsurdSpeed) || !within(angular, kAbsurdTurn)) return refuse(&CommandTally::out_of_range);
  const double share = std::min({1.0, linear != 0.0 ? limits_.linear / std::fabs(linear) : 1.0,
                                 angular != 0.0 ? limits_.angular / std::fabs(angular) : 1.0});
  const std::lock_guard lock(mutex_);
  ++tally_.taken;
  velocity_ = Motion{share * linear, share * angular};
}

void Commands::take_twist(Bytes message) {
  const auto twist = decode<Twist>(message);
  if (!twist) return refuse(&CommandTally::malformed);
  take_velocity(twist->linear.x, twist->angular.z);
}

void Commands::take_twist_stamped(Bytes message) {
  const auto twist = decode<TwistStamped>(message);
  if (!twist) return refuse(&CommandTally::malformed);
  take_velocity(twist->twist.linear.x, twist->twist.angular.z);
}

void Commands::take_pose(const Pose& pose, std::optional<Pose2>& slot) {
  const auto turn = normalized(pose.orientation);
  if (!within(pose.position.x, kAbsurdPlace) || !within(pose.position.y, kAbsurdPlace) || !turn) {
    return refuse(&CommandTally::out_of_range);
  }
  const std::lock_guard lock(mutex_);
  ++tally_.taken;
  slot = pose_of(Pose{pose.position, *turn});
}

void Commands::take_goal(Bytes message) {
  const auto goal = decode<PoseStamped>(message);
  if (!goal) return refuse(&CommandTally::malformed);
  take_pose(goal->pose, goal_);
}

void Commands::take_initial_pose(Bytes message) {
  const auto pose = decode<PoseWithCovarianceStamped>(message);
  if (!pose) return refuse(&CommandTally::malformed);
  take_pose(pose->pose.pose, initial_pose_);
}

void Commands::take_dock(Bytes message) {
  if (!decode<Empty>(message)) return refuse(&CommandTally::malformed);
  order(oi::SeekDock{});
}

void Commands::take_undock(Bytes message) {
  if (!decode<Empty>(message)) return refuse(&CommandTally::malformed);
  order(oi::Safe{});
}

void Commands::take_song(Bytes message) {
  const auto song = decode<DefineSong>(message);
  if (!song) return refuse(&CommandTally::malformed);
  const auto slot = oi::SongSlot::of(song->song);
  const std::size_t length = song->length;
  oi::Song command;
  if (!slot || length == 0 || length > song->notes.size() || length > song->durations.size()) {
    return refuse(&CommandTally::out_of_range);
  }
  command.slot = *slot;
  std::vector<oi::Note> notes;
  for (std::size_t i = 0; i < length; ++i) {
    const double ticks = std::floor(kNoteTicks * static_cast<double>(song->durations[i]) + 0.5);
    if (!(ticks >= 0.0 && ticks <= 255.0)) return refuse(&CommandTally::out_of_range);
    notes.push_back({song->notes[i], static_cast<std::uint8_t>(ticks)});
  }
  const auto list = decltype(command.notes)::of(notes);
  if (!list) return refuse(&CommandTally::out_of_range);
  command.notes = *list;
  order(command);
}

void Commands::take_play(Bytes message) {
  const auto play = decode<PlaySong>(message);
  if (!play) return refuse(&CommandTally::malformed);
  const auto slot = oi::SongSlot::of(play->song);
  if (!slot) return refuse(&CommandTally::out_of_range);
  order(oi::Play{*slot});
}

void Commands::take_led(std::uint8_t bit, Bytes message) {
  const auto on = decode<Bool>(message);
  if (!on) return refuse(&CommandTally::malformed);
  order_leds(
      [&](oi::Leds& leds) { leds.bits = static_cast<std::uint8_t>(on->data ? leds.bits | bit : leds.bits & ~bit); });
}

void Commands::take_power_led(Bytes message) {
  const auto led = decode<UInt8MultiArray>(message);
  if (!led) return refuse(&CommandTally::malformed);
  if (led->data.empty()) return refuse(&CommandTally::out_of_range);
  order_leds([&](oi::Leds& leds) {
    leds.power_color = led->data[0];
    if (led->data.size() > 1) leds.power_intensity = led->data[1];
  });
}

void Commands::take_digits(Bytes message) {
  const auto digits = decode<UInt8MultiArray>(message);
  if (!digits) return refuse(&CommandTally::malformed);
  if (digits->data.empty() || digits->data.size() > 4) return refuse(&CommandTally::out_of_range);
  oi::DigitLedsAscii command;
  for (std::size_t i = 0; i < command.digits.size(); ++i) {
    const auto digit = oi::Ascii::of(i < digits->data.size() ? digits->data[i] : ' ');
    if (!digit) return refuse(&CommandTally::out_of_range);
    command.digits[i] = *digit;
  }
  order(command);
}

}  // namespace scrubjay::ros
