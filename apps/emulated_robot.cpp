#include "emulated_robot.hpp"

#include <cmath>
#include <string_view>

#include "random_streams.hpp"

namespace scrubjay::apps {
namespace {

/// What a serial line at the model's own baud rate carries in a tick, ten bits a byte.
std::size_t bytes_per_tick(oi::Model protocol) {
  const double baud = protocol == oi::Model::Create2 ? 115'200.0 : 57'600.0;
  return static_cast<std::size_t>(baud / 10.0 * sim::kTick);
}

std::string_view name_of(oi::OiMode mode) {
  constexpr std::array<std::string_view, 4> kNames{"off", "passive", "safe", "full"};
  return kNames[static_cast<std::size_t>(mode)];
}

nlohmann::ordered_json to_json(const Pose2& pose) {
  return nlohmann::ordered_json::array({pose.x, pose.y, pose.yaw});
}

bool is_dark(const sim::Indicators& shown) {
  return shown.leds == 0 && shown.power_color == 0 && shown.power_intensity == 0 && shown.motors == 0 &&
         shown.digits == std::array<std::uint8_t, 4>{};
}

}  // namespace

EmulatedRobot::EmulatedRobot(const Stage& stage, const Pose2& start, std::size_t number, const EmulatedFaults& faults,
                             const Random& random, const std::filesystem::path& link)
    : roomba_(stage.world, stage.index, stage.robot, stage.noise, random.fork(kRobotStream + number * kStreamsPerRobot),
              start, faults.firmware, faults.body),
      wire_(roomba_, faults.wire, random.fork(kWireStream + number * kStreamsPerRobot)),
      link_(link),
      terminal_(link),
      number_(number),
      bytes_per_tick_(bytes_per_tick(stage.robot.model.protocol)),
      start_(start),
      last_yaw_(start.yaw),
      buffer_(4096) {}

void EmulatedRobot::tick() {
  const ByteRead read = terminal_.read(std::span(buffer_).first(bytes_per_tick_));
  received_ += read.count;
  if (read.count > 0) wire_.write(std::span(buffer_).first(read.count));
  // A read that finds nothing to hand out advances the world by a tick.
  const std::uint64_t before = truth().ticks;
  while (truth().ticks == before) {
    const ByteRead answer = wire_.read(buffer_);
    sent_ += answer.count;
    if (answer.count > 0) terminal_.write(std::span(buffer_).first(answer.count));
  }
  look();
}

void EmulatedRobot::look() {
  const sim::Firmware& firmware = roomba_.firmware();
  turned_ += angle_difference(truth().pose.yaw, last_yaw_);
  last_yaw_ = truth().pose.yaw;
  ++mode_ticks_[static_cast<std::size_t>(firmware.mode())];
  // A change of mode puts the lights out; that isn't the client's doing.
  if (!is_dark(firmware.indicators())) shown_ = firmware.indicators();
}

nlohmann::ordered_json EmulatedRobot::now_json() const {
  const sim::Firmware& firmware = roomba_.firmware();
  return {
      {"time", now()},     {"robot", number_},       {"pose", to_json(truth().pose)},    {"distance", truth().distance},
      {"turned", turned_}, {"bumps", truth().bumps}, {"mode", name_of(firmware.mode())}, {"asleep", firmware.asleep()}};
}

nlohmann::ordered_json EmulatedRobot::account() const {
  const sim::Firmware& firmware = roomba_.firmware();
  nlohmann::ordered_json account{{"link", link_.string()}, {"start", to_json(start_)}};
  account.update(now_json());
  nlohmann::ordered_json& seconds = account["seconds_in_mode"];
  for (std::size_t i = 0; i < mode_ticks_.size(); ++i) {
    seconds[std::string(name_of(static_cast<oi::OiMode>(i)))] = static_cast<double>(15 * mode_ticks_[i]) / 1000.0;
  }
  account["leds"] = {shown_.leds, shown_.power_color, shown_.power_intensity};
  account["digits"] = shown_.digits;
  account["motors"] = shown_.motors;
  account["songs_played"] = firmware.songs_played();
  account["rejected_commands"] = firmware.rejected_commands();
  account["bytes"] = {{"received", received_}, {"sent", sent_}, {"unread", terminal_.dropped()}};
  const sim::WireFaultCounters& wire = wire_.counters();
  account["wire"] = {{"dropped", wire.dropped},
                     {"flipped", wire.flipped},
                     {"delayed", wire.delayed},
                     {"silences", wire.silences},
                     {"silenced", wire.silenced}};
  return account;
}

}  // namespace scrubjay::apps
