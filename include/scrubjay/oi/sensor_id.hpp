/// \file
/// The number by which sensor data is asked for and sent: a packet or a group.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <scrubjay/oi/packet.hpp>

namespace scrubjay::oi {

/// The packets that a number on the wire stands for.
struct PacketRun {
  std::uint8_t first = 0;  ///< number of the first packet
  std::uint8_t last = 0;   ///< number of the last packet, included
  std::uint8_t bytes = 0;  ///< of all together; 0: there is no such number
};

namespace detail {

inline constexpr auto kRuns = [] {
  std::array<PacketRun, 256> runs{};
  for (const PacketInfo& packet : kPackets)
    runs[number(packet.id)] = {number(packet.id), number(packet.id), packet.bytes};
  for (const GroupInfo& group : kGroups) runs[group.id] = {number(group.first), number(group.last), group.bytes};
  return runs;
}();

void no_such_packet_or_group();  // never defined: a call of it in a constant expression is the error message

}  // namespace detail

/// A packet or a group that exists, on one model or another.
class SensorId {
 public:
  /// Packet 7.
  constexpr SensorId() = default;
  constexpr SensorId(PacketId id) : number_(oi::number(id)) {}
  /// From a literal; doesn't compile if there is no such packet or group.
  consteval SensorId(int literal) : number_(static_cast<std::uint8_t>(literal)) {
    if (!of(literal)) detail::no_such_packet_or_group();
  }
  /// None if there is no such packet or group on any model.
  static constexpr std::optional<SensorId> of(int number) {
    if (number < 0 || number > 255 || detail::kRuns[static_cast<std::size_t>(number)].bytes == 0) return {};
    return SensorId(static_cast<PacketId>(number));
  }
  /// None if the model lacks it.
  static constexpr std::optional<SensorId> of(int number, Model model) {
    const auto id = of(number);
    return id && id->exists_on(model) ? id : std::nullopt;
  }

  constexpr std::uint8_t number() const { return number_; }
  constexpr PacketRun run() const { return detail::kRuns[number_]; }
  constexpr std::size_t bytes() const { return run().bytes; }
  constexpr bool exists_on(Model model) const { return packet_info(PacketId{run().last}).exists_on(model); }
  auto operator<=>(const SensorId&) const = default;

 private:
  std::uint8_t number_ = kFirstPacket;
};

}  // namespace scrubjay::oi
