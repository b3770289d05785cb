#include "recording_format.hpp"

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <scrubjay/io/recording.hpp>

namespace scrubjay {

namespace {
constexpr double kNanosecondsPerSecond = 1e9;
}  // namespace

std::int64_t stamp_to_nanoseconds(double stamp) {
  // Below 2^53 ns (104 days) doubles are finer than nanoseconds, and there and back is exact.
  constexpr double kLimit = 9e18;
  return std::llround(std::clamp(stamp * kNanosecondsPerSecond, -kLimit, kLimit));
}

// Divided, not multiplied by 1e-9: the quotient is rounded once, so 15000000 ns are the very double 0.015.
double stamp_from_nanoseconds(std::int64_t nanoseconds) {
  return static_cast<double>(nanoseconds) / kNanosecondsPerSecond;
}

namespace recording {

std::size_t put_varint(std::uint8_t* out, std::uint64_t value) {
  std::size_t size = 0;
  for (; value >= 0x80; value >>= 7) out[size++] = static_cast<std::uint8_t>(value | 0x80);
  out[size++] = static_cast<std::uint8_t>(value);
  return size;
}

std::optional<std::uint64_t> take_varint(std::span<const std::uint8_t>& in) {
  std::uint64_t value = 0;
  for (unsigned shift = 0; shift < 64 && !in.empty(); shift += 7) {
    const std::uint64_t byte = in.front();
    in = in.subspan(1);
    if (shift == 63 && byte > 1) return std::nullopt;
    value |= (byte & 0x7f) << shift;
    if (byte < 0x80) return value;
  }
  return std::nullopt;
}

namespace {

/// The first place from `begin` on where the two differ; their length if there is none.
std::size_t first_difference(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b, std::size_t begin) {
  // Eight at a time: most of a frame is as before. Benchmark: RecordFrame.
  for (std::uint64_t x = 0, y = 0; begin + sizeof x <= a.size(); begin += sizeof x) {
    std::memcpy(&x, a.data() + begin, sizeof x);
    std::memcpy(&y, b.data() + begin, sizeof y);
    if (x != y) break;
  }
  while (begin < a.size() && a[begin] == b[begin]) ++begin;
  return begin;
}

}  // namespace

std::size_t make_delta(std::span<const std::uint8_t> chunk, std::span<const std::uint8_t> last, DeltaBuffer& out) {
  // A gap of equal bytes shorter than this costs less inside a change than the two numbers of another one.
  constexpr std::size_t kWorthwhileGap = 3;
  std::size_t size = put_varint(out.data(), chunk.size());
  std::size_t done = 0;
  while (true) {
    const std::size_t begin = first_difference(chunk, last, done);
    if (begin == chunk.size()) return size < chunk.size() ? size : 0;
    std::size_t end = begin + 1;
    for (std::size_t i = end; i < chunk.size() && i < end + kWorthwhileGap; ++i) {
      if (chunk[i] != last[i]) end = i + 1;
    }
    if (size + 2 + (end - begin) >= chunk.size()) return 0;
    size += put_varint(&out[size], begin - done);
    size += put_varint(&out[size], end - begin);
    for (std::size_t i = begin; i < end; ++i) out[size++] = chunk[i] ^ last[i];
    done = end;
  }
}

bool apply_delta(std::span<const std::uint8_t> delta, std::span<std::uint8_t> last) {
  while (!delta.empty()) {
    const auto skip = take_varint(delta);
    const auto change = take_varint(delta);
    if (!skip || !change || *skip > last.size() || *change > last.size() - *skip || *change > delta.size())
      return false;
    last = last.subspan(*skip);
    for (std::size_t i = 0; i < *change; ++i) last[i] ^= delta[i];
    last = last.subspan(*change);
    delta = delta.subspan(*change);
  }
  return true;
}

std::uint32_t checksum(std::uint32_t previous, std::span<const std::uint8_t> bytes) {
  return static_cast<std::uint32_t>(::crc32_z(previous, bytes.data(), bytes.size()));
}

}  // namespace recording
}  // namespace scrubjay
