#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <scrubjay/messages/cdr.hpp>

#include "messages/every_message.hpp"
#include "messages/random_message.hpp"

namespace scrubjay::ros {
namespace {

using testing::ElementsAreArray;

Bytes bytes_of(std::initializer_list<int> values) {
  Bytes bytes;
  for (const int value : values) bytes.push_back(static_cast<std::byte>(value));
  return bytes;
}

TEST(CdrTest, PutsEveryValueOnABoundaryOfItsSize) {
  // By hand after XCDR1: the boundaries are counted from behind the encapsulation.
  EXPECT_THAT(encode(Header{{1, 2}, "map"}), ElementsAreArray(bytes_of({0, 1, 0, 0,                    //
                                                                        1, 0, 0, 0, 2,   0,   0,   0,  //
                                                                        4, 0, 0, 0, 'm', 'a', 'p', 0})));
  const TwistStamped twist{{{0, 0}, "b"}, {{1.0, 0.0, 0.0}, {}}};
  const Bytes bytes = encode(twist);
  ASSERT_EQ(bytes.size(), 4u + 8 + 4 + 2 + 2 + 48);
  EXPECT_THAT(std::vector(bytes.begin() + 20, bytes.begin() + 28),
              ElementsAreArray(bytes_of({0, 0, 0, 0, 0, 0, 0xf0, 0x3f})));
}

TEST(CdrTest, GivesWhatHasNoFieldAnOctet) {
  EXPECT_THAT(encode(Empty{}), ElementsAreArray(bytes_of({0, 1, 0, 0, 0})));
  EXPECT_TRUE(decode<Empty>(encode(Empty{})));
}

TEST(CdrTest, LeavesNoBoundaryBeforeASequenceOfNothing) {
  // A length of 0, and then the next value: no room for doubles that aren't there.
  EXPECT_EQ(encode(JointState{}).size(), 4u + 8 + 4 + 1 + 3 + 4 * 4);
}

TEST(CdrTest, ReadsBigEndian) {
  const auto time = decode<Time>(bytes_of({0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 2}));
  ASSERT_TRUE(time);
  EXPECT_EQ(*time, (Time{1, 2}));
}

TEST(CdrTest, TakesEmptyStringsOfOtherVendorsThatHaveNoNul) {
  const auto text = decode<String>(bytes_of({0, 1, 0, 0, 0, 0, 0, 0}));
  ASSERT_TRUE(text);
  EXPECT_EQ(text->data, "");
}

TEST(CdrTest, RefusesStringsThatDontEnd) {
  EXPECT_FALSE(decode<String>(bytes_of({0, 1, 0, 0, 2, 0, 0, 0, 'a', 'b'})));
}

TEST(CdrTest, RefusesOtherEncapsulations) {
  EXPECT_FALSE(decode<Time>(bytes_of({0, 3, 0, 0, 0, 0, 0, 1, 0, 0, 0, 2})));  // a parameter list
  EXPECT_FALSE(decode<Time>(bytes_of({0, 7, 0, 0, 0, 0, 0, 1, 0, 0, 0, 2})));  // XCDR2
  EXPECT_FALSE(decode<Time>(bytes_of({1, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 2})));
  EXPECT_FALSE(decode<Time>(bytes_of({0, 1})));
  EXPECT_FALSE(decode<Time>({}));
}

TEST(CdrTest, RefusesBooleansThatAreNeither) {
  EXPECT_FALSE(decode<Bool>(bytes_of({0, 1, 0, 0, 2})));
}

TEST(CdrTest, RefusesLengthsThatTheBytesCantHave) {
  Bytes path = encode(Path{{{0, 0}, ""}, {}});
  for (std::size_t i = path.size() - 4; i < path.size(); ++i) path[i] = std::byte{0xff};
  EXPECT_FALSE(decode<Path>(path));
  // 2,000 bytes are no 2,000 poses: each has 68 at least.
  path[path.size() - 4] = std::byte{0xd0};
  path[path.size() - 3] = std::byte{0x07};
  path[path.size() - 2] = path[path.size() - 1] = std::byte{0};
  path.resize(path.size() + 2000);
  EXPECT_FALSE(decode<Path>(path));
}

TEST(CdrTest, IgnoresWhatFollowsTheMessage) {
  Bytes bytes = encode(UInt16{7});
  bytes.resize(bytes.size() + 2);
  EXPECT_EQ(decode<UInt16>(bytes), (UInt16{7}));
}

template <Message M>
class EveryMessageTest : public testing::Test {};
TYPED_TEST_SUITE(EveryMessageTest, EveryMessage::In<testing::Types>, MessageName);

TYPED_TEST(EveryMessageTest, ComesBackAsItWas) {
  Random random(1);
  for (int i = 0; i < 50; ++i) {
    const auto message = random_message<TypeParam>(random);
    const auto back = decode<TypeParam>(encode(message));
    ASSERT_TRUE(back);
    EXPECT_EQ(*back, message);
  }
}

TYPED_TEST(EveryMessageTest, IsRefusedWhereverItIsCut) {
  Random random(2);
  const Bytes bytes = encode(random_message<TypeParam>(random));
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    // But for an octet that says nothing.
    if constexpr (std::is_same_v<TypeParam, Empty>) {
      if (size + 1 == bytes.size()) continue;
    }
    EXPECT_FALSE(decode<TypeParam>(std::span(bytes).first(size))) << size << " of " << bytes.size() << " bytes";
  }
}

TYPED_TEST(EveryMessageTest, SurvivesAnyBytes) {
  Random random(3);
  for (int i = 0; i < 300; ++i) {
    Bytes bytes = encode(random_message<TypeParam>(random));
    for (int flips = 0; flips < 3; ++flips) {
      bytes[random.below(static_cast<std::uint32_t>(bytes.size()))] = static_cast<std::byte>(random.below(256));
    }
    const auto message = decode<TypeParam>(bytes);
    if (message) {
      EXPECT_LE(encode(*message).size(), bytes.size() + 64);
    }
  }
}

}  // namespace
}  // namespace scrubjay::ros
