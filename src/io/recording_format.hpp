/// \file
/// What writer and reader of recordings must agree on: docs/recordings.md.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <scrubjay/io/recording.hpp>
#include <span>

namespace scrubjay::recording {

/// A byte that isn't text, a name, and a line end that text-mode transfers would break; then the version.
inline constexpr std::array<std::uint8_t, 9> kFileHead{0x89, 'O', 'I', 'L', 'O', 'G', '\r', '\n', 1};
inline constexpr std::size_t kMagicSize = 8;

/// First byte of a record.
enum Kind : std::uint8_t { kScenario = 1, kReceived = 2, kReceivedDelta = 3, kSent = 4, kEnd = 5, kMissionEnd = 6 };

/// Unsigned LEB128: seven bits a byte, low ones first, the high bit set on all but the last.
inline constexpr std::size_t kMaxVarintSize = 10;
/// Writes one to where there is room for kMaxVarintSize bytes, and gives its size.
std::size_t put_varint(std::uint8_t* out, std::uint64_t value);
/// Reads one and steps over it; none if it doesn't end within `in` or within 64 bits.
std::optional<std::uint64_t> take_varint(std::span<const std::uint8_t>& in);

/// Signed numbers as unsigned ones, small for small magnitudes: 0, -1, 1, -2, ... are 0, 1, 2, 3, ...
constexpr std::uint64_t zigzag(std::int64_t value) {
  return (static_cast<std::uint64_t>(value) << 1) ^ (value < 0 ? ~std::uint64_t{0} : 0);
}
constexpr std::int64_t unzigzag(std::uint64_t value) {
  return static_cast<std::int64_t>((value >> 1) ^ ((value & 1) != 0 ? ~std::uint64_t{0} : 0));
}

/// Room for any difference that is shorter than its chunk, and the numbers that may turn out not to be worth it.
using DeltaBuffer = std::array<std::uint8_t, ChunkHistory::kMaxLength + 2 * kMaxVarintSize>;
/// How `chunk` differs from `last`, which is as long: length, then (bytes to skip, bytes to change, their XOR)...
/// Gives its size; 0 if it isn't shorter than the chunk itself.
std::size_t make_delta(std::span<const std::uint8_t> chunk, std::span<const std::uint8_t> last, DeltaBuffer& out);
/// Changes `last` by what make_delta wrote after the length; false if that doesn't fit.
bool apply_delta(std::span<const std::uint8_t> delta, std::span<std::uint8_t> last);

/// CRC-32 (ISO 3309, as in zlib) of `bytes`, going on from `previous`.
std::uint32_t checksum(std::uint32_t previous, std::span<const std::uint8_t> bytes);

}  // namespace scrubjay::recording
