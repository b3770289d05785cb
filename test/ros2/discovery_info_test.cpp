#include "ros2/discovery_info.hpp"

#include <gmock/gmock.h>

#include <numeric>
#include <string>

namespace scrubjay::ros {
namespace {

/// 16 bytes that go up from `first`.
Guid guid(std::uint8_t first) {
  Guid guid;
  std::iota(guid.begin(), guid.end(), first);
  return guid;
}

std::string hexadecimal(const Bytes& bytes) {
  static constexpr const char* kDigits = "0123456789abcdef";
  std::string text;
  for (const std::byte byte : bytes) {
    text += kDigits[std::to_integer<unsigned>(byte) >> 4];
    text += kDigits[std::to_integer<unsigned>(byte) & 15];
  }
  return text;
}

const DiscoveryInfo kOne{.participant = guid(0x10),
                         .nodes = {{.space = "/r", .name = "jay", .readers = {guid(0x30)}, .writers = {}}}};

const std::string kHead = "00010000";
const std::string kParticipant = "101112131415161718191a1b1c1d1e1f";
const std::string kReader = "303132333435363738393a3b3c3d3e3f";
const std::string kNames =
    "01000000"
    "03000000"
    "2f7200"
    "00"  // the next length is on a boundary of four
    "04000000"
    "6a617900";
const std::string kEightMore = "0000000000000000";

TEST(DiscoveryInfoTest, HasIdentifiersOfSixteenBytesSinceIron) {
  EXPECT_EQ(hexadecimal(encode_discovery_info(kOne, 16)),
            kHead + kParticipant + kNames + "01000000" + kReader + "00000000");
}

TEST(DiscoveryInfoTest, HasIdentifiersOfTwentyFourBytesInHumble) {
  EXPECT_EQ(hexadecimal(encode_discovery_info(kOne, 24)),
            kHead + kParticipant + kEightMore + kNames + "01000000" + kReader + kEightMore + "00000000");
}

TEST(DiscoveryInfoTest, HumbleAloneHasLongOnes) {
  EXPECT_EQ(gid_size(Distribution::Humble), 24U);
  for (const auto other : {Distribution::Iron, Distribution::Jazzy, Distribution::Kilted, Distribution::Rolling}) {
    EXPECT_EQ(gid_size(other), 16U) << name_of(other);
  }
}

TEST(DiscoveryInfoTest, IsWhatItWasEncodedFrom) {
  const DiscoveryInfo two{guid(1),
                          {{"/", "one", {guid(2), guid(3)}, {guid(4)}}, {"/robot1", "two", {}, {guid(5), guid(6)}}}};
  for (const DiscoveryInfo& info : {DiscoveryInfo{guid(9), {}}, kOne, two}) {
    for (const std::size_t size : {16U, 24U}) {
      EXPECT_EQ(decode_discovery_info(encode_discovery_info(info, size), size), info);
    }
  }
}

TEST(DiscoveryInfoTest, IsNoneInIdentifiersOfTheOtherSize) {
  const DiscoveryInfo many{guid(1), {{"/", "one", {guid(2), guid(3)}, {guid(4)}}, {"/robot1", "two", {}, {}}}};
  for (const DiscoveryInfo& info : {DiscoveryInfo{guid(9), {}}, kOne, many}) {
    EXPECT_FALSE(decode_discovery_info(encode_discovery_info(info, 16), 24));
    EXPECT_FALSE(decode_discovery_info(encode_discovery_info(info, 24), 16));
  }
}

TEST(DiscoveryInfoTest, MayBePaddedByTheWireAndNoMore) {
  Bytes bytes = encode_discovery_info(kOne, 16);
  for (int padding = 1; padding <= 3; ++padding) {
    bytes.push_back(std::byte{0});
    EXPECT_EQ(decode_discovery_info(bytes, 16), kOne);
  }
  bytes.push_back(std::byte{0});
  EXPECT_FALSE(decode_discovery_info(bytes, 16));
}

TEST(DiscoveryInfoTest, CutAnywhereIsNone) {
  for (const std::size_t size : {16U, 24U}) {
    const Bytes whole = encode_discovery_info(kOne, size);
    for (std::size_t length = 0; length < whole.size(); ++length) {
      EXPECT_FALSE(decode_discovery_info(std::span(whole).first(length), size)) << length;
    }
  }
}

}  // namespace
}  // namespace scrubjay::ros
