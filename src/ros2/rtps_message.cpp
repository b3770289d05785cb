#include "rtps_message.hpp"

#include <algorithm>
#include <array>

namespace scrubjay::ros {
namespace {

constexpr std::array<std::uint8_t, 4> kProtocol{'R', 'T', 'P', 'S'};
constexpr std::size_t kHeader = 20;
constexpr std::size_t kSubmessageHeader = 4;
constexpr std::size_t kBoundary = 4;
constexpr std::uint8_t kPad = 0x01;
constexpr std::uint8_t kTimestamp = 0x09;
constexpr std::uint8_t kFirstOfVendors = 0x80;
constexpr std::uint8_t kLittleEndian = 0x01;

}  // namespace

std::size_t length_of_standard_part(std::span<const std::uint8_t> message) {
  if (message.size() < kHeader || !std::equal(kProtocol.begin(), kProtocol.end(), message.begin())) return 0;
  std::size_t at = kHeader;
  while (at + kSubmessageHeader <= message.size()) {
    const std::uint8_t id = message[at];
    if (id >= kFirstOfVendors) break;
    const bool little = (message[at + 1] & kLittleEndian) != 0;
    const std::size_t low = message[at + (little ? 2 : 3)];
    const std::size_t high = message[at + (little ? 3 : 2)];
    const std::size_t length = high << 8 | low;
    // No length: all that is left, but for the two that may be empty.
    if (length == 0 && id != kPad && id != kTimestamp) return message.size();
    if (length > message.size() - at - kSubmessageHeader) break;
    at += kSubmessageHeader + length;
    // Only the last one may have such a length: readers don't agree on where the next one would be.
    if (length % kBoundary != 0) break;
  }
  return at;
}

}  // namespace scrubjay::ros
