#include <gmock/gmock.h>

#include <scrubjay/oi/quirks.hpp>
#include <string>

#include "wire.hpp"

namespace scrubjay::test {
namespace {

using oi::PacketId;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

constexpr int kBootTicks = 334;  // 5 s and the tick that they end in

/// All that so many ticks bring, as text.
std::string text_of(FirmwareBench& bench, int ticks) {
  std::string text;
  for (int i = 0; i < ticks; ++i) {
    const Bytes bytes = bench.tick();
    text.append(bytes.begin(), bytes.end());
  }
  return text;
}

TEST(FirmwareResetTest, SaysWhatItBootsAtOnceAndItsReleaseWhenItIsReady) {
  FirmwareBench bench = safe({.release = {3, 4, 7}});
  bench.send({7});
  const std::string first = text_of(bench, 1);
  EXPECT_THAT(first, HasSubstr("bl-start\r\n"));
  EXPECT_THAT(first, Not(HasSubstr("release")));
  EXPECT_EQ(oi::parse_release(text_of(bench, kBootTicks)), (oi::Release{3, 4, 7}));
  EXPECT_THAT(text_of(bench, 100), IsEmpty()) << "it boots but once";
}

TEST(FirmwareResetTest, IsDeafUntilItHasBooted) {
  FirmwareBench bench = safe();
  bench.send({7, 128, 131});
  bench.tick(kBootTicks / 2);
  bench.send({128});
  EXPECT_EQ(bench.firmware.mode(), oi::OiMode::Off);
  EXPECT_EQ(bench.firmware.rejected_commands(), 3u);
  bench.tick(kBootTicks / 2);
  bench.send({128});
  EXPECT_EQ(bench.firmware.mode(), oi::OiMode::Passive);
}

TEST(FirmwareResetTest, StopsAndForgetsSongsStreamAndTravel) {
  FirmwareBench bench = safe();
  bench.send({140, 0, 1, 60, 64, 141, 0, 145, 0, 100, 0, 100, 139, 15, 1, 2, 148, 1, 7, 149, 1, 7});
  bench.roll(0.5, 0.6);
  bench.tick();
  bench.send({7});
  EXPECT_EQ(bench.firmware.wanted().left, 0.0);
  EXPECT_EQ(bench.firmware.indicators().leds, 0);
  bench.tick(kBootTicks);
  bench.send({128, 131, 141, 0});
  EXPECT_THAT(bench.tick(), IsEmpty()) << "neither stream nor reply";
  EXPECT_EQ(bench.value(PacketId::SongPlaying), 0);
  EXPECT_EQ(bench.value(PacketId::Distance), 0);
  EXPECT_EQ(bench.value(PacketId::LeftEncoderCounts), 0);
  bench.roll(0.1001, 0.1001);
  EXPECT_EQ(bench.value(PacketId::Distance), 100);
}

TEST(FirmwareResetTest, WorksInOffModeToo) {
  FirmwareBench bench;
  bench.send({7});
  EXPECT_THAT(bench.tick(), SizeIs(::testing::Gt(20u)));
}

TEST(FirmwareButtonTest, PressesForASixthOfASecond) {
  FirmwareBench bench = safe();
  bench.send({165, 0b0101});
  for (int tick = 1; tick <= 11; ++tick) EXPECT_EQ(bench.value(PacketId::Buttons), 0b0101) << tick;
  bench.tick();
  EXPECT_EQ(bench.value(PacketId::Buttons), 0);
  EXPECT_EQ(bench.firmware.mode(), oi::OiMode::Safe);
}

TEST(FirmwareButtonTest, NeverReportsScheduleAndClock) {
  FirmwareBench bench = safe();
  bench.send({165, 0xFF});
  EXPECT_EQ(bench.value(PacketId::Buttons), 0x3F);
}

TEST(FirmwareIndicatorTest, PwmMotorsTurnTheMotorsThatMotorsTurns) {
  FirmwareBench bench = safe();
  bench.send({144, 127, 1, 60});
  EXPECT_EQ(bench.firmware.indicators().motors, 0b00111);
  bench.send({144, 0x81, 0xFF, 0});
  EXPECT_EQ(bench.firmware.indicators().motors, 0b11101);
  bench.send({144, 0, 0, 0});
  EXPECT_EQ(bench.firmware.indicators().motors, 0);
}

}  // namespace
}  // namespace scrubjay::test
