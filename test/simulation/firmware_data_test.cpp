#include <gmock/gmock.h>

#include <array>
#include <numeric>

#include "wire.hpp"

namespace scrubjay::test {
namespace {

using oi::PacketId;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// Sum of all bytes, modulo 256.
int sum_of(const Bytes& bytes) {
  return std::accumulate(bytes.begin(), bytes.end(), 0) & 255;
}

TEST(FirmwareStreamTest, SendsAFrameEveryTick) {
  FirmwareBench bench = safe();
  EXPECT_THAT(bench.tick(), IsEmpty());
  bench.send({148, 1, 100});
  for (int i = 0; i < 100; ++i) {
    bench.senses.left_rolled = 0.01 * i;
    const Bytes frame = bench.tick();
    ASSERT_THAT(frame, SizeIs(84));
    EXPECT_EQ(frame[0], 19);
    EXPECT_EQ(frame[1], 81);
    EXPECT_EQ(frame[2], 100);
    EXPECT_EQ(sum_of(frame), 0);
  }
}

TEST(FirmwareStreamTest, SendsWhatWasAskedForInThatOrder) {
  FirmwareBench bench = safe();
  bench.senses.bump_left = true;
  bench.send({148, 3, 35, 7, 106});
  const Bytes frame = bench.tick();
  ASSERT_THAT(frame, SizeIs(2 + 2 + 2 + 13 + 1));
  EXPECT_THAT(Bytes(frame.begin(), frame.begin() + 7), ElementsAre(19, 17, 35, 2, 7, 2, 106));
  EXPECT_EQ(sum_of(frame), 0);
}

TEST(FirmwareStreamTest, PausesAndResumesTheSameList) {
  FirmwareBench bench = safe();
  bench.send({148, 2, 7, 8});
  EXPECT_THAT(bench.tick(), SizeIs(7));
  bench.send({150, 0});
  EXPECT_THAT(bench.tick(3), IsEmpty());
  bench.send({150, 1});
  EXPECT_THAT(bench.tick(), SizeIs(7));
}

TEST(FirmwareStreamTest, AnotherListTakesTheFirstOnesPlace) {
  FirmwareBench bench = safe();
  bench.send({148, 2, 7, 8, 148, 1, 9});
  EXPECT_THAT(bench.tick(), SizeIs(5));
  bench.send({148, 0});
  EXPECT_THAT(bench.tick(), IsEmpty());
  bench.send({150, 1});
  EXPECT_THAT(bench.tick(), IsEmpty()) << "there is nothing to resume";
}

TEST(FirmwareStreamTest, EndsWithTheInterface) {
  FirmwareBench bench = safe();
  bench.send({148, 1, 100, 173});
  EXPECT_THAT(bench.tick(), IsEmpty());
  bench.send({128});
  EXPECT_THAT(bench.tick(), IsEmpty());
}

/// Bytes of the packets 7 to 58, and of the groups, by the specification.
constexpr std::array<std::size_t, 52> kPacketBytes{1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 2, 2, 1, 2, 2, 1,
                                                   2, 2, 2, 2, 2, 2, 2, 1, 2, 1, 1, 1, 1, 1, 2, 2, 2, 2,
                                                   2, 2, 1, 2, 2, 2, 2, 2, 2, 1, 1, 2, 2, 2, 2, 1};
constexpr std::array<std::pair<int, std::size_t>, 11> kGroupBytes{
    {{0, 26}, {1, 10}, {2, 6}, {3, 10}, {4, 14}, {5, 12}, {6, 52}, {100, 80}, {101, 28}, {106, 12}, {107, 9}}};

TEST(FirmwareQueryTest, AnswersEveryPacketAndGroup) {
  FirmwareBench bench = safe();
  for (int id = 7; id <= 58; ++id) {
    EXPECT_THAT(bench.ask(id), SizeIs(kPacketBytes[static_cast<std::size_t>(id - 7)])) << id;
  }
  for (const auto& [id, bytes] : kGroupBytes) EXPECT_THAT(bench.ask(id), SizeIs(bytes)) << id;
  EXPECT_EQ(bench.firmware.rejected_commands(), 0u);
}

TEST(FirmwareQueryTest, RejectsWhatIsNoPacket) {
  FirmwareBench bench = safe();
  for (const int id : {59, 99, 102, 108, 255}) EXPECT_THAT(bench.ask(id), IsEmpty()) << id;
  EXPECT_EQ(bench.firmware.rejected_commands(), 5u);
}

TEST(FirmwareQueryTest, AGroupIsItsPacketsOneAfterAnother) {
  FirmwareBench bench = safe();
  bench.senses.light_signal = {1.0, 257.0, 3.0, 4000.0, 5.0, 6.0};
  bench.senses.battery.voltage = 15.0;
  for (const auto& [group, first, last] : {std::tuple{1, 7, 16}, {3, 21, 26}, {5, 35, 42}, {106, 46, 51}}) {
    Bytes packets;
    for (int id = first; id <= last; ++id) {
      const Bytes reply = bench.ask(id);
      packets.insert(packets.end(), reply.begin(), reply.end());
    }
    EXPECT_EQ(bench.ask(group), packets) << group;
  }
  EXPECT_THAT(bench.ask(106), ElementsAre(0, 1, 1, 1, 0, 3, 15, 160, 0, 5, 0, 6));
}

TEST(FirmwareQueryTest, AnswersAListInItsOrder) {
  FirmwareBench bench = safe();
  bench.senses.bump_right = true;
  bench.senses.light_signal[0] = 258.0;
  bench.send({149, 3, 46, 7, 35});
  EXPECT_THAT(bench.tick(), ElementsAre(1, 2, 1, 2));
}

TEST(FirmwareQueryTest, AnswersWithTheNextTickAndOnce) {
  FirmwareBench bench = safe();
  bench.send({142, 35, 142, 7});
  EXPECT_THAT(bench.tick(), ElementsAre(2, 0));
  EXPECT_THAT(bench.tick(), IsEmpty());
}

TEST(FirmwareQueryTest, TakesNoMoreQueriesATickThanTheLineCarries) {
  FirmwareBench bench = safe();
  for (int i = 0; i < 10'000; ++i) bench.send({142, 7});
  EXPECT_LE(bench.tick().size(), 172u / 2u) << "at 115200 baud 172 bytes arrive in 15 ms";
  EXPECT_GT(bench.firmware.rejected_commands(), 9'000u);
  EXPECT_THAT(bench.ask(7), SizeIs(1)) << "the next tick is a new one";
}

TEST(FirmwareSensesTest, PutsEachSenseInItsPlace) {
  FirmwareBench bench = safe();
  sim::BodySenses& s = bench.senses;
  s.bump_left = s.wheel_drop_right = true;
  s.wall = s.virtual_wall = true;
  s.cliff_flags = 0b1001;
  s.wheel_blocked = {true, false};
  s.dirt = 77;
  s.infrared_omni = 172;
  s.infrared_left = 168;
  s.infrared_right = 164;
  s.light_flags = 0b100001;
  s.light_signal = {-5.0, 30.4, 30.6, 5000.0, 0.0, 4095.0};
  s.wall_signal = 511.7;
  s.making_way = true;
  s.docked = true;
  s.battery = {15.25, 1.25, 2.0, 2.696, 25.0, true};
  EXPECT_EQ(bench.value(PacketId::BumpsAndWheelDrops), 0b0110);
  EXPECT_EQ(bench.value(PacketId::Wall), 1);
  EXPECT_EQ(bench.value(PacketId::VirtualWall), 1);
  EXPECT_EQ(bench.value(PacketId::CliffLeft), 1);
  EXPECT_EQ(bench.value(PacketId::CliffFrontLeft), 0);
  EXPECT_EQ(bench.value(PacketId::CliffFrontRight), 0);
  EXPECT_EQ(bench.value(PacketId::CliffRight), 1);
  EXPECT_LT(bench.value(PacketId::CliffLeftSignal), bench.value(PacketId::CliffFrontLeftSignal));
  EXPECT_EQ(bench.value(PacketId::WheelOvercurrents), 0b10000);
  EXPECT_EQ(bench.value(PacketId::DirtDetect), 77);
  EXPECT_EQ(bench.value(PacketId::InfraredCharacterOmni), 172);
  EXPECT_EQ(bench.value(PacketId::InfraredCharacterLeft), 168);
  EXPECT_EQ(bench.value(PacketId::InfraredCharacterRight), 164);
  EXPECT_EQ(bench.value(PacketId::LightBumper), 0b100001);
  EXPECT_EQ(bench.value(PacketId::LightBumpLeftSignal), 0) << "noise below zero";
  EXPECT_EQ(bench.value(PacketId::LightBumpFrontLeftSignal), 30);
  EXPECT_EQ(bench.value(PacketId::LightBumpCenterLeftSignal), 31);
  EXPECT_EQ(bench.value(PacketId::LightBumpCenterRightSignal), 4095) << "noise beyond the largest";
  EXPECT_EQ(bench.value(PacketId::LightBumpRightSignal), 4095);
  EXPECT_EQ(bench.value(PacketId::WallSignal), 512);
  EXPECT_EQ(bench.value(PacketId::Stasis), 1);
  EXPECT_EQ(bench.value(PacketId::ChargingState), 2);
  EXPECT_EQ(bench.value(PacketId::ChargingSourcesAvailable), 2);
  EXPECT_EQ(bench.value(PacketId::Voltage), 15250);
  EXPECT_EQ(bench.value(PacketId::Current), 1250);
  EXPECT_EQ(bench.value(PacketId::BatteryCharge), 2000);
  EXPECT_EQ(bench.value(PacketId::BatteryCapacity), 2696);
  EXPECT_EQ(bench.value(PacketId::Temperature), 25);
}

class FirmwareSongTest : public ::testing::Test {
 protected:
  FirmwareSongTest() {
    bench_.send({140, 0, 2, 60, 64, 0, 32});  // 1 s of a note, half a second of a rest
    bench_.send({140, 4, 1, 72, 16});
  }
  bool playing() { return bench_.value(PacketId::SongPlaying) == 1; }
  /// Ticks until it is silent.
  int ticks_playing() {
    int ticks = 0;
    while (playing()) ++ticks;
    return ticks;
  }

  FirmwareBench bench_ = safe();
};

TEST_F(FirmwareSongTest, PlaysForAsLongAsItsNotes) {
  EXPECT_FALSE(playing());
  bench_.send({141, 0});
  EXPECT_NEAR(ticks_playing(), 100, 1);
  EXPECT_EQ(bench_.value(PacketId::SongNumber), 0);
  bench_.send({141, 4});
  EXPECT_NEAR(ticks_playing(), 0.25 / 0.015, 1);
  EXPECT_EQ(bench_.value(PacketId::SongNumber), 4);
}

TEST_F(FirmwareSongTest, DoesNotInterruptOneForAnother) {
  bench_.send({141, 0});
  bench_.tick(50);
  bench_.send({141, 4});
  EXPECT_EQ(bench_.value(PacketId::SongNumber), 0);
  EXPECT_NEAR(ticks_playing(), 49, 1);
  EXPECT_FALSE(playing());
}

TEST_F(FirmwareSongTest, AnEmptySlotIsSilent) {
  bench_.send({141, 2});
  EXPECT_FALSE(playing());
}

TEST_F(FirmwareSongTest, RefusesSlotsThatItLacks) {
  bench_.send({140, 5, 1, 60, 64, 141, 5});
  EXPECT_EQ(bench_.firmware.rejected_commands(), 2u);
}

TEST(FirmwareIndicatorTest, ShowsLightsDigitsAndMotors) {
  FirmwareBench bench = safe();
  bench.send({139, 5, 100, 200, 138, 7});
  EXPECT_EQ(bench.firmware.indicators().leds, 5);
  EXPECT_EQ(bench.firmware.indicators().power_color, 100);
  EXPECT_EQ(bench.firmware.indicators().power_intensity, 200);
  EXPECT_EQ(bench.firmware.indicators().motors, 7);
  bench.send({163, 1, 2, 3, 4});
  EXPECT_THAT(bench.firmware.indicators().digits, ElementsAre(1, 2, 3, 4));
  bench.send({164, 'J', 'A', 'Y', '!'});
  EXPECT_THAT(bench.firmware.indicators().digits, ElementsAre('J', 'A', 'Y', '!'));
}

}  // namespace
}  // namespace scrubjay::test
