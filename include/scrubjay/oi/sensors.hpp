/// \file
/// Decoded sensor values, and their bytes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <scrubjay/oi/model.hpp>
#include <scrubjay/oi/packet.hpp>
#include <scrubjay/oi/sensor_id.hpp>
#include <span>

namespace scrubjay::oi {

/// What a robot said of itself so far, in the units of the table of packets.
struct Sensors {
  std::array<std::int32_t, kLastPacket + 1> value{};  ///< by packet number; 0 while not known
  std::uint64_t known = 0;                            ///< bit i: packet i was ever decoded or set

  constexpr std::int32_t operator[](PacketId id) const { return value[number(id)]; }
  constexpr bool has(PacketId id) const { return (known >> number(id) & 1) != 0; }
  constexpr void set(PacketId id, std::int32_t v) {
    value[number(id)] = v;
    known |= std::uint64_t{1} << number(id);
  }
  /// Takes over all that `newer` knows.
  void update(const Sensors& newer);
  bool operator==(const Sensors&) const = default;
};

struct DecodeStatus {
  bool ok = false;             ///< false: not the right number of bytes, or no such packet on the model; nothing stored
  std::uint16_t rejected = 0;  ///< values out of the packet's accepted range, which left the earlier ones in place
  bool operator==(const DecodeStatus&) const = default;
};

/// Reads the bytes of one packet or group.
[[nodiscard]] DecodeStatus decode(SensorId id, std::span<const std::uint8_t> data, Model model, Sensors& sensors);

/// Writes one packet or group to the front of `out`, and says how many bytes that took; 0 if it doesn't fit or the
/// model lacks it. Of a value too wide for its packet the low bits are sent, as counters do that wrap around.
[[nodiscard]] std::size_t encode(SensorId id, const Sensors& sensors, Model model, std::span<std::uint8_t> out);

}  // namespace scrubjay::oi
