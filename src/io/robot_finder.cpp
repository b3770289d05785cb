#include "robot_finder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <scrubjay/error.hpp>
#include <scrubjay/oi/all_packets.hpp>
#include <scrubjay/oi/query.hpp>
#include <scrubjay/oi/quirks.hpp>
#include <scrubjay/oi/stream_parser.hpp>
#include <vector>

namespace scrubjay {
namespace {

using oi::Model;

constexpr double kLongestWait = 0.25;    // for an answer [s]
constexpr double kSpare = 0.1;           // of the time for all, for what takes longer than planned [s]
constexpr int kFramesToBelieveMode = 3;  // those on their way when the robot was told to be Passive are over by then
constexpr std::size_t kShownBytes = 8;   // of what isn't understood

/// The expected one in front.
std::vector<Model> dialects_to_try(Model expected) {
  std::vector<Model> dialects{expected};
  std::ranges::copy_if(oi::kRichestFirst, std::back_inserter(dialects), [&](Model one) { return one != expected; });
  return dialects;
}

class Finder {
 public:
  Finder(SerialPort& port, const SerialAddress& address, std::optional<Model> expected, double timeout,
         OiRobot::Session session, const std::stop_token& stop)
      : port_(port),
        name_(address.path.string()),
        dialects_(dialects_to_try(expected.value_or(Model::Create2))),
        rates_(rates_to_try(address)),
        end_(port.now() + timeout - kSpare),
        listens_(session == OiRobot::Session::Listen),
        stop_(stop) {}

  FoundRobot find() {
    // All dialects at all rates, and once more at the first one after waking.
    attempts_ = dialects_.size() * (rates_.size() + 1);
    if (listens_) {
      if (const auto robot = find_as_it_is()) return *robot;
    }
    if (const auto robot = try_rate(rates_.front(), false)) return *robot;
    if (heard_.empty() && port_.pulse_wake()) {
      could_wake_ = true;
      if (const auto robot = try_rate(rates_.front(), true)) return *robot;
    } else {
      attempts_ -= dialects_.size();
    }
    for (std::size_t i = 1; i < rates_.size(); ++i) {
      if (!set_rate(rates_[i])) {
        attempts_ -= dialects_.size();
      } else if (const auto robot = try_rate(rates_[i], could_wake_)) {
        return *robot;
      }
    }
    throw Error(nothing_found(), Error::Kind::Failure);
  }

 private:
  /// Without Start, which would take it out of Safe or Full mode.
  std::optional<FoundRobot> find_as_it_is() {
    const std::size_t later = attempts_;
    attempts_ += 2 * dialects_.size() * rates_.size();
    starts_ = false;
    for (std::size_t i = 0; i < rates_.size(); ++i) {
      if (i > 0 && !set_rate(rates_[i])) continue;
      if (auto robot = overhear(rates_[i])) return robot;
      if (auto robot = try_rate(rates_[i], false)) return robot;
    }
    starts_ = true;
    attempts_ = later;
    set_rate(rates_.front());
    return std::nullopt;
  }

  /// One that streams all packets already.
  std::optional<FoundRobot> overhear(int baud) {
    port_.discard();
    for (const Model dialect : dialects_) {
      const double wait = share_of_time();
      FoundRobot robot{.protocol = dialect, .baud = baud, .streamed_before = true};
      if (dialect != Model::Roomba400 && hears_frames(robot, wait)) return robot;
    }
    return std::nullopt;
  }

  /// For one of the attempts that are left [s].
  double share_of_time() {
    return std::clamp((end_ - port_.now()) / static_cast<double>(attempts_--), 0.03, kLongestWait);
  }

  std::optional<FoundRobot> try_rate(int baud, bool woken) {
    for (const Model dialect : dialects_) {
      if (stop_.stop_requested()) throw Error(name_ + ": stopped while looking for a robot", Error::Kind::Failure);
      const double wait = share_of_time();
      FoundRobot robot{.protocol = dialect, .baud = baud, .woken = woken};
      if (answers(robot, wait)) return robot;
    }
    return std::nullopt;
  }

  bool set_rate(int baud) {
    try {
      port_.set_baud(baud);
      return true;
    } catch (const Error&) {
      return false;  // this port can't
    }
  }

  void send(const oi::Command& command) { port_.write(encode(command)); }

