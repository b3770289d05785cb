/// \file
/// A firmware on the bench: bytes in, senses set by hand, bytes out.
#pragma once

#include <scrubjay/oi/command.hpp>
#include <scrubjay/oi/sensors.hpp>
#include <scrubjay/simulation/firmware.hpp>
#include <vector>

namespace scrubjay::test {

using Bytes = std::vector<std::uint8_t>;

inline sim::RobotSpec speaking(oi::Model protocol) {
  sim::RobotSpec spec;
  spec.model.protocol = protocol;
  return spec;
}

class FirmwareBench {
 public:
  explicit FirmwareBench(oi::Model protocol = oi::Model::Create2, const sim::FirmwareOptions& options = {})
      : firmware(speaking(protocol), options), protocol_(protocol) {}

  void send(const Bytes& bytes) { firmware.receive(bytes); }
  void send(const oi::Command& command) { firmware.receive(encode(command)); }
  /// One tick, and what it brought.
  Bytes tick() {
    Bytes out;
    firmware.tick(senses, out);
    return out;
  }
  Bytes tick(int count) {
    Bytes last;
    for (int i = 0; i < count; ++i) last = tick();
    return last;
  }
  /// Asks for one packet or group, the last thing that it sends in the tick.
  Bytes ask(int id) {
    send({142, static_cast<std::uint8_t>(id)});
    return tick();
  }
  /// The value of a packet of one or two bytes, as signed as the table says.
  int value(oi::PacketId id) {
    const Bytes reply = ask(number(id));
    oi::Sensors sensors;
    return decode(id, reply, protocol_, sensors).ok ? sensors[id] : -1'000'000;
  }
  /// Rolls both wheels on [m].
  void roll(double left, double right) {
    senses.left_rolled += left;
    senses.right_rolled += right;
  }

  sim::Firmware firmware;
  sim::BodySenses senses;

 private:
  oi::Model protocol_;
};

/// A firmware in Safe mode.
inline FirmwareBench safe(const sim::FirmwareOptions& options = {}) {
  FirmwareBench bench(oi::Model::Create2, options);
  bench.send({128, 131});
  return bench;
}

}  // namespace scrubjay::test
