#include "ros2/rtps_message.hpp"

#include <gmock/gmock.h>

#include <vector>

namespace scrubjay::ros {
namespace {

using Octets = std::vector<std::uint8_t>;

Octets header() {
  Octets message{'R', 'T', 'P', 'S', 2, 3, 1, 15};
  message.resize(20);
  return message;
}

/// `message` with a submessage behind it: little endian, with as many bytes as `length` says.
Octets operator+(Octets message, std::pair<std::uint8_t, std::uint8_t> id_and_length) {
  const auto [id, length] = id_and_length;
  message.insert(message.end(), {id, 0x01, length, 0});
  message.insert(message.end(), length, 0xab);
  return message;
}

constexpr std::uint8_t kPad = 0x01;
constexpr std::uint8_t kTimestamp = 0x09;
constexpr std::uint8_t kData = 0x15;
constexpr std::uint8_t kStatistics = 0x80;

using Submessage = std::pair<std::uint8_t, std::uint8_t>;

TEST(RtpsMessageTest, IsItselfWhereItIsStandard) {
  const Octets message = header() + Submessage{kTimestamp, 8} + Submessage{kData, 40} + Submessage{kData, 20};
  EXPECT_EQ(length_of_standard_part(message), message.size());
  EXPECT_EQ(length_of_standard_part(header()), 20U);
}

TEST(RtpsMessageTest, EndsBeforeAVendorsOwn) {
  const Octets message = header() + Submessage{kData, 40};
  EXPECT_EQ(length_of_standard_part(message + Submessage{kStatistics, 28}), message.size());
  EXPECT_EQ(length_of_standard_part(message + Submessage{kStatistics, 4} + Submessage{kData, 8}), message.size());
  EXPECT_EQ(length_of_standard_part(message + Submessage{0xff, 0}), message.size());
}

TEST(RtpsMessageTest, EndsBeforeWhatIsCut) {
  const Octets whole = header() + Submessage{kData, 8};
  Octets message = whole + Submessage{kData, 40};
  while (message.size() > whole.size()) {
    message.pop_back();
    EXPECT_EQ(length_of_standard_part(message), whole.size());
  }
}

TEST(RtpsMessageTest, WithoutALengthItIsTheLastButForTwo) {
  const Octets message = header() + Submessage{kData, 0} + Submessage{kStatistics, 4};
  EXPECT_EQ(length_of_standard_part(message), message.size());
  const Octets empty = header() + Submessage{kPad, 0} + Submessage{kTimestamp, 0};
  EXPECT_EQ(length_of_standard_part(empty + Submessage{kStatistics, 4}), empty.size());
}

TEST(RtpsMessageTest, EndsBehindAnOddLength) {
  const Octets message = header() + Submessage{kData, 7};
  EXPECT_EQ(length_of_standard_part(message + Submessage{kData, 8}), message.size());
}

TEST(RtpsMessageTest, LengthsAreInTheirOwnOrderOfBytes) {
  Octets message = header();
  message.insert(message.end(), {kData, 0x00, 0, 8});
  message.resize(message.size() + 8);
  EXPECT_EQ(length_of_standard_part(message), message.size());
}

TEST(RtpsMessageTest, OthersAreNone) {
  Octets other = header();
  other[0] = 'X';
  EXPECT_EQ(length_of_standard_part(other), 0U);
  EXPECT_EQ(length_of_standard_part({}), 0U);
  EXPECT_EQ(length_of_standard_part(Octets{'R', 'T', 'P', 'S'}), 0U);
}

}  // namespace
}  // namespace scrubjay::ros
