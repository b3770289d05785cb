#include <gmock/gmock.h>

#include <array>

#include "wire.hpp"

namespace scrubjay::test {
namespace {

using oi::OiMode;
using ::testing::IsEmpty;

constexpr std::uint8_t kStart = 128;
constexpr std::uint8_t kSafe = 131;
constexpr std::uint8_t kFull = 132;

/// A bench whose firmware was brought to that mode.
FirmwareBench in(OiMode mode, oi::Model protocol = oi::Model::Create2) {
  FirmwareBench bench(protocol);
  if (mode >= OiMode::Passive) bench.send({kStart});
  if (mode == OiMode::Safe) bench.send({kSafe});
  if (mode == OiMode::Full) bench.send({kFull});
  EXPECT_EQ(bench.firmware.mode(), mode);
  return bench;
}

/// An opcode of the Create 2, and the mode that it leads to from Passive, Safe and Full alike.
struct ModeRow {
  std::uint8_t opcode;
  OiMode after;
};

constexpr std::array<ModeRow, 11> kModeTable{{{7, OiMode::Off},
                                              {128, OiMode::Passive},
                                              {130, OiMode::Safe},
                                              {131, OiMode::Safe},
                                              {132, OiMode::Full},
                                              {133, OiMode::Passive},
                                              {134, OiMode::Passive},
                                              {135, OiMode::Passive},
                                              {136, OiMode::Passive},
                                              {143, OiMode::Passive},
                                              {173, OiMode::Off}}};

TEST(FirmwareModeTest, FollowsTheTableFromEveryMode) {
  for (const OiMode from : {OiMode::Passive, OiMode::Safe, OiMode::Full}) {
    for (const ModeRow& row : kModeTable) {
      FirmwareBench bench = in(from);
      bench.send({row.opcode});
      EXPECT_EQ(bench.firmware.mode(), row.after) << "opcode " << int{row.opcode} << " in mode " << int(from);
    }
  }
}

TEST(FirmwareModeTest, OffListensToStartAlone) {
  for (const ModeRow& row : kModeTable) {
    FirmwareBench bench = in(OiMode::Off);
    bench.send({row.opcode});
    EXPECT_EQ(bench.firmware.mode(), row.opcode == kStart ? OiMode::Passive : OiMode::Off) << int{row.opcode};
  }
  FirmwareBench bench = in(OiMode::Off);
  bench.send({142, 35, 149, 1, 7, 148, 1, 100, 137, 0, 100, 0, 100});
  EXPECT_THAT(bench.tick(3), IsEmpty());
  EXPECT_EQ(bench.firmware.wanted().left, 0.0);
  EXPECT_EQ(bench.firmware.rejected_commands(), 4u);
}

TEST(FirmwareModeTest, ReportsItsMode) {
  for (const OiMode mode : {OiMode::Passive, OiMode::Safe, OiMode::Full}) {
    FirmwareBench bench = in(mode);
    EXPECT_EQ(bench.value(oi::PacketId::OiMode), static_cast<int>(mode));
  }
}

TEST(FirmwareModeTest, PassiveIgnoresWhatMovesOrShows) {
  FirmwareBench bench = in(OiMode::Passive);
  bench.send({137, 0, 100, 0x80, 0});   // Drive
  bench.send({145, 0, 100, 0, 100});    // DriveDirect
  bench.send({146, 0, 100, 0, 100});    // DrivePwm
  bench.send({138, 7, 139, 15, 1, 2});  // Motors, Leds
  bench.send({164, 65, 66, 67, 68});    // DigitLedsAscii
  EXPECT_EQ(bench.firmware.wanted().left, 0.0);
  EXPECT_EQ(bench.firmware.wanted().right, 0.0);
  EXPECT_EQ(bench.firmware.indicators().motors, 0);
  EXPECT_EQ(bench.firmware.indicators().leds, 0);
  EXPECT_EQ(bench.firmware.indicators().digits[0], 0);
  EXPECT_EQ(bench.firmware.rejected_commands(), 6u);
}

TEST(FirmwareModeTest, StandsStillInTheDarkWhenControlChangesHands) {
  FirmwareBench bench = in(OiMode::Safe);
  bench.send({145, 0, 100, 0, 100, 139, 15, 1, 2});
  EXPECT_NEAR(bench.firmware.wanted().left, 0.1, 1e-12);
  EXPECT_EQ(bench.firmware.indicators().leds, 15);
  bench.send({kFull});
  EXPECT_EQ(bench.firmware.wanted().left, 0.0);
  EXPECT_EQ(bench.firmware.indicators().leds, 0);
}

TEST(FirmwareSafetyTest, SafeFallsToPassiveWhenAWheelDrops) {
  for (const bool left : {true, false}) {
    FirmwareBench bench = in(OiMode::Safe);
    (left ? bench.senses.wheel_drop_left : bench.senses.wheel_drop_right) = true;
    bench.tick();
    EXPECT_EQ(bench.firmware.mode(), OiMode::Passive);
  }
}

TEST(FirmwareSafetyTest, SafeFallsToPassiveOverACliffWhileItDrivesForward) {
  for (int sensor = 0; sensor < 4; ++sensor) {
    FirmwareBench bench = in(OiMode::Safe);
    bench.send({145, 0, 100, 0, 100});
    bench.senses.cliff_flags = static_cast<std::uint8_t>(1 << sensor);
    bench.tick();
    EXPECT_EQ(bench.firmware.mode(), OiMode::Passive) << sensor;
    EXPECT_EQ(bench.firmware.wanted().left, 0.0);
  }
}

TEST(FirmwareSafetyTest, SafeStaysOverACliffWhileItStandsSpinsOrBacksOff) {
  for (const auto& [right, left] : {std::pair<int, int>{0, 0}, {100, -100}, {-100, -100}}) {
    FirmwareBench bench = in(OiMode::Safe);
    bench.send(oi::DriveDirect{oi::Velocity::clamped(right), oi::Velocity::clamped(left)});
    bench.senses.cliff_flags = 2;
    bench.tick();
    EXPECT_EQ(bench.firmware.mode(), OiMode::Safe) << right << ", " << left;
  }
}

TEST(FirmwareSafetyTest, SafeFallsToPassiveInTheCharger) {
  FirmwareBench bench = in(OiMode::Safe);
  bench.senses.docked = true;
  bench.tick();
  EXPECT_EQ(bench.firmware.mode(), OiMode::Passive);
}

TEST(FirmwareSafetyTest, SafeMayBeTakenUpAgainWhenTheDangerIsOver) {
  FirmwareBench bench = in(OiMode::Safe);
  bench.senses.wheel_drop_left = true;
  bench.tick();
  bench.send({kSafe});
  bench.tick();
  EXPECT_EQ(bench.firmware.mode(), OiMode::Passive) << "the wheel hangs yet";
  bench.senses.wheel_drop_left = false;
  bench.send({kSafe});
  bench.tick();
  EXPECT_EQ(bench.firmware.mode(), OiMode::Safe);
}

TEST(FirmwareSafetyTest, FullHeedsNothing) {
  FirmwareBench bench = in(OiMode::Full);
  bench.send({145, 0, 100, 0, 100});
  bench.senses.wheel_drop_left = bench.senses.docked = true;
  bench.senses.cliff_flags = 15;
  bench.tick();
  EXPECT_EQ(bench.firmware.mode(), OiMode::Full);
  EXPECT_NEAR(bench.firmware.wanted().left, 0.1, 1e-12);
}

/// What Drive means for the wheels, for an axle of 235 mm.
struct DriveRow {
  int velocity;
  int radius;
  double left;
  double right;
};

TEST(FirmwareDriveTest, DriveTurnsTheWheelsByItsRadius) {
  constexpr std::array<DriveRow, 9> kRows{{{200, 32767, 0.2, 0.2},
                                           {200, -32768, 0.2, 0.2},
                                           {-200, 32767, -0.2, -0.2},
                                           {200, 1, -0.2, 0.2},
                                           {200, -1, 0.2, -0.2},
                                           {200, 235, 0.1, 0.3},
                                           {200, -235, 0.3, 0.1},
                                           {-200, 235, -0.1, -0.3},
                                           {200, 2000, 0.18825, 0.21175}}};
  for (const DriveRow& row : kRows) {
    FirmwareBench bench = in(OiMode::Safe);
    const auto high = [](int v) { return static_cast<std::uint8_t>(v >> 8 & 255); };
    const auto low = [](int v) { return static_cast<std::uint8_t>(v & 255); };
    bench.send({137, high(row.velocity), low(row.velocity), high(row.radius), low(row.radius)});
    EXPECT_NEAR(bench.firmware.wanted().left, row.left, 1e-12) << row.velocity << ", " << row.radius;
    EXPECT_NEAR(bench.firmware.wanted().right, row.right, 1e-12) << row.velocity << ", " << row.radius;
    EXPECT_EQ(bench.value(oi::PacketId::RequestedVelocity), row.velocity);
  }
}

TEST(FirmwareDriveTest, DriveOfAllZerosStops) {
  FirmwareBench bench = in(OiMode::Safe);
  bench.send({145, 0, 100, 0, 100});
  bench.send({137, 0, 0, 0, 0});
  EXPECT_EQ(bench.firmware.wanted().left, 0.0);
  EXPECT_EQ(bench.firmware.wanted().right, 0.0);
}

TEST(FirmwareDriveTest, ATightFastArcKeepsItsRadius) {
  FirmwareBench bench = in(OiMode::Safe);
  bench.send({137, 1, 244, 0, 100});  // 500 mm/s, 100 mm: the outer wheel would need 1.09 m/s
  const sim::WheelSpeeds& wanted = bench.firmware.wanted();
  EXPECT_NEAR(wanted.right, 0.5, 1e-12);
  EXPECT_NEAR(0.1175 * (wanted.right + wanted.left) / (wanted.right - wanted.left), 0.1, 1e-9);
}

TEST(FirmwareDriveTest, DriveDirectAndDrivePwmNameTheRightWheelFirst) {
  FirmwareBench bench = in(OiMode::Safe);
  bench.send({145, 0, 100, 0xFF, 0x38});  // right 100, left -200
  EXPECT_NEAR(bench.firmware.wanted().right, 0.1, 1e-12);
  EXPECT_NEAR(bench.firmware.wanted().left, -0.2, 1e-12);
  EXPECT_EQ(bench.value(oi::PacketId::RequestedRightVelocity), 100);
  EXPECT_EQ(bench.value(oi::PacketId::RequestedLeftVelocity), -200);
  bench.send({146, 0, 255, 0xFF, 0x81});  // right 255, left -127
  EXPECT_NEAR(bench.firmware.wanted().right, 0.5, 1e-12);
  EXPECT_NEAR(bench.firmware.wanted().left, -0.5 * 127 / 255, 1e-12);
}

TEST(FirmwareDriveTest, CommandsOutOfRangeAreRejectedWhole) {
  FirmwareBench bench = in(OiMode::Safe);
  bench.send({145, 0x7F, 0xFF, 0, 100});  // 32767 mm/s
  EXPECT_EQ(bench.firmware.wanted().left, 0.0);
  EXPECT_EQ(bench.firmware.rejected_commands(), 1u);
  bench.send({145, 0, 100, 0, 100});
  EXPECT_NEAR(bench.firmware.wanted().left, 0.1, 1e-12) << "the next command is found";
}

}  // namespace
}  // namespace scrubjay::test
