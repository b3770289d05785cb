/// \file
/// A byte channel that plays a script and keeps what is written to it; and bytes as robots send them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <scrubjay/oi/stream_parser.hpp>
#include <scrubjay/robot/byte_channel.hpp>
#include <span>
#include <utility>
#include <vector>

namespace scrubjay {

using Bytes = std::vector<std::uint8_t>;

inline constexpr double kTick = 0.015;  ///< between two frames of a stream [s]

inline const Bytes kStart{128};
inline const Bytes kSafe{131};

inline Bytes operator+(Bytes a, const Bytes& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// Gives one chunk a read; ends with the script.
class ScriptedChannel final : public ByteChannel {
 public:
  ByteRead read(std::span<std::uint8_t> buffer) override {
    if (script_.empty()) return {0, end_stamp, false};
    auto [bytes, stamp] = script_.front();
    script_.pop_front();
    if (bytes.size() > buffer.size()) {
      script_.emplace_front(Bytes(bytes.begin() + static_cast<std::ptrdiff_t>(buffer.size()), bytes.end()), stamp);
      bytes.resize(buffer.size());
    }
    std::copy(bytes.begin(), bytes.end(), buffer.begin());
    return {bytes.size(), stamp, true};
  }
  bool write(std::span<const std::uint8_t> bytes) override {
    written.emplace_back(bytes.begin(), bytes.end());
    return writable;
  }

  void give(double stamp, const Bytes& bytes) { script_.emplace_back(bytes, stamp); }
  /// What was written since the last call, a write each.
  std::vector<Bytes> take_written() { return std::exchange(written, {}); }

  std::vector<Bytes> written;
  bool writable = true;
  double end_stamp = 0.0;  ///< of the read that finds the end

 private:
  std::deque<std::pair<Bytes, double>> script_;
};

/// A stream frame of all packets of the model.
inline Bytes stream_frame(const oi::Sensors& sensors, oi::Model model = oi::Model::Create2) {
  const oi::SensorId all = model == oi::Model::Create2 ? oi::SensorId(100) : oi::SensorId(6);
  Bytes out(oi::kMaxStreamFrame);
  out.resize(oi::encode_stream_frame({&all, 1}, sensors, model, out));
  return out;
}

/// A reply of a Roomba 400 to the query for all packets.
inline Bytes reply(const oi::Sensors& sensors) {
  Bytes out(26);
  out.resize(oi::encode(oi::SensorId(0), sensors, oi::Model::Roomba400, out));
  return out;
}

/// Nothing pressed, in Safe mode, on its wheels.
inline oi::Sensors at_rest() {
  oi::Sensors sensors;
  sensors.set(oi::PacketId::OiMode, 2);
  return sensors;
}

/// At rest, with these encoder counts.
inline oi::Sensors counted(int left, int right) {
  oi::Sensors sensors = at_rest();
  sensors.set(oi::PacketId::LeftEncoderCounts, left);
  sensors.set(oi::PacketId::RightEncoderCounts, right);
  return sensors;
}

/// At rest, with these readings of packets 19 and 20.
inline oi::Sensors measured(int distance, int angle) {
  oi::Sensors sensors = at_rest();
  sensors.set(oi::PacketId::Distance, distance);
  sensors.set(oi::PacketId::Angle, angle);
  return sensors;
}

}  // namespace scrubjay