  /// Reads what is there, and keeps its beginning for people.
  std::span<const std::uint8_t> read() {
    const ByteRead got = port_.read(buffer_);
    if (!got.open) throw Error(name_ + ": went away while looking for a robot", Error::Kind::Failure);
    const auto bytes = std::span<const std::uint8_t>(buffer_).first(got.count);
    const std::size_t wanted = std::min(bytes.size(), kShownBytes - heard_.size());
    heard_.insert(heard_.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(wanted));
    return bytes;
  }

  bool answers(FoundRobot& robot, double wait) {
    port_.discard();
    if (starts_) send(oi::Start{});
    return robot.protocol == Model::Roomba400 ? replies(wait) : streams(robot, wait);
  }

  bool streams(FoundRobot& robot, double wait) {
    send(oi::stream_of_all(robot.protocol));
    if (!hears_frames(robot, wait)) return false;
    if (!listens_) send(oi::PauseResumeStream{oi::Bounded<0, 1>(0)});
    return true;
  }

  /// Whether frames of all packets come.
  bool hears_frames(FoundRobot& robot, double wait) {
    oi::StreamParser parser(robot.protocol, oi::payload_of_all(robot.protocol));
    oi::Sensors sensors;
    std::uint64_t frames = 0;
    const double end = port_.now() + wait;
    while (frames < kFramesToBelieveMode && (port_.now() < end || frames > 0) && port_.now() < end + kLongestWait) {
      parser.feed(read(), [&](const oi::StreamFrame& frame) { frames += decode(frame, robot.protocol, sensors).ok; });
    }
    if (frames == 0) return false;
    robot.mode_one_too_high = starts_ && oi::is_one_too_high(sensors[oi::PacketId::OiMode], oi::OiMode::Passive);
    return true;
  }

  /// Whether a reply comes that is as long as it should be, makes sense, and has silence behind it.
  bool replies(double wait) {
    const oi::Query query{oi::all_packets(Model::Roomba400)};
    oi::QueryReader reply(Model::Roomba400);
    if (!reply.expect(query)) return false;
    send(query);
    oi::Sensors sensors;
    bool whole = true;
    for (const double end = port_.now() + wait; port_.now() < end;) {
      const auto bytes = read();
      if (bytes.empty() && reply.awaited() == 0) return whole && reply.rejected() == 0;
      whole = whole && reply.feed(bytes, sensors) == bytes.size();
    }
    return false;
  }

  std::string nothing_found() const {
    std::string rates;
    for (std::size_t i = 0; i < rates_.size(); ++i) {
      rates += fmt::format("{}{}", i == 0 ? "" : i + 1 == rates_.size() ? " or " : ", ", rates_[i]);
    }
    if (heard_.empty()) {
      return fmt::format(
          "{}: no robot answers at {} baud{}; press its Clean button to wake it, and check plug, cable "
          "and battery",
          name_, rates, could_wake_ ? ", and none wakes by the BRC pin" : "");
    }
    return fmt::format(
        "{}: something answers, but no robot that speaks the Open Interface at {} baud (first bytes: "
        "{:02X}); want the robot's port; or restart the robot, should another program talk to it or its "
        "rate be another one",
        name_, rates, fmt::join(heard_, " "));
  }

  SerialPort& port_;
  std::string name_;
  std::vector<Model> dialects_;
  std::vector<int> rates_;
  double end_;
  bool listens_;
  bool starts_ = true;  // brings the robot to Passive mode before it is asked
  const std::stop_token& stop_;
  std::size_t attempts_ = 0;  // left
  bool could_wake_ = false;
  std::array<std::uint8_t, 1024> buffer_{};
  std::vector<std::uint8_t> heard_;  // first bytes that came
};

}  // namespace

FoundRobot find_robot(SerialPort& port, const SerialAddress& address, std::optional<Model> expected, double timeout,
                      OiRobot::Session session, const std::stop_token& stop) {
  return Finder(port, address, expected, timeout, session, stop).find();
}

const char* name_of(Model protocol) {
  switch (protocol) {
    case Model::Create2:
      return "Create 2";
    case Model::Create1:
      return "Create 1";
    case Model::Roomba400:
      return "Roomba 400";
  }
  return "";
}

}  // namespace scrubjay
