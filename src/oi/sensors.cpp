#include <bit>
#include <scrubjay/oi/sensors.hpp>
#include <utility>

namespace scrubjay::oi {
namespace {

constexpr std::int32_t value_of(const PacketInfo& info, const std::uint8_t* data) {
  if (info.bytes == 1) return info.is_signed ? static_cast<std::int8_t>(data[0]) : data[0];
  const auto bits = static_cast<std::uint16_t>(data[0] << 8 | data[1]);
  return info.is_signed ? static_cast<std::int16_t>(bits) : bits;
}

constexpr void put(const PacketInfo& info, std::int32_t value, std::uint8_t* out) {
  const auto bits = static_cast<std::uint32_t>(value);
  if (info.bytes == 2) *out++ = static_cast<std::uint8_t>(bits >> 8);
  *out = static_cast<std::uint8_t>(bits);
}

/// Any run of packets, one by one.
DecodeStatus decode_run(PacketRun run, const std::uint8_t* data, Model model, Sensors& sensors) {
  DecodeStatus status{.ok = true};
  for (std::uint8_t n = run.first; n <= run.last; ++n) {
    const PacketInfo& info = packet_info(PacketId{n});
    const std::int32_t value = value_of(info, data);
    data += info.bytes;
    if (accepted_range(info.id, model).contains(value)) {
      sensors.set(info.id, value);
    } else {
      ++status.rejected;
    }
  }
  return status;
}

void encode_run(PacketRun run, const Sensors& sensors, std::uint8_t* out) {
  for (std::uint8_t n = run.first; n <= run.last; ++n) {
    const PacketInfo& info = packet_info(PacketId{n});
    put(info, sensors.value[n], out);
    out += info.bytes;
  }
}

// Group 100 is what a robot streams every 15 ms and what a simulator decodes and encodes at 18,000 times that rate, so
// its runs are unrolled from the table at compile time (test/bench/oi_bench.cpp: DecodeGroup100, EncodeGroup100).

constexpr std::uint8_t kEverything = 100;
constexpr std::uint64_t kEverythingKnown = ((std::uint64_t{1} << kPacketCount) - 1) << kFirstPacket;

using Values = std::array<std::int32_t, kPacketCount>;

template <std::size_t I>
bool acceptable(const Values& values) {
  constexpr ValueRange kAccepted = accepted_range(kPackets[I].id, Model::Create2);
  if constexpr (kAccepted == kPackets[I].width()) return true;
  return kAccepted.contains(values[I]);
}

template <std::size_t... I>
DecodeStatus decode_everything(const std::uint8_t* data, Sensors& sensors, std::index_sequence<I...>) {
  const Values values{value_of(kPackets[I], data + detail::kOffsets[I])...};
  // All ranges at once, without a branch each: nearly always all are right.
  if ((1 & ... & static_cast<int>(acceptable<I>(values))) == 0) [[unlikely]] {
    return decode_run(SensorId(kEverything).run(), data, Model::Create2, sensors);
  }
  ((sensors.value[kFirstPacket + I] = values[I]), ...);
  sensors.known |= kEverythingKnown;
  return {.ok = true};
}

template <std::size_t... I>
void encode_everything(const Sensors& sensors, std::uint8_t* out, std::index_sequence<I...>) {
  (put(kPackets[I], sensors.value[kFirstPacket + I], out + detail::kOffsets[I]), ...);
}

}  // namespace

void Sensors::update(const Sensors& newer) {
  for (std::uint64_t left = newer.known; left != 0; left &= left - 1) {
    const auto n = static_cast<std::size_t>(std::countr_zero(left));
    value[n] = newer.value[n];
  }
  known |= newer.known;
}

DecodeStatus decode(SensorId id, std::span<const std::uint8_t> data, Model model, Sensors& sensors) {
  if (data.size() != id.bytes() || !id.exists_on(model)) return {};
  if (id.number() == kEverything) {
    return decode_everything(data.data(), sensors, std::make_index_sequence<kPacketCount>());
  }
  return decode_run(id.run(), data.data(), model, sensors);
}

std::size_t encode(SensorId id, const Sensors& sensors, Model model, std::span<std::uint8_t> out) {
  if (out.size() < id.bytes() || !id.exists_on(model)) return 0;
  if (id.number() == kEverything) {
    encode_everything(sensors, out.data(), std::make_index_sequence<kPacketCount>());
  } else {
    encode_run(id.run(), sensors, out.data());
  }
  return id.bytes();
}

}  // namespace scrubjay::oi
