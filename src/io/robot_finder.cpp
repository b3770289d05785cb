#include "robot_finder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <scrubjay/error.hpp>
#include <scrubjay/oi/command.hpp>
#include <scrubjay/oi/query.hpp>
#include <scrubjay/oi/stream_parser.hpp>
#include <vector>

namespace scrubjay {
namespace {

using oi::Model;

constexpr std::array<Model, 3> kDialects{Model::Create2, Model::Create1, Model::Roomba400};
constexpr std::array<int, 3> kRates{115200, 57600, 19200};
constexpr double kLongestWait = 0.25;    // for an answer [s]
constexpr double kSpare = 0.1;           // of the time for all, for what takes longer than planned [s]
constexpr int kFramesToBelieveMode = 3;  // those on their way when the robot was told to be Passive are over by then
constexpr std::size_t kShownBytes = 8;   // of what isn't understood
constexpr int kPassive = 1;              // packet 35

/// Puts the wanted one in front.
template <typename T, std::size_t N>
std::vector<T> first_of_all(const std::array<T, N>& known, T wanted) {
  std::vector<T> all{wanted};
  std::ranges::copy_if(known, std::back_inserter(all), [&](T one) { return one != wanted; });
  return all;
}

class Finder {
 public:
  Finder(SerialPort& port, const SerialAddress& address, std::optional<Model> expected, double timeout,
         const std::stop_token& stop)
      : port_(port),
        name_(address.path.string()),
        dialects_(first_of_all(kDialects, expected.value_or(Model::Create2))),
        rates_(first_of_all(kRates, address.baud)),
        end_(port.now() + timeout - kSpare),
        stop_(stop) {}

  FoundRobot find() {
    // All dialects at all rates, and once more at the first one after waking.
    attempts_ = dialects_.size() * (rates_.size() + 1);
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
  std::optional<FoundRobot> try_rate(int baud, bool woken) {
    for (const Model dialect : dialects_) {
      if (stop_.stop_requested()) throw Error(name_ + ": stopped while looking for a robot", Error::Kind::Failure);
      const double wait = std::clamp((end_ - port_.now()) / static_cast<double>(attempts_--), 0.03, kLongestWait);
      FoundRobot robot{dialect, baud, woken, false};
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
    send(oi::Start{});
    return robot.protocol == Model::Roomba400 ? replies(wait) : streams(robot, wait);
  }

  /// Whether frames of all packets come.
  bool streams(FoundRobot& robot, double wait) {
    const oi::SensorId all = robot.protocol == Model::Create2 ? oi::SensorId(100) : oi::SensorId(6);
    if (const auto ids = oi::FixedList<oi::SensorId, 0, 255>::of({&all, 1})) send(oi::Stream{*ids});
    oi::StreamParser parser(robot.protocol, static_cast<std::uint8_t>(all.bytes() + 1));
    oi::Sensors sensors;
    std::uint64_t frames = 0;
    const double end = port_.now() + wait;
    while (frames < kFramesToBelieveMode && (port_.now() < end || frames > 0) && port_.now() < end + kLongestWait) {
      parser.feed(read(), [&](const oi::StreamFrame& frame) { frames += decode(frame, robot.protocol, sensors).ok; });
    }
    if (frames == 0) return false;
    robot.mode_one_too_high = sensors[oi::PacketId::OiMode] == kPassive + 1;
    send(oi::PauseResumeStream{oi::Bounded<0, 1>(0)});
    return true;
  }

  /// Whether a reply comes that is as long as it should be, makes sense, and has silence behind it.
  bool replies(double wait) {
    const oi::Query query{oi::SensorId(0)};
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
  const std::stop_token& stop_;
  std::size_t attempts_ = 0;  // left
  bool could_wake_ = false;
  std::array<std::uint8_t, 1024> buffer_{};
  std::vector<std::uint8_t> heard_;  // first bytes that came
};

}  // namespace

FoundRobot find_robot(SerialPort& port, const SerialAddress& address, std::optional<Model> expected, double timeout,
                      const std::stop_token& stop) {
  return Finder(port, address, expected, timeout, stop).find();
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
