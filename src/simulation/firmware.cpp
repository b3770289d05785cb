#include <algorithm>
#include <cmath>
#include <scrubjay/oi/infrared.hpp>
#include <scrubjay/oi/opcode.hpp>
#include <scrubjay/oi/stream_parser.hpp>
#include <scrubjay/simulation/firmware.hpp>
#include <scrubjay/simulation/roomba_body.hpp>

namespace scrubjay::sim {
namespace {

using oi::PacketId;

int wire(double value) {
  return static_cast<int>(std::lround(value));
}

int counts(double signal) {
  return std::clamp(static_cast<int>(signal + 0.5), 0, 4095);
}

/// Queries that wait for a tick, at most: at 115,200 baud no more bytes than this can come in one.
constexpr std::size_t kMaxQueries = 172 / 2;

constexpr double kFloorSignal = 2500.0;  // of a cliff sensor over floor; own guess, as is that over none
constexpr double kNoFloorSignal = 20.0;

/// What Drive means for the wheels. Where the outer one can't be as fast as that, both are slower: the radius stays.
/// A radius of 0, as in the four zeros that many a client stops with, is straight; own guess.
WheelSpeeds speeds_on_arc(double speed, oi::Radius radius, const RobotModel& model) {
  const int millimetres = radius.value();
  if (radius.is_straight() || millimetres == 0) return {speed, speed};
  if (std::abs(millimetres) == 1) return {-speed * millimetres, speed * millimetres};
  const double share = 0.5 * model.drive.wheel_separation / (millimetres * 1e-3);
  const double outer = std::fabs(speed) * (1.0 + std::fabs(share));
  const double slower = outer > model.max_wheel_speed ? model.max_wheel_speed / outer : 1.0;
  return {slower * speed * (1.0 - share), slower * speed * (1.0 + share)};
}

}  // namespace

Firmware::Firmware(const RobotSpec& spec, const FirmwareOptions& options)
    : spec_(spec), model_(spec.model.protocol), options_(options), decoder_(model_) {
  left_counted_ = right_counted_ = options.encoder_start;
}

void Firmware::receive(std::span<const std::uint8_t> bytes) {
  decoder_.feed(
      bytes, [this](const oi::Command& command) { obey(command); }, [this](const oi::Rejected&) { ++rejected_; });
}

void Firmware::obey(const oi::Command& command) {
  const oi::Opcode opcode = opcode_of(command);
  if (!allowed_in(opcode, mode_, model_)) {
    ++rejected_;
    return;
  }
  act(command);
  if (const auto after = oi::opcode_info(opcode, model_)->mode_after) enter(*after);
}

void Firmware::enter(oi::OiMode mode) {
  if (mode == mode_) return;
  mode_ = mode;
  // Whoever takes or loses control finds the robot standing.
  drive(0.0, 0.0);
  indicators_ = {};
  if (mode == oi::OiMode::Off) {
    streaming_ = false;
    queries_.clear();
  }
}

void Firmware::drive(double left, double right) {
  const double limit = spec_.model.max_wheel_speed;
  wanted_ = {std::clamp(left, -limit, limit), std::clamp(right, -limit, limit)};
}

void Firmware::act(const oi::Command& command) {
  if (const auto* direct = std::get_if<oi::DriveDirect>(&command)) {
    right_velocity_ = direct->right.value();
    left_velocity_ = direct->left.value();
    return drive(left_velocity_ * 1e-3, right_velocity_ * 1e-3);
  }
  if (const auto* arc = std::get_if<oi::Drive>(&command)) {
    velocity_ = arc->velocity.value();
    radius_ = arc->radius.value();
    const WheelSpeeds arc_speeds = speeds_on_arc(velocity_ * 1e-3, arc->radius, spec_.model);
    return drive(arc_speeds.left, arc_speeds.right);
  }
  if (const auto* pwm = std::get_if<oi::DrivePwm>(&command)) {
    const double full = spec_.model.max_wheel_speed / 255.0;
    return drive(full * pwm->left.value(), full * pwm->right.value());
  }
  if (const auto* list = std::get_if<oi::Stream>(&command)) {
    stream_.assign(list->ids.begin(), list->ids.end());
    streaming_ = !stream_.empty();
    return;
  }
  if (const auto* pause = std::get_if<oi::PauseResumeStream>(&command)) {
    streaming_ = pause->state.value() == 1 && !stream_.empty();
    return;
  }
  if (std::holds_alternative<oi::Query>(command) || std::holds_alternative<oi::QueryList>(command)) {
    if (queries_.size() < kMaxQueries) {
      queries_.push_back(command);
    } else {
      ++rejected_;
    }
    return;
  }
  if (const auto* song = std::get_if<oi::Song>(&command)) {
    songs_[static_cast<std::size_t>(song->slot.value())].assign(song->notes.begin(), song->notes.end());
    return;
  }
  if (const auto* play = std::get_if<oi::Play>(&command)) {
    if (song_left_ > 0.0) return;
    song_ = play->slot.value();
    for (const oi::Note& note : songs_[static_cast<std::size_t>(song_)]) song_left_ += note.duration / 64.0;
    return;
  }
  if (const auto* leds = std::get_if<oi::Leds>(&command)) {
    indicators_.leds = leds->bits;
    indicators_.power_color = leds->power_color;
    indicators_.power_intensity = leds->power_intensity;
    return;
  }
  if (const auto* raw = std::get_if<oi::DigitLedsRaw>(&command)) {
    indicators_.digits = raw->digits;
    return;
  }
  if (const auto* text = std::get_if<oi::DigitLedsAscii>(&command)) {
    std::transform(text->digits.begin(), text->digits.end(), indicators_.digits.begin(),
                   [](oi::Ascii digit) { return static_cast<std::uint8_t>(digit.value()); });
    return;
  }
  if (const auto* motors = std::get_if<oi::Motors>(&command)) indicators_.motors = motors->bits;
}

void Firmware::tick(const BodySenses& senses, std::vector<std::uint8_t>& out) {
  heed_safety(senses);
  store(senses);
  for (const oi::Command& query : queries_) answer(query, out);
  queries_.clear();
  play_on();
  if (!streaming_) return;
  const std::size_t before = out.size();
  out.resize(before + oi::kMaxStreamFrame);
  const std::size_t size = oi::encode_stream_frame(stream_, sensors_, model_, std::span(out).subspan(before));
  out.resize(before + size);
  if (size == 0) return;  // more than a frame can hold
  for (const oi::SensorId id : stream_) forget_travel(id);
}

void Firmware::answer(const oi::Command& command, std::vector<std::uint8_t>& out) {
  const auto send = [&](oi::SensorId id) {
    const std::size_t before = out.size();
    out.resize(before + id.bytes());
    out.resize(before + oi::encode(id, sensors_, model_, std::span(out).subspan(before)));
    forget_travel(id);
  };
  if (const auto* query = std::get_if<oi::Query>(&command)) send(query->id);
  if (const auto* list = std::get_if<oi::QueryList>(&command)) {
    for (const oi::SensorId id : list->ids) send(id);
  }
}

void Firmware::heed_safety(const BodySenses& senses) {
  oi::SafetyInputs inputs;
  inputs.wheel_drop = senses.wheel_drop_left || senses.wheel_drop_right;
  inputs.cliff = senses.cliff_flags != 0;
  inputs.charger = senses.docked;
  inputs.right_velocity = wire(wanted_.right * 1000.0);
  inputs.left_velocity = wire(wanted_.left * 1000.0);
  enter(mode_after_safety(mode_, inputs));
}

void Firmware::play_on() {
  song_left_ = std::max(0.0, song_left_ - kTick);
}

void Firmware::store(const BodySenses& senses) {
  oi::Sensors& s = sensors_;
  const auto flag = [](bool set, int bit) { return (set ? 1 : 0) << bit; };
  s.set(PacketId::BumpsAndWheelDrops, flag(senses.bump_right, 0) | flag(senses.bump_left, 1) |
                                          flag(senses.wheel_drop_right, 2) | flag(senses.wheel_drop_left, 3));
  s.set(PacketId::Wall, senses.wall);
  for (int i = 0; i < kCliffSensorCount; ++i) {
    const bool open = (senses.cliff_flags >> i & 1) != 0;
    s.set(static_cast<PacketId>(number(PacketId::CliffLeft) + i), open);
    s.set(static_cast<PacketId>(number(PacketId::CliffLeftSignal) + i), counts(open ? kNoFloorSignal : kFloorSignal));
  }
  s.set(PacketId::VirtualWall, senses.virtual_wall);
  s.set(PacketId::WheelOvercurrents, flag(senses.wheel_blocked[1], 3) | flag(senses.wheel_blocked[0], 4));
  s.set(PacketId::DirtDetect, senses.dirt);
  const auto character = [&](std::uint8_t received) { return received == 0 ? oi::no_character(model_) : received; };
  s.set(PacketId::InfraredCharacterOmni, character(senses.infrared_omni));
  s.set(PacketId::InfraredCharacterLeft, character(senses.infrared_left));
  s.set(PacketId::InfraredCharacterRight, character(senses.infrared_right));
  store_travel(senses);
  s.set(PacketId::ChargingState, senses.battery.charging ? 2 : 0);
  s.set(PacketId::Voltage, wire(senses.battery.voltage * 1000.0));
  s.set(PacketId::Current, wire(senses.battery.current * 1000.0));
  s.set(PacketId::Temperature, wire(senses.battery.temperature));
  s.set(PacketId::BatteryCharge, wire(senses.battery.charge * 1000.0));
  s.set(PacketId::BatteryCapacity, wire(senses.battery.capacity * 1000.0));
  s.set(PacketId::WallSignal, counts(senses.wall_signal));
  s.set(PacketId::ChargingSourcesAvailable, senses.docked ? 2 : 0);
  store_requests();
  s.set(PacketId::LightBumper, senses.light_flags);
  for (std::size_t i = 0; i < senses.light_signal.size(); ++i) {
    s.set(static_cast<PacketId>(number(PacketId::LightBumpLeftSignal) + i), counts(senses.light_signal[i]));
  }
  s.set(PacketId::Stasis, senses.making_way);
}

void Firmware::store_requests() {
  oi::Sensors& s = sensors_;
  s.set(PacketId::OiMode, static_cast<int>(mode_) + (options_.quirks.mode_one_too_high ? 1 : 0));
  s.set(PacketId::SongNumber, song_);
  s.set(PacketId::SongPlaying, song_left_ > 0.0);
  s.set(PacketId::NumberOfStreamPackets, static_cast<int>(stream_.size()));
  s.set(PacketId::RequestedVelocity, velocity_);
  s.set(PacketId::RequestedRadius, options_.quirks.requested_radius_wrong ? 0 : radius_);
  s.set(PacketId::RequestedRightVelocity, right_velocity_);
  s.set(PacketId::RequestedLeftVelocity, left_velocity_);
}

void Firmware::store_travel(const BodySenses& senses) {
  double left = senses.left_rolled - left_before_;
  double right = senses.right_rolled - right_before_;
  left_before_ = senses.left_rolled;
  right_before_ = senses.right_rolled;
  if (options_.quirks.sign_from_command) {  // the wheels' encoders have one channel: they can't tell the direction
    if (wanted_.left != 0.0) left = std::copysign(left, wanted_.left);
    if (wanted_.right != 0.0) right = std::copysign(right, wanted_.right);
  }
  const DifferentialDrive& drive = spec_.model.drive;
  left_counted_ += left / drive.metres_per_count();
  right_counted_ += right / drive.metres_per_count();
  // Capped where their bytes end.
  const auto capped = [](double value) { return std::clamp(value, -32768.0, 32767.0); };
  const double angle_unit =
      model_ == oi::Model::Roomba400 ? 500.0 * drive.wheel_separation : degrees(1.0) * options_.quirks.angle_divisor;
  distance_ = capped(distance_ + 500.0 * (left + right));
  angle_ = capped(angle_ + (right - left) / drive.wheel_separation * angle_unit);

  oi::Sensors& s = sensors_;
  const auto reading = [](double counted) {
    return static_cast<std::int16_t>(static_cast<std::uint16_t>(static_cast<std::int64_t>(std::floor(counted))));
  };
  const std::int16_t left_reading = reading(left_counted_);
  const std::int16_t right_reading = reading(right_counted_);
  s.set(PacketId::LeftEncoderCounts, options_.quirks.swapped_encoders ? right_reading : left_reading);
  s.set(PacketId::RightEncoderCounts, options_.quirks.swapped_encoders ? left_reading : right_reading);
  // Whole units are sent; what is left over stays for the next time.
  s.set(PacketId::Distance, options_.quirks.distance_wrong ? 0 : static_cast<int>(distance_));
  s.set(PacketId::Angle, static_cast<int>(angle_));
}

/// Distance and angle count from the last time that they were sent.
void Firmware::forget_travel(oi::SensorId sent) {
  const auto covers = [&](PacketId id) { return sent.run().first <= number(id) && number(id) <= sent.run().last; };
  if (covers(PacketId::Distance)) {
    distance_ -= sensors_[PacketId::Distance];
    sensors_.set(PacketId::Distance, 0);  // whoever asks again within the tick
  }
  if (covers(PacketId::Angle)) {
    angle_ -= sensors_[PacketId::Angle];
    sensors_.set(PacketId::Angle, 0);
  }
}

}  // namespace scrubjay::sim
