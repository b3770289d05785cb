#include <gtest/gtest.h>

#include <cstdint>
#include <scrubjay/geometry/random.hpp>
#include <scrubjay/odometry/encoder.hpp>

namespace scrubjay {
namespace {

constexpr int kAny = 32767;

TEST(EncoderTest, FirstReadingIsWhereCountingBegins) {
  Encoder encoder;
  EXPECT_EQ(encoder.advance(50000, kAny), 0);
  EXPECT_EQ(encoder.advance(50010, kAny), 10);
}

TEST(EncoderTest, CountsForwardsThroughItsEnd) {
  Encoder encoder;
  encoder.advance(65530, kAny);
  EXPECT_EQ(encoder.advance(65535, kAny), 5);
  EXPECT_EQ(encoder.advance(0, kAny), 1);
  EXPECT_EQ(encoder.advance(7, kAny), 7);
}

TEST(EncoderTest, CountsBackwardsThroughZero) {
  Encoder encoder;
  encoder.advance(3, kAny);
  EXPECT_EQ(encoder.advance(65533, kAny), -6);
  EXPECT_EQ(encoder.advance(65530, kAny), -3);
}

TEST(EncoderTest, CountsSignedReadingsThroughTheirEndsAndZero) {
  const auto raw = [](int reading) { return static_cast<std::uint16_t>(reading); };
  Encoder encoder;
  encoder.advance(raw(2), kAny);
  EXPECT_EQ(encoder.advance(raw(-3), kAny), -5);
  encoder.advance(raw(32760), kAny);
  EXPECT_EQ(encoder.advance(raw(-32768), kAny), 8);
  EXPECT_EQ(encoder.advance(raw(32767), kAny), -1);
}

TEST(EncoderTest, IgnoresAJumpThatNoWheelCanMakeAndCountsOnFromThere) {
  Encoder encoder;
  encoder.advance(20000, 100);
  EXPECT_EQ(encoder.advance(0, 100), 0);  // its power was cycled
  EXPECT_EQ(encoder.advance(40, 100), 40);
  EXPECT_EQ(encoder.advance(140, 100), 100);
  EXPECT_EQ(encoder.advance(241, 100), 0);
  EXPECT_EQ(encoder.advance(141, 100), -100);
  EXPECT_EQ(encoder.advance(40, 100), 0);
}

TEST(EncoderTest, AddsUpToTheWayRolledWhateverTheSteps) {
  Random random(1);
  Encoder encoder;
  std::int64_t truth = 12345;
  encoder.advance(static_cast<std::uint16_t>(truth), kAny);
  const std::int64_t start = truth;
  std::int64_t counted = 0;
  for (int i = 0; i < 100000; ++i) {
    truth += static_cast<int>(random.below(2001)) - (i < 50000 ? 900 : 1100);  // out for a while, then back
    counted += encoder.advance(static_cast<std::uint16_t>(truth), 2000);
    ASSERT_EQ(counted, truth - start);
  }
}

}  // namespace
}  // namespace scrubjay
