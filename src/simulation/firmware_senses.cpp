#include <algorithm>
#include <cmath>
#include <scrubjay/oi/infrared.hpp>
#include <scrubjay/simulation/firmware.hpp>

// What the firmware makes of the senses: safety, and the packets.

namespace scrubjay::sim {
namespace {

using oi::PacketId;

int wire(double value) {
  return static_cast<int>(std::lround(value));
}

int counts(double signal) {
  return std::clamp(static_cast<int>(signal + 0.5), 0, 4095);
}

constexpr double kFloorSignal = 2500.0;  // of a cliff sensor over floor; own guess, as is that over none
constexpr double kNoFloorSignal = 20.0;

}  // namespace

void Firmware::heed_safety(const BodySenses& senses) {
  oi::SafetyInputs inputs;
  inputs.wheel_drop = senses.wheel_drop_left || senses.wheel_drop_right;
  inputs.cliff = senses.cliff_flags != 0;
  inputs.charger = senses.docked;
  inputs.right_velocity = wire(wanted_.right * 1000.0);
  inputs.left_velocity = wire(wanted_.left * 1000.0);
  enter(mode_after_safety(mode_, inputs));
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
  s.set(PacketId::Buttons, buttons_left_ > 0.0 ? buttons_ : 0);
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
