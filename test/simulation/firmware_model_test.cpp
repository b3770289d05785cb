#include <gmock/gmock.h>

#include "wire.hpp"

namespace scrubjay::test {
namespace {

using oi::PacketId;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

FirmwareBench awake(oi::Model protocol) {
  FirmwareBench bench(protocol);
  bench.send({128, 131});
  return bench;
}

TEST(Create1Test, SendsPacketsUpToFortyTwo) {
  FirmwareBench bench = awake(oi::Model::Create1);
  EXPECT_THAT(bench.ask(6), SizeIs(52));
  EXPECT_THAT(bench.ask(42), SizeIs(2));
  EXPECT_THAT(bench.ask(43), IsEmpty());
  EXPECT_THAT(bench.ask(100), IsEmpty());
  EXPECT_EQ(bench.firmware.rejected_commands(), 2u);
}

TEST(Create1Test, StreamsGroupSix) {
  FirmwareBench bench = awake(oi::Model::Create1);
  bench.send({148, 1, 6});
  EXPECT_THAT(bench.tick(), SizeIs(56));
}

TEST(Create1Test, SaysNoCharacterAs255) {
  FirmwareBench bench = awake(oi::Model::Create1);
  EXPECT_EQ(bench.value(PacketId::InfraredCharacterOmni), 255);
  bench.senses.infrared_omni = 162;
  EXPECT_EQ(bench.value(PacketId::InfraredCharacterOmni), 162);
}

TEST(Create1Test, ItsWallSignalGoesTo4095) {
  FirmwareBench bench = awake(oi::Model::Create1);
  bench.senses.wall_signal = 4000.0;
  EXPECT_EQ(bench.value(PacketId::WallSignal), 4000);
}

TEST(Create1Test, HasSixteenSongs) {
  FirmwareBench bench = awake(oi::Model::Create1);
  bench.send({140, 15, 1, 60, 64, 141, 15});
  EXPECT_EQ(bench.value(PacketId::SongPlaying), 1);
  EXPECT_EQ(bench.value(PacketId::SongNumber), 15);
}

TEST(Create1Test, KnowsDriveDirectButNotDrivePwm) {
  FirmwareBench bench = awake(oi::Model::Create1);
  bench.send({145, 0, 100, 0, 100});
  EXPECT_NEAR(bench.firmware.wanted().left, 0.1, 1e-12);
  bench.send({146, 0, 0, 0, 0});
  EXPECT_NEAR(bench.firmware.wanted().left, 0.1, 1e-12);
  EXPECT_EQ(bench.firmware.rejected_commands(), 1u);
}

TEST(Create1Test, ItsDemoTakesAByteWhereARoombaTakesNone) {
  FirmwareBench bench = awake(oi::Model::Create1);
  bench.send({136, 1});
  EXPECT_EQ(bench.firmware.mode(), oi::OiMode::Passive);
  EXPECT_EQ(bench.firmware.rejected_commands(), 0u);
}

TEST(Roomba400Test, SendsPacketsUpToTwentySix) {
  FirmwareBench bench = awake(oi::Model::Roomba400);
  EXPECT_THAT(bench.ask(0), SizeIs(26));
  EXPECT_THAT(bench.ask(26), SizeIs(2));
  EXPECT_THAT(bench.ask(27), IsEmpty());
  EXPECT_THAT(bench.ask(6), IsEmpty());
}

TEST(Roomba400Test, HasNoStream) {
  FirmwareBench bench = awake(oi::Model::Roomba400);
  bench.send({148, 1, 0});
  EXPECT_THAT(bench.tick(5), IsEmpty());
  EXPECT_EQ(bench.firmware.rejected_commands(), 1u);
}

TEST(Roomba400Test, TellsAnglesAsHalfTheWheelsDifference) {
  FirmwareBench bench = awake(oi::Model::Roomba400);
  bench.roll(-0.1001, 0.2001);
  EXPECT_EQ(bench.value(PacketId::Angle), 150);
  EXPECT_EQ(bench.value(PacketId::Distance), 50);
  int angle = 0;
  for (int i = 0; i < 1000; ++i) {
    bench.roll(0.0, 0.0005);
    angle += bench.value(PacketId::Angle);
  }
  EXPECT_NEAR(angle, 250, 1);
}

TEST(Roomba400Test, DrivesByRadiusAlone) {
  FirmwareBench bench = awake(oi::Model::Roomba400);
  bench.send({145, 0, 100, 0, 100});
  EXPECT_EQ(bench.firmware.wanted().left, 0.0);
  bench.send({137, 0, 100, 0x80, 0});
  EXPECT_NEAR(bench.firmware.wanted().left, 0.1, 1e-12);
}

TEST(Roomba400Test, SaysNoCharacterAs255) {
  FirmwareBench bench = awake(oi::Model::Roomba400);
  EXPECT_THAT(bench.ask(17), ElementsAre(255));
}

}  // namespace
}  // namespace scrubjay::test
