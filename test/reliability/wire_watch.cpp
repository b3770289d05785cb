#include "wire_watch.hpp"

#include <algorithm>
#include <variant>

namespace scrubjay::reliability {
namespace {

constexpr double kMemory = 5.0;                // of what was told [s]
constexpr std::uint64_t kMostDelay = 2;        // of a frame that a wire without silence delivers late [ticks]
constexpr std::size_t kRememberedTicks = 300;  // a silence holds back what was on its way

bool same(const sim::WheelSpeeds& a, const sim::WheelSpeeds& b) {
  return a.left == b.left && a.right == b.right;
}

sim::WheelSpeeds speeds_of(const oi::DriveDirect& command) {
  return {command.left.value() * 1e-3, command.right.value() * 1e-3};
}

}  // namespace

ByteRead RobotEnd::read(std::span<std::uint8_t> buffer) {
  const std::uint64_t tick = roomba_.truth().ticks;
  const ByteRead read = roomba_.read(buffer);
  if (roomba_.truth().ticks != tick) look_at_wheels();
  parser_.feed(buffer.first(read.count), [&](const oi::StreamFrame& frame) {
    ++sent_count_;
    sent_.push_back({{frame.payload().begin(), frame.payload().end()}, roomba_.truth().ticks, sent_count_});
    if (sent_.size() > kRememberedTicks) sent_.pop_front();
  });
  return read;
}

bool RobotEnd::write(std::span<const std::uint8_t> bytes) {
  decoder_.feed(
      bytes, [this](const oi::Command& command) { foreign_commands_ += is_foreign(command); },
      [](const oi::Rejected&) {});
  return roomba_.write(bytes);
}

bool RobotEnd::is_foreign(const oi::Command& command) const {
  if (const auto* direct = std::get_if<oi::DriveDirect>(&command)) {
    const sim::WheelSpeeds speeds = speeds_of(*direct);
    return std::none_of(told_.begin(), told_.end(), [&](const Told& told) { return same(told.speeds, speeds); });
  }
  const oi::Opcode opcode = opcode_of(command);
  return opcode != oi::Opcode::Start && opcode != oi::Opcode::Safe && opcode != oi::Opcode::Stream &&
         opcode != oi::Opcode::Drive;
}

void RobotEnd::told(const sim::WheelSpeeds& speeds) {
  told_.push_back({speeds, roomba_.now(), carried_});
  while (told_.front().stamp < roomba_.now() - kMemory) told_.pop_front();
}

void RobotEnd::look_at_wheels() {
  const double now = roomba_.now();
  if (wire_ == nullptr || !wire_->is_silent()) carried_ += sim::kTick;
  const sim::WheelSpeeds wanted = roomba_.firmware().wanted();
  if (!same(wanted, obeyed_.speeds)) obeyed_ = {wanted, now, carried_};
  if (same(wanted, {})) return;
  Told since = obeyed_;
  for (const Told& told : told_) {
    if (same(told.speeds, wanted) && told.stamp > since.stamp) since = told;
  }
  stale_motion_ = std::max(stale_motion_, carried_ - since.carried);
  cut_motion_ = std::max(cut_motion_, now - since.stamp);
}

ByteRead ClientEnd::read(std::span<std::uint8_t> buffer) {
  const ByteRead read = wire_.read(buffer);
  parser_.feed(buffer.first(read.count), [this](const oi::StreamFrame& frame) { arrive(frame.payload()); });
  return read;
}

void ClientEnd::arrive(std::span<const std::uint8_t> payload) {
  // A robot that stands sends the same over and over. Of those before the first that came, the wire swallowed all but
  // what may still have been on its way; later ones come in order.
  const auto is_it = [&](const RobotEnd::Sent& sent) {
    const bool may_come =
        received_ == 0 ? sent.tick + kMostDelay >= robot_.sent().back().tick : sent.number > last_.number;
    return may_come && std::ranges::equal(sent.payload, payload);
  };
  const auto found = std::find_if(robot_.sent().begin(), robot_.sent().end(), is_it);
  if (found == robot_.sent().end()) {
    ++false_frames_;
    return;
  }
  last_ = *found;
  if (received_++ == 0) first_ = last_;
}

bool ClientEnd::write(std::span<const std::uint8_t> bytes) {
  const auto hear = [this](const oi::Command& command) {
    if (const auto* direct = std::get_if<oi::DriveDirect>(&command)) return robot_.told(speeds_of(*direct));
    const oi::Opcode opcode = opcode_of(command);
    if (opcode == oi::Opcode::Start || opcode == oi::Opcode::Drive) robot_.told({});
  };
  decoder_.feed(bytes, hear, [](const oi::Rejected&) {});
  return wire_.write(bytes);
}

}  // namespace scrubjay::reliability
