#include <algorithm>
#include <cmath>
#include <scrubjay/messages/cdr.hpp>
#include <scrubjay/messages/conversions.hpp>
#include <scrubjay/messages/create_msgs.hpp>
#include <scrubjay/messages/geometry_msgs.hpp>
#include <scrubjay/ros2/commands.hpp>
#include <string_view>
#include <vector>

namespace scrubjay::ros {
namespace {

// What is beyond these is no wish but garbage.
constexpr double kAbsurdSpeed = 10.0;  // [m/s]
constexpr double kAbsurdTurn = 100.0;  // [rad/s]
constexpr double kNoteTicks = 64.0;    // a second

bool within(double value, double limit) {
  return std::fabs(value) <= limit;  // never true of what is not a number
}

bool within(const Vector3& values, double limit) {
  return within(values.x, limit) && within(values.y, limit) && within(values.z, limit);
}

/// As tf2's predecessor wrote them, and some still do.
bool is_map(std::string_view frame) {
  if (frame.starts_with('/')) frame.remove_prefix(1);
  return frame == FrameNames{}.map;
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

Wishes Commands::wishes() {
  const std::lock_guard lock(mutex_);
  return std::exchange(wishes_, {});
}

std::optional<Pose2> Commands::initial_pose() {
  const std::lock_guard lock(mutex_);
  return std::exchange(initial_pose_, std::nullopt);
}

std::optional<oi::Command> Commands::next_order() {
  const std::lock_guard lock(mutex_);
  if (orders_.empty()) return std::nullopt;
  const oi::Command first = orders_.front();
  orders_.pop_front();
  return first;
}

CommandTally Commands::tally() const {
  const std::lock_guard lock(mutex_);
  return tally_;
}

void Commands::refuse_frame(const char* topic) {
  bool is_first = false;
  {
    const std::lock_guard lock(mutex_);
    is_first = tally_.other_frame++ == 0;
  }
  if (!is_first || !tell_) return;
  tell_(std::string(topic) + ": refused a pose that isn't in the frame " + FrameNames{}.map +
        "; want that for its frame_id (in rviz, for the Fixed Frame)");
}

void Commands::take_velocity(const Twist& twist) {
  // The others are no wishes to a robot on a floor, but who sends garbage in them has computed garbage.
  if (!within(twist.linear, kAbsurdSpeed) || !within(twist.angular, kAbsurdTurn)) {
    return refuse(&CommandTally::out_of_range);
  }
  const double linear = twist.linear.x;
  const double angular = twist.angular.z;
  const double share = std::min({1.0, linear != 0.0 ? limits_.linear / std::fabs(linear) : 1.0,
                                 angular != 0.0 ? limits_.angular / std::fabs(angular) : 1.0});
  const std::lock_guard lock(mutex_);
  ++tally_.taken;
  wishes_.velocity = Motion{share * linear, share * angular};
  wishes_.goal_is_newer = false;
}

void Commands::take_twist(Bytes message) {
  const auto twist = decode<Twist>(message);
  if (!twist) return refuse(&CommandTally::malformed);
  take_velocity(*twist);
}

void Commands::take_twist_stamped(Bytes message) {
  const auto stamped = decode<TwistStamped>(message);
  if (!stamped) return refuse(&CommandTally::malformed);
  take_velocity(stamped->twist);
}

std::optional<Pose2> Commands::place(const Header& header, const Pose& pose, const char* topic) {
  const Point& at = pose.position;
  const auto turn = normalized(pose.orientation);
  if (!within(at.x, kReach) || !within(at.y, kReach) || !within(at.z, kReach) || !turn) {
    refuse(&CommandTally::out_of_range);
  } else if (!is_map(header.frame_id)) {
    refuse_frame(topic);
  } else {
    return pose_of(Pose{at, *turn});
  }
  return std::nullopt;
}

void Commands::take_goal(Bytes message) {
  const auto goal = decode<PoseStamped>(message);
  if (!goal) return refuse(&CommandTally::malformed);
  const auto pose = place(goal->header, goal->pose, "goal_pose");
  if (!pose) return;
  const std::lock_guard lock(mutex_);
  ++tally_.taken;
  wishes_.goal = pose;
  wishes_.goal_is_newer = true;
}

void Commands::take_initial_pose(Bytes message) {
  const auto told = decode<PoseWithCovarianceStamped>(message);
  if (!told) return refuse(&CommandTally::malformed);
  const auto& covariance = told->pose.covariance;
  if (!std::all_of(covariance.begin(), covariance.end(), [](double value) { return std::isfinite(value); })) {
    return refuse(&CommandTally::out_of_range);
  }
  const auto pose = place(told->header, told->pose.pose, "initialpose");
  if (!pose) return;
  const std::lock_guard lock(mutex_);
  ++tally_.taken;
  initial_pose_ = pose;
}

void Commands::take_dock(Bytes message) {
  if (!decode<Empty>(message)) return refuse(&CommandTally::malformed);
  const std::lock_guard lock(mutex_);
  if (append(oi::SeekDock{})) wishes_ = {.dock = true};
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
