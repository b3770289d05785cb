#include <gmock/gmock.h>

#include "wire.hpp"

namespace scrubjay::test {
namespace {

using oi::OiMode;
using ::testing::IsEmpty;
using ::testing::Not;

/// A little less than it takes to fall asleep, in ticks.
constexpr int kAlmostAsleep = static_cast<int>(sim::Firmware::kSleepAfter / 0.015) - 10;

FirmwareBench asleep() {
  sim::FirmwareOptions options;
  options.asleep = true;
  return FirmwareBench(oi::Model::Create2, options);
}

TEST(FirmwareSleepTest, IsSilentAndDeafUntilThePinIsPulsed) {
  FirmwareBench bench = asleep();
  bench.send({128, 131, 142, 35, 148, 1, 7, 137, 0, 100, 0x80, 0});
  EXPECT_THAT(bench.tick(5), IsEmpty());
  EXPECT_EQ(bench.firmware.mode(), OiMode::Off);
  EXPECT_EQ(bench.firmware.wanted().left, 0.0);
  bench.firmware.pulse_brc();
  EXPECT_FALSE(bench.firmware.asleep());
  EXPECT_EQ(bench.firmware.mode(), OiMode::Off) << "Start comes first";
  bench.send({131});
  EXPECT_EQ(bench.firmware.mode(), OiMode::Off);
  bench.send({128, 131});
  EXPECT_EQ(bench.firmware.mode(), OiMode::Safe);
}

TEST(FirmwareSleepTest, PowerPutsItToSleepWhateverItDid) {
  FirmwareBench bench = safe();
  bench.send({145, 0, 100, 0, 100, 148, 1, 7});
  EXPECT_THAT(bench.tick(), Not(IsEmpty()));
  bench.send({133, 128, 131});
  EXPECT_TRUE(bench.firmware.asleep());
  EXPECT_THAT(bench.tick(3), IsEmpty());
  EXPECT_EQ(bench.firmware.wanted().left, 0.0);
  bench.firmware.pulse_brc();
  EXPECT_THAT(bench.tick(3), IsEmpty()) << "the stream is over";
  bench.send({128});
  EXPECT_EQ(bench.value(oi::PacketId::OiMode), 1);
}

TEST(FirmwareSleepTest, FallsAsleepInPassiveModeWithoutACommand) {
  FirmwareBench bench;
  bench.send({128});
  bench.tick(kAlmostAsleep);
  EXPECT_FALSE(bench.firmware.asleep());
  bench.tick(20);
  EXPECT_TRUE(bench.firmware.asleep());
}

TEST(FirmwareSleepTest, ACommandOrAPulseKeepsItAwake) {
  for (const bool pulse : {false, true}) {
    FirmwareBench bench;
    bench.send({128});
    for (int i = 0; i < 3; ++i) {
      bench.tick(kAlmostAsleep);
      if (pulse) {
        bench.firmware.pulse_brc();
      } else {
        bench.send({142, 35});
      }
    }
    bench.tick(20);
    EXPECT_FALSE(bench.firmware.asleep());
    EXPECT_EQ(bench.firmware.mode(), OiMode::Passive) << "a pulse changes no mode of one that is awake";
  }
}

TEST(FirmwareSleepTest, StaysAwakeInSafeModeAndInItsDock) {
  FirmwareBench driven = safe();
  driven.tick(2 * kAlmostAsleep);
  EXPECT_FALSE(driven.firmware.asleep());
  FirmwareBench docked;
  docked.send({128});
  docked.senses.docked = true;
  docked.tick(2 * kAlmostAsleep);
  EXPECT_FALSE(docked.firmware.asleep());
}

TEST(FirmwareSleepTest, CountsSongsAndTellsWhichOneItPlays) {
  FirmwareBench bench = safe();
  bench.send({140, 2, 1, 60, 16, 141, 2});  // a quarter of a second
  EXPECT_EQ(bench.firmware.song(), 2);
  bench.send({141, 2});
  bench.tick(20);
  EXPECT_EQ(bench.firmware.song(), std::nullopt);
  EXPECT_EQ(bench.firmware.songs_played(), 1u) << "one that comes during another isn't played";
}

}  // namespace
}  // namespace scrubjay::test
