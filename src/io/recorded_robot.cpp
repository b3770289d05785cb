#include <scrubjay/io/recorded_robot.hpp>

namespace scrubjay {
namespace {

using oi::PacketId;

constexpr double kReplyTimeout = 0.25;  // a reply that isn't whole by then won't be [s]

}  // namespace

RecordedRobot::RecordedRobot(RecordingReader& reader, const RobotModel& model, const oi::FirmwareQuirks& quirks)
    : reader_(reader),
      model_(model),
      commands_(model.protocol),
      stream_(model.protocol),
      reply_(model.protocol),
      frame_maker_(model, quirks) {}

std::optional<Frame> RecordedRobot::next() {
  while (frames_.empty()) {
    const std::optional<RecordedBytes> chunk = reader_.next();
    if (!chunk) return std::nullopt;
    if (chunk->direction == Direction::Sent) {
      commands_.feed(
          chunk->bytes, [&](const oi::Command& command) { heed(command, chunk->stamp); }, [](const oi::Rejected&) {});
    } else {
      take(chunk->bytes, chunk->stamp);
    }
  }
  const Frame frame = frames_.front();
  frames_.pop_front();
  return frame;
}

void RecordedRobot::heed(const oi::Command& command, double stamp) {
  if (std::holds_alternative<oi::Query>(command) || std::holds_alternative<oi::QueryList>(command)) {
    asked_.push_back({command, stamp});
  } else if (const auto* list = std::get_if<oi::Stream>(&command)) {
    streaming_ = list->ids.begin() != list->ids.end();
  } else if (const auto* pause = std::get_if<oi::PauseResumeStream>(&command)) {
    streaming_ = pause->state.value() == 1;
  } else if (std::holds_alternative<oi::Reset>(command) || std::holds_alternative<oi::Power>(command) ||
             std::holds_alternative<oi::Stop>(command)) {
    streaming_ = false;
    asked_.clear();
    reply_.reset();
  } else if (const auto* direct = std::get_if<oi::DriveDirect>(&command)) {
    told_ = {direct->left.value() * 1e-3, direct->right.value() * 1e-3};
  } else if (const auto* arc = std::get_if<oi::Drive>(&command)) {
    const double speed = arc->velocity.value() * 1e-3;
    const int radius = arc->radius.value();
    told_ = {radius == 1 ? -speed : speed, radius == -1 ? -speed : speed};
  } else if (const auto* pwm = std::get_if<oi::DrivePwm>(&command)) {
    const double full = model_.max_wheel_speed / 255.0;
    told_ = {full * pwm->left.value(), full * pwm->right.value()};
  }
}

/// Distance and angle count once: in the frame of the reading that brought them.
void RecordedRobot::forget_way() {
  if (sensors_.has(PacketId::Distance)) sensors_.set(PacketId::Distance, 0);
  if (sensors_.has(PacketId::Angle)) sensors_.set(PacketId::Angle, 0);
}

void RecordedRobot::add_frame(double stamp) {
  const double elapsed = stamp - last_stamp_;
  last_stamp_ = stamp;
  frames_.push_back(frame_maker_.make(sensors_, stamp, elapsed, told_));
  forget_way();
}

void RecordedRobot::take(std::span<const std::uint8_t> bytes, double stamp) {
  if (reply_.awaited() > 0 && stamp - asked_stamp_ > kReplyTimeout) reply_.reset();
  while (!asked_.empty() && stamp - asked_.front().stamp > kReplyTimeout) asked_.pop_front();
  if (!streaming_) bytes = take_reply(bytes, stamp);
  stream_.feed(bytes, [&](const oi::StreamFrame& frame) {
    if (decode(frame, model_.protocol, sensors_).ok) add_frame(stamp);
  });
}

/// Takes replies off the front, and gives what is left.
std::span<const std::uint8_t> RecordedRobot::take_reply(std::span<const std::uint8_t> bytes, double stamp) {
  while (!bytes.empty() && (reply_.awaited() > 0 || await_next())) {
    bytes = bytes.subspan(reply_.feed(bytes, sensors_));
    if (reply_.awaited() == 0) add_frame(stamp);
  }
  return bytes;
}

bool RecordedRobot::await_next() {
  while (!asked_.empty()) {
    const Asked next = asked_.front();
    asked_.pop_front();
    asked_stamp_ = next.stamp;
    const auto* one = std::get_if<oi::Query>(&next.query);
    const bool awaits = one != nullptr ? reply_.expect(*one) : reply_.expect(std::get<oi::QueryList>(next.query));
    if (awaits && reply_.awaited() > 0) return true;
  }
  return false;
}

}  // namespace scrubjay
