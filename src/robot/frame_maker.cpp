#include <algorithm>
#include <cmath>
#include <scrubjay/oi/infrared.hpp>
#include <scrubjay/oi/sensor_views.hpp>
#include <scrubjay/robot/frame_maker.hpp>

namespace scrubjay {
namespace {

using oi::PacketId;

constexpr double kLateness = 0.1;    // a frame may come so much later than it was sent [s]
constexpr double kAftermath = 0.25;  // frames held up in a gap come within this behind it [s]
constexpr double kRestart = 2.0;     // no robot is off and on again within this [s]
constexpr double kHaste = 1.5;       // times the speed that it was told, no wheel turns faster
constexpr double kPush = 0.2;        // way that it may have rolled otherwise [m]
// A robot that was just started has hardly moved, and its counters begin at 0: from full speed it rolls out in 0.42 m
// (RobotSpec::braking), but seldom drives that fast.
constexpr int kCountsOfAFreshStart = 400;

bool is_fresh(std::int32_t count) {
  return std::abs(count) <= kCountsOfAFreshStart;
}

}  // namespace

Frame FrameMaker::make(const oi::Sensors& s, double stamp, double elapsed, const ToldSpeeds& told) {
  Frame frame;
  frame.stamp = stamp;
  note_gap(elapsed);
  if (s.has(PacketId::LeftEncoderCounts)) {
    count_encoders(frame, s, elapsed, told);
  } else {
    measure(frame, s, elapsed, told);
  }
  begun_ = true;
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
                   oi::is_charging(oi::charging_state(s)),
                   oi::charging_state(s)};
  return frame;
}

/// What was held up when a gap began comes first behind it: the way of the gap comes with a later frame then.
void FrameMaker::note_gap(double elapsed) {
  if (elapsed > kLateness) {
    gap_ = elapsed;
    since_gap_ = 0.0;
    return;
  }
  since_gap_ += elapsed;
  if (since_gap_ > kAftermath) gap_ = 0.0;
}

bool FrameMaker::credible(double travel, double elapsed, double told) const {
  if (elapsed < kRestart)
    return std::fabs(travel) <= 2.0 * model_.max_wheel_speed * (std::max(elapsed, gap_) + kLateness);
  const double way = kHaste * told * elapsed;
  return travel >= std::min(way, 0.0) - kPush && travel <= std::max(way, 0.0) + kPush;
}

void FrameMaker::measure(Frame& frame, const oi::Sensors& sensors, double elapsed, const ToldSpeeds& told) {
  const double distance = quirks_.distance_wrong ? 0.0 : sensors[PacketId::Distance] * 1e-3;
  const double half_turn =
      model_.protocol == oi::Model::Roomba400
          // The SCI reports half the wheels' difference in mm.
          ? sensors[PacketId::Angle] * 1e-3
          : 0.5 * model_.drive.wheel_separation * radians(oi::corrected_angle(sensors[PacketId::Angle], quirks_));
  const double left = distance - half_turn;
  const double right = distance + half_turn;
  // The first reading counts from whenever the robot was last asked, as an encoder's does.
  if (begun_ && credible(left, elapsed, told.left) && credible(right, elapsed, told.right)) {
    frame.left_travel = left;
    frame.right_travel = right;
  }
}

void FrameMaker::count_encoders(Frame& frame, const oi::Sensors& sensors, double elapsed, const ToldSpeeds& told) {
  const oi::EncoderCounts counts =
      oi::corrected_encoders(sensors[PacketId::LeftEncoderCounts], sensors[PacketId::RightEncoderCounts], quirks_);
  const double per_count = model_.drive.metres_per_count();
  constexpr int kAnyStep = 32767;
  const double left = per_count * left_encoder_.advance(static_cast<std::uint16_t>(counts.left), kAnyStep);
  const double right = per_count * right_encoder_.advance(static_cast<std::uint16_t>(counts.right), kAnyStep);
  if (begun_ && elapsed >= kRestart && is_fresh(counts.left) && is_fresh(counts.right)) {
    // What they counted since is way, mostly of rolling out.
    left_before_ = right_before_ = {};
    frame.left_travel = per_count * counts.left;
    frame.right_travel = per_count * counts.right;
    return;
  }
  frame.left_travel = believe(left, left_before_, elapsed, told.left);
  frame.right_travel = believe(right, right_before_, elapsed, told.right);
}

/// A wheel's way by its step, and by the one before it: where one takes the other back, a false count came between two
/// right ones, whether the first was believed or not.
double FrameMaker::believe(double step, CountedStep& before, double elapsed, double told) const {
  const CountedStep last = before;
  before = {step, true};
  if (credible(step + last.way, elapsed, told)) return last.believed ? step : step + last.way;
  if (credible(step, elapsed, told)) return step;
  before.believed = false;
  if (elapsed >= kRestart) before = {};  // the counter began anew: no later one takes this step back
  return 0.0;
}

}  // namespace scrubjay
