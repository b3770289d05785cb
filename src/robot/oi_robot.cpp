#include <algorithm>
#include <cmath>
#include <scrubjay/oi/infrared.hpp>
#include <scrubjay/oi/sensor_views.hpp>
#include <scrubjay/robot/oi_robot.hpp>

namespace scrubjay {
namespace {

using oi::PacketId;

constexpr double kRetryInterval = 0.25;  // between attempts to take control again [s]
constexpr double kReplyTimeout = 0.05;   // a reply that isn't whole by then has lost a byte [s]

oi::SensorId all_packets(oi::Model model) {
  switch (model) {
    case oi::Model::Create2:
      return 100;
    case oi::Model::Create1:
      return 6;
    case oi::Model::Roomba400:
      return 0;
  }
  return 0;
}

std::uint8_t payload_size(oi::Model model) {
  return static_cast<std::uint8_t>(all_packets(model).bytes() + 1);
}

int to_millimetres(double speed, double max_speed) {
  const double limited = std::clamp(speed, -max_speed, max_speed) * 1000.0;
  return static_cast<int>(limited + (limited < 0.0 ? -0.5 : 0.5));
}

int rounded(double value) {
  return static_cast<int>(std::floor(value + 0.5));
}

/// Drive's arguments for two wheel speeds [mm/s]: what a Roomba 400 understands.
oi::Drive as_drive(int left, int right, double separation) {
  const double middle = 0.5 * (left + right);
  if (left == right) return {oi::Velocity::clamped(left), oi::Radius::straight()};
  const double radius = 1000.0 * separation * middle / (right - left);
  // Radii of 1 and -1 mean to spin.
  if (std::fabs(radius) < 1.5) {
    return {oi::Velocity::clamped(std::abs(right - left) / 2),
            right > left ? oi::Radius::spin_counter_clockwise() : oi::Radius::spin_clockwise()};
  }
  if (std::fabs(radius) > 2000.0) {
    return {oi::Velocity::clamped(rounded(middle)), oi::Bounded<-2000, 2000>::clamped(radius > 0.0 ? 2000 : -2000)};
  }
  // A whole radius, and the speed that keeps the rate of turn with it.
  const int whole = rounded(radius);
  return {oi::Velocity::clamped(rounded(middle * whole / radius)), oi::Bounded<-2000, 2000>::clamped(whole)};
}

}  // namespace

OiRobot::OiRobot(ByteChannel& channel, const RobotModel& model, const oi::FirmwareQuirks& quirks)
    : channel_(channel),
      model_(model),
      quirks_(quirks),
      parser_(model.protocol, payload_size(model.protocol)),
      reply_(model.protocol) {
  send(oi::Start{});
  if (!streams()) {
    send(oi::Control{});  // from Passive to Safe; Safe itself leads down from Full only (Roomba SCI)
    ask(0.0);
    return;
  }
  send(oi::Safe{});
  const oi::SensorId id = all_packets(model.protocol);
  if (const auto ids = oi::FixedList<oi::SensorId, 0, 255>::of({&id, 1})) send(oi::Stream{*ids});
}

bool OiRobot::send(const oi::Command& command) {
  const oi::CommandBytes bytes = encode(command);
  const bool sent = channel_.write(bytes);
  if (!sent) link_ = LinkState::Closed;
  return sent;
}

void OiRobot::ask(double stamp) {
  asked_stamp_ = stamp;
  const oi::Query query{all_packets(model_.protocol)};
  if (reply_.expect(query)) send(query);
}

std::optional<Frame> OiRobot::next() {
  while (next_frame_ == frame_count_) {
    if (!receive()) return std::nullopt;
  }
  return frames_[next_frame_++];
}

bool OiRobot::receive() {
  next_frame_ = frame_count_ = 0;
  std::array<std::uint8_t, kReadSize> buffer;
  const ByteRead read = channel_.read(buffer);
  if (!started_) {
    started_ = true;
    last_stamp_ = mode_sent_stamp_ = asked_stamp_ = read.stamp;
  }
  const std::span<const std::uint8_t> bytes(buffer.data(), read.count);
  if (streams()) {
    parser_.feed(
        bytes, [&](const oi::StreamFrame& frame) { arrive(oi::decode(frame, model_.protocol, sensors_), read.stamp); });
  } else {
    take_reply(bytes, read.stamp);
  }
  if (frame_count_ > 0) {
    link_ = LinkState::Alive;
    return true;
  }
  if (!read.open) {
    link_ = LinkState::Closed;
  } else if (link_ != LinkState::Closed && read.stamp - last_stamp_ >= kSilence) {
    link_ = LinkState::Silent;
  }
  return link_ == LinkState::Alive;
}

void OiRobot::take_reply(std::span<const std::uint8_t> bytes, double stamp) {
  if (bytes.empty()) {
    if (reply_.awaited() == 0 || stamp - asked_stamp_ >= kReplyTimeout) ask(stamp);
    return;
  }
  if (reply_.awaited() == 0) return;
  const bool whole = reply_.feed(bytes, sensors_) == bytes.size();
  if (reply_.awaited() > 0) return;
  arrive({true, reply_.rejected()}, stamp);
  // Nothing says where a reply begins. When this one may have begun elsewhere, the line must fall silent first.
  if (whole && reply_.rejected() == 0) ask(stamp);
}

void OiRobot::arrive(const oi::DecodeStatus& status, double stamp) {
  rejected_values_ += status.rejected;
  if (!status.ok || frame_count_ == frames_.size()) return;
  frames_[frame_count_] = make_frame(stamp);
  keep_mode(frames_[frame_count_]);
  ++frame_count_;
  last_stamp_ = stamp;
}

Frame OiRobot::make_frame(double stamp) {
  const oi::Sensors& s = sensors_;
  Frame frame;
  frame.stamp = stamp;
  read_travel(frame);
  const oi::BumpsAndWheelDrops shell = oi::bumps_and_wheel_drops(s);
  frame.bump_left = shell.bump_left;
  frame.bump_right = shell.bump_right;
  frame.wheel_drop_left = shell.wheel_drop_left;
  frame.wheel_drop_right = shell.wheel_drop_right;
  frame.light_flags = static_cast<std::uint8_t>(s[PacketId::LightBumper]);
  for (std::size_t i = 0; i < frame.light_signal.size(); ++i) {
    const auto id = static_cast<PacketId>(number(PacketId::LightBumpLeftSignal) + i);
    frame.light_signal[i] = static_cast<std::uint16_t>(s[id]);
  }
  for (int i = 0; i < kCliffSensorCount; ++i) {
    const auto id = static_cast<PacketId>(number(PacketId::CliffLeft) + i);
    frame.cliff_flags |= static_cast<std::uint8_t>((s[id] != 0 ? 1 : 0) << i);
  }
  frame.wall = s[PacketId::Wall] != 0;
  frame.wall_signal = static_cast<std::uint16_t>(s[PacketId::WallSignal]);
  frame.virtual_wall = s[PacketId::VirtualWall] != 0;
  const auto character = [&](PacketId id) {
    const auto value = static_cast<std::uint8_t>(s[id]);
    return value == oi::no_character(model_.protocol) ? std::uint8_t{0} : value;
  };
  frame.infrared_omni = character(PacketId::InfraredCharacterOmni);
  frame.infrared_left = character(PacketId::InfraredCharacterLeft);
  frame.infrared_right = character(PacketId::InfraredCharacterRight);
  frame.dirt = static_cast<std::uint8_t>(s[PacketId::DirtDetect]);
  frame.mode = oi::corrected_mode(s[PacketId::OiMode], quirks_).value_or(oi::OiMode::Off);
  frame.battery = {s[PacketId::Voltage] * 1e-3,
                   s[PacketId::Current] * 1e-3,
                   s[PacketId::BatteryCharge] * 1e-3,
                   s[PacketId::BatteryCapacity] * 1e-3,
                   static_cast<double>(s[PacketId::Temperature]),
                   oi::is_charging(oi::charging_state(s))};
  return frame;
}

void OiRobot::read_travel(Frame& frame) {
  // No wheel turns farther in the time since the last frame, late as that may have been.
  const double reach = 2.0 * model_.max_wheel_speed * (frame.stamp - last_stamp_ + kSilence);
  if (sensors_.has(PacketId::LeftEncoderCounts)) {
    const oi::EncoderCounts counts =
        oi::corrected_encoders(sensors_[PacketId::LeftEncoderCounts], sensors_[PacketId::RightEncoderCounts], quirks_);
    const double per_count = model_.drive.metres_per_count();
    const int max_step = static_cast<int>(std::clamp(reach / per_count, 0.0, 32767.0));
    frame.left_travel = per_count * left_encoder_.advance(static_cast<std::uint16_t>(counts.left), max_step);
    frame.right_travel = per_count * right_encoder_.advance(static_cast<std::uint16_t>(counts.right), max_step);
    return;
  }
  const double distance = quirks_.distance_wrong ? 0.0 : sensors_[PacketId::Distance] * 1e-3;
  const double half_turn =
      model_.protocol == oi::Model::Roomba400
          // The SCI reports half the wheels' difference in mm.
          ? sensors_[PacketId::Angle] * 1e-3
          : 0.5 * model_.drive.wheel_separation * radians(oi::corrected_angle(sensors_[PacketId::Angle], quirks_));
  // The first reading counts from whenever the robot was last asked, as an encoder's does.
  if (measures_ && std::fabs(distance) + std::fabs(half_turn) <= reach) {
    frame.left_travel = distance - half_turn;
    frame.right_travel = distance + half_turn;
  }
  measures_ = true;
}

void OiRobot::keep_mode(const Frame& frame) {
  if (!sensors_.has(PacketId::OiMode) || frame.mode == oi::OiMode::Safe || frame.mode == oi::OiMode::Full) return;
  if (frame.wheel_dropped() || frame.battery.charging) return;
  if (frame.stamp - mode_sent_stamp_ < kRetryInterval) return;
  mode_sent_stamp_ = frame.stamp;
  if (frame.mode == oi::OiMode::Off) send(oi::Start{});
  send(oi::Safe{});
  left_speed_ = right_speed_ = 0;  // as the robot has them now: the next motion is sent
}

void OiRobot::drive(const Motion& motion) {
  // What isn't a number moves no wheel; what is too fast for one wheel slows both, so that the curve stays.
  const bool sound = std::isfinite(motion.linear) && std::isfinite(motion.angular);
  const double linear = sound ? motion.linear : 0.0;
  const double half = sound ? 0.5 * model_.drive.wheel_separation * motion.angular : 0.0;
  const double fastest = std::fabs(linear) + std::fabs(half);
  const double share = fastest > model_.max_wheel_speed ? model_.max_wheel_speed / fastest : 1.0;
  const int left = to_millimetres(share * (linear - half), model_.max_wheel_speed);
  const int right = to_millimetres(share * (linear + half), model_.max_wheel_speed);
  if (left == left_speed_ && right == right_speed_) return;
  left_speed_ = left;
  right_speed_ = right;
  if (streams()) {
    send(oi::DriveDirect{oi::Velocity::clamped(right), oi::Velocity::clamped(left)});
  } else {
    send(as_drive(left, right, model_.drive.wheel_separation));
  }
}

void OiRobot::stop() {
  left_speed_ = right_speed_ = 0;
  send(oi::Drive{oi::Velocity(0), oi::Radius::straight()});
  send(oi::Start{});  // Passive: it may charge
}

}  // namespace scrubjay
