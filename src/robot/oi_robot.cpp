#include <algorithm>
#include <cmath>
#include <scrubjay/oi/all_packets.hpp>
#include <scrubjay/robot/oi_robot.hpp>

namespace scrubjay {
namespace {

using oi::PacketId;

constexpr double kRetryInterval = 0.25;  // between attempts to take control again [s]
constexpr double kReplyTimeout = 0.04;   // a reply that isn't whole by then has lost a byte [s]

constexpr double kRenewal = 0.03;        // between two tellings of the same motion: every other tick [s]
constexpr double kSurePassive = 0.1;     // a robot that says so for as long is in Passive mode, and stays there [s]
constexpr double kSilentRenewal = 0.03;  // between two orders to stand, to a silent robot [s]
constexpr int kUnknownSpeed = 1 << 16;   // no speed that could be wanted [mm/s]

/// No commands, one by one; data enough for the longest list that a damaged command may have become.
constexpr std::array<std::uint8_t, 256> kZeros{};

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

OiRobot::OiRobot(ByteChannel& channel, const RobotModel& model, const oi::FirmwareQuirks& quirks, Session session)
    : channel_(channel),
      model_(model),
      session_(session),
      parser_(model.protocol, oi::payload_of_all(model.protocol)),
      reply_(model.protocol),
      frame_maker_(model, quirks) {
  if (!listens()) begin_session();
}

void OiRobot::begin_session() {
  if (!listens()) take_control();
  want_frames();
}

/// Or lets it drive by itself, if it does.
void OiRobot::take_control() {
  send(oi::Start{});  // which ends Safe and Full mode
  // From Passive to Safe; Safe itself leads down from Full only (Roomba SCI).
  if (!streams()) send(oi::Control{});
  if (own_errand_) {
    send(*own_errand_);
  } else if (streams()) {
    send(oi::Safe{});
  }
}

void OiRobot::want_frames() {
  if (streams()) {
    send(oi::stream_of_all(model_.protocol));
  } else {
    ask(stamp_);
  }
}

void OiRobot::restart() {
  link_ = LinkState::Silent;
  keeps_mode_ = !own_errand_;
  flush();
  // Start would end what it is at, and most silences are the wire's.
  if (own_errand_ && !restarted_) {
    want_frames();
  } else {
    begin_session();
    left_speed_ = right_speed_ = 0;  // Start makes it stand
  }
  restarted_ = true;
}

bool OiRobot::send(const oi::Command& command) {
  const oi::CommandBytes bytes = encode(command);
  const bool sent = channel_.write(bytes);
  if (!sent) link_ = LinkState::Closed;
  return sent;
}

/// Ends a command that lost a byte, or that a flipped bit made longer.
void OiRobot::flush() {
  if (!channel_.write(kZeros)) link_ = LinkState::Closed;
}

void OiRobot::tell(int left, int right) {
  left_speed_ = left;
  right_speed_ = right;
  told_stamp_ = stamp_;
  if (!streams()) {
    send(as_drive(left, right, model_.drive.wheel_separation));
    return;
  }
  send(oi::DriveDirect{oi::Velocity::clamped(right), oi::Velocity::clamped(left)});
  echo_.tell(left, right, stamp_);
}

void OiRobot::ask(double stamp) {
  asked_stamp_ = stamp;
  const oi::Query query{oi::all_packets(model_.protocol)};
  if (reply_.expect(query)) send(query);
}

std::optional<Frame> OiRobot::next() {
  while (next_frame_ == frame_count_) {
    if (!receive()) return std::nullopt;
  }
  return frames_[next_frame_++];
}

std::optional<Frame> OiRobot::poll() {
  if (next_frame_ == frame_count_) receive();
  if (next_frame_ == frame_count_) return std::nullopt;
  return frames_[next_frame_++];
}

bool OiRobot::receive() {
  next_frame_ = frame_count_ = 0;
  std::array<std::uint8_t, kReadSize> buffer;
  const ByteRead read = channel_.read(buffer);
  stamp_ = read.stamp;
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
    restarted_ = false;
    return true;
  }
  if (!read.open) {
    link_ = LinkState::Closed;
  } else if (link_ != LinkState::Closed && read.stamp - last_stamp_ >= kSilence) {
    fall_silent();
  }
  return link_ == LinkState::Alive;
}

void OiRobot::fall_silent() {
  const bool noticed = link_ == LinkState::Alive;
  link_ = LinkState::Silent;
  if (!driven_) return;
  if (noticed) flush();
  if (noticed || stamp_ - told_stamp_ >= kSilentRenewal) halt();
}

void OiRobot::take_reply(std::span<const std::uint8_t> bytes, double stamp) {
  if (bytes.empty()) {
    const bool late = stamp - asked_stamp_ >= kReplyTimeout;
    if (reply_.awaited() > 0 && late) ++lost_replies_;
    if (reply_.awaited() == 0 || late) ask(stamp);
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
  frames_[frame_count_] = frame_maker_.make(sensors_, stamp, stamp - last_stamp_, wanted_);
  frame_tally_.arrive(stamp);
  keep_mode(frames_[frame_count_]);
  heal_deafness(frames_[frame_count_]);
  ++frame_count_;
  last_stamp_ = stamp;
}

void OiRobot::keep_mode(const Frame& frame) {
  if (listens() || !sensors_.has(PacketId::OiMode) || frame.stamp - mode_sent_stamp_ < kRetryInterval) return;
  const bool has_control = frame.mode == oi::OiMode::Safe || frame.mode == oi::OiMode::Full;
  if (own_errand_ && has_control) {
    // What it was ordered leads to Passive: it didn't hear, and goes on as it was told before.
    mode_sent_stamp_ = frame.stamp;
    send(*own_errand_);
  }
  if (!keeps_mode_ || has_control || frame.wheel_dropped() || frame.battery.charging) return;
  mode_sent_stamp_ = frame.stamp;
  if (frame.mode == oi::OiMode::Off) send(oi::Start{});
  send(oi::Safe{});
  left_speed_ = right_speed_ = 0;  // as the robot has them now: the next motion is sent
}

void OiRobot::heal_deafness(const Frame& frame) {
  // In Passive it hears, and doesn't obey.
  const bool obeys = frame.mode == oi::OiMode::Safe || frame.mode == oi::OiMode::Full;
  if (!driven_ || !obeys || !sensors_.has(PacketId::RequestedRightVelocity)) return;
  const int left = sensors_[PacketId::RequestedLeftVelocity];
  const int right = sensors_[PacketId::RequestedRightVelocity];
  if (left_speed_ == kUnknownSpeed || !echo_.is_deaf(left, right, frame.stamp)) return;
  ++deafnesses_;
  flush();
  // The next motion is told in any case; this one isn't ours to renew, and somebody else may have stopped it.
  left_speed_ = right_speed_ = kUnknownSpeed;
}

bool OiRobot::order(const oi::Command& command) {
  if (listens()) return false;
  switch (opcode_of(command)) {
    case oi::Opcode::SeekDock:
    case oi::Opcode::Clean:
    case oi::Opcode::Spot:
    case oi::Opcode::Max:
      own_errand_ = command;
      keeps_mode_ = false;
      mode_sent_stamp_ = stamp_;
      left_speed_ = right_speed_ = 0;
      wanted_ = {};
      break;
    case oi::Opcode::Safe:
    case oi::Opcode::Full:
      own_errand_.reset();
      keeps_mode_ = true;
      break;
    default:
      break;
  }
  return send(command);
}

void OiRobot::drive(const Motion& motion) {
  if (listens()) return;
  if (own_errand_ && motion == Motion{}) return;
  own_errand_.reset();
  // What isn't a number moves no wheel; what is too fast for one wheel slows both, so that the curve stays.
  const bool sound = std::isfinite(motion.linear) && std::isfinite(motion.angular);
  const double linear = sound ? motion.linear : 0.0;
  const double half = sound ? 0.5 * model_.drive.wheel_separation * motion.angular : 0.0;
  const double fastest = std::fabs(linear) + std::fabs(half);
  const double share = fastest > model_.max_wheel_speed ? model_.max_wheel_speed / fastest : 1.0;
  const int left = to_millimetres(share * (linear - half), model_.max_wheel_speed);
  const int right = to_millimetres(share * (linear + half), model_.max_wheel_speed);
  keeps_mode_ = true;
  driven_ = driven_ || left != 0 || right != 0;
  wanted_ = {left * 1e-3, right * 1e-3};
  if (left == left_speed_ && right == right_speed_ && stamp_ - told_stamp_ < kRenewal) return;
  tell(left, right);
}

void OiRobot::halt() {
  tell(0, 0);
  left_speed_ = right_speed_ = kUnknownSpeed;
}

void OiRobot::stop() {
  if (listens()) return;
  keeps_mode_ = driven_ = false;
  own_errand_.reset();
  left_speed_ = right_speed_ = 0;
  wanted_ = {};
  flush();
  // Twice: a lost byte makes the first Drive take Start for its last one.
  for (int i = 0; i < 2; ++i) {
    send(oi::Drive{oi::Velocity(0), oi::Radius::straight()});
    send(oi::Start{});  // Passive: it may charge
  }
}

bool OiRobot::confirm_stop(double patience) {
  if (!streams()) return false;
  const double begin = stamp_;
  double sent = stamp_;
  double passive_since = stamp_;
  while (stamp_ - begin < patience) {
    const bool heard = receive();
    if (link_ == LinkState::Closed) break;
    // A robot that was in Passive before may yet heed a command that is on its way.
    const bool passive = heard && frame_count_ > 0 && frames_[frame_count_ - 1].mode == oi::OiMode::Passive;
    if (heard && frame_count_ > 0 && !passive) passive_since = stamp_;
    if (passive && stamp_ - passive_since >= kSurePassive) return true;
    if (passive || stamp_ - sent < kSurePassive) continue;
    sent = stamp_;
    stop();
  }
  return false;
}

}  // namespace scrubjay
