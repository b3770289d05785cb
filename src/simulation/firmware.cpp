#include <algorithm>
#include <cmath>
#include <scrubjay/oi/opcode.hpp>
#include <scrubjay/oi/stream_parser.hpp>
#include <scrubjay/simulation/firmware.hpp>
#include <scrubjay/simulation/roomba_body.hpp>
#include <utility>

#include "boot_banner.hpp"

namespace scrubjay::sim {
namespace {

/// Queries that wait for a tick, at most: at 115,200 baud no more bytes than this can come in one.
constexpr std::size_t kMaxQueries = 172 / 2;

constexpr double kButtonPress = 1.0 / 6.0;       // [s]
constexpr std::uint8_t kReportedButtons = 0x3F;  // schedule and clock never are: a bug of the firmware

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

/// The bits of Motors that turn the same motors the same way.
std::uint8_t motor_bits(const oi::PwmMotors& pwm) {
  const auto bit = [](bool set, std::uint8_t value) { return set ? value : std::uint8_t{0}; };
  return static_cast<std::uint8_t>(bit(pwm.side_brush.value() != 0, oi::Motors::kSideBrush) |
                                   bit(pwm.vacuum.value() != 0, oi::Motors::kVacuum) |
                                   bit(pwm.main_brush.value() != 0, oi::Motors::kMainBrush) |
                                   bit(pwm.side_brush.value() < 0, oi::Motors::kSideBrushClockwise) |
                                   bit(pwm.main_brush.value() < 0, oi::Motors::kMainBrushReverse));
}

}  // namespace

Firmware::Firmware(const RobotSpec& spec, const FirmwareOptions& options)
    : spec_(spec), model_(spec.model.protocol), options_(options), decoder_(model_), asleep_(options.asleep) {
  left_counted_ = right_counted_ = options.encoder_start;
}

void Firmware::receive(std::span<const std::uint8_t> bytes) {
  if (asleep_) return;
  decoder_.feed(
      bytes, [this](const oi::Command& command) { obey(command); }, [this](const oi::Rejected&) { ++rejected_; });
}

void Firmware::obey(const oi::Command& command) {
  if (asleep_) return;  // since a command before this one
  idle_ = 0.0;
  const oi::Opcode opcode = opcode_of(command);
  if (boot_left_ > 0.0 || !allowed_in(opcode, mode_, model_)) {
    ++rejected_;
    return;
  }
  if (opcode == oi::Opcode::Reset) return reboot();
  act(command);
  if (const auto after = oi::opcode_info(opcode, model_)->mode_after) enter(*after);
  if (opcode == oi::Opcode::Power) fall_asleep();
}

void Firmware::reboot() {
  Firmware booting(spec_, options_);
  booting.decoder_ = decoder_;  // it is at work
  booting.rejected_ = rejected_;
  booting.left_before_ = left_before_;
  booting.right_before_ = right_before_;
  booting.boot_left_ = kBootTime;
  booting.songs_played_ = songs_played_;
  booting.asleep_ = false;
  *this = std::move(booting);
}

/// The boot loader speaks in its first tick, the robot in its last.
void Firmware::boot_on(std::vector<std::uint8_t>& out) {
  const auto print = [&](const std::string& text) { out.insert(out.end(), text.begin(), text.end()); };
  if (boot_left_ == kBootTime) print(boot_loader_banner());
  boot_left_ = std::max(0.0, boot_left_ - kTick);
  if (boot_left_ == 0.0) print(ready_banner(options_.release));
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
    songs_played_ += song_left_ > 0.0;
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
  if (const auto* buttons = std::get_if<oi::Buttons>(&command)) {
    buttons_ = buttons->bits & kReportedButtons;
    buttons_left_ = kButtonPress;
    return;
  }
  if (const auto* motors = std::get_if<oi::Motors>(&command)) indicators_.motors = motors->bits;
  if (const auto* motors = std::get_if<oi::PwmMotors>(&command)) indicators_.motors = motor_bits(*motors);
}

void Firmware::tick(const BodySenses& senses, std::vector<std::uint8_t>& out) {
  if (asleep_) return;
  if (boot_left_ > 0.0) boot_on(out);
  heed_safety(senses);
  store(senses);
  for (const oi::Command& query : queries_) answer(query, out);
  queries_.clear();
  pass_time(senses.docked);
  if (idle_ >= kSleepAfter) fall_asleep();
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

void Firmware::fall_asleep() {
  asleep_ = true;
  drive(0.0, 0.0);
  indicators_ = {};
  streaming_ = false;
  queries_.clear();
  song_left_ = 0.0;
}

void Firmware::pulse_brc() {
  idle_ = 0.0;
  if (!asleep_) return;
  asleep_ = false;
  decoder_ = oi::CommandDecoder(model_);
  mode_ = oi::OiMode::Off;
}

void Firmware::pass_time(bool docked) {
  const bool rests = mode_ == oi::OiMode::Passive && !docked;
  idle_ = rests ? idle_ + kTick : 0.0;
  song_left_ = std::max(0.0, song_left_ - kTick);
  buttons_left_ = std::max(0.0, buttons_left_ - kTick);
}

}  // namespace scrubjay::sim
