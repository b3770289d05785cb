#include <gmock/gmock.h>

#include <scrubjay/geometry/pose2.hpp>
#include <scrubjay/geometry/random.hpp>

#include "wire.hpp"

namespace scrubjay::test {
namespace {

using oi::PacketId;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr double kMetresPerCount = 0.000444564998;  ///< 72 mm wheels, 508.8 counts a turn
constexpr double kAxle = 0.235;

TEST(FirmwareEncoderTest, CountsOverTheWrapBothWays) {
  FirmwareBench bench = safe({.encoder_start = 65530});
  EXPECT_EQ(bench.value(PacketId::LeftEncoderCounts), -6);
  bench.roll(10.5 * kMetresPerCount, -10.5 * kMetresPerCount);
  EXPECT_EQ(bench.value(PacketId::LeftEncoderCounts), 4);
  EXPECT_EQ(bench.value(PacketId::RightEncoderCounts), -17);
  bench.roll(-21.0 * kMetresPerCount, 32768.0 * kMetresPerCount);
  EXPECT_EQ(bench.value(PacketId::LeftEncoderCounts), -17);
  EXPECT_EQ(bench.value(PacketId::RightEncoderCounts), 32751);
  EXPECT_THAT(bench.ask(43), ElementsAre(0xFF, 0xEF));
}

TEST(FirmwareEncoderTest, AWholeRoundOfTheCounterChangesNothing) {
  FirmwareBench bench = safe({.encoder_start = 100});
  bench.roll(0.5 * kMetresPerCount + 65536.0 * kMetresPerCount, -65535.5 * kMetresPerCount);
  EXPECT_EQ(bench.value(PacketId::LeftEncoderCounts), 100);
  EXPECT_EQ(bench.value(PacketId::RightEncoderCounts), 100);
}

TEST(FirmwareTravelTest, DistanceAndAngleAddUpOverAnyReads) {
  FirmwareBench bench = safe();
  Random random(11);
  int distance = 0;
  int angle = 0;
  for (int i = 0; i < 5000; ++i) {
    bench.roll(random.uniform(-0.002, 0.006), random.uniform(-0.003, 0.006));
    if (random.below(3) == 0) distance += bench.value(PacketId::Distance);
    if (random.below(3) == 0) angle += bench.value(PacketId::Angle);
    if (random.below(5) == 0) bench.tick();
  }
  distance += bench.value(PacketId::Distance);
  angle += bench.value(PacketId::Angle);
  const double left = bench.senses.left_rolled;
  const double right = bench.senses.right_rolled;
  EXPECT_GT(left, 5.0);
  EXPECT_NEAR(distance, 500.0 * (left + right), 1.0);
  EXPECT_NEAR(angle, degrees((right - left) / kAxle), 1.0);
}

TEST(FirmwareTravelTest, AStreamCountsAsReading) {
  FirmwareBench bench = safe();
  bench.roll(0.1, 0.1);
  EXPECT_EQ(bench.value(PacketId::Distance), 100);
  bench.roll(0.1, 0.1);
  bench.send({148, 1, 100});
  bench.tick();
  bench.send({150, 0});
  EXPECT_EQ(bench.value(PacketId::Distance), 0);
  bench.roll(0.1, 0.1);
  bench.ask(7);
  EXPECT_EQ(bench.value(PacketId::Distance), 100) << "other packets leave it alone";
}

TEST(FirmwareTravelTest, IsToldOnceATick) {
  FirmwareBench bench = safe();
  bench.roll(0.1, 0.1);
  bench.send({149, 2, 19, 19, 148, 1, 19});
  EXPECT_THAT(bench.tick(), ElementsAre(0, 100, 0, 0, 19, 3, 19, 0, 0, 256 - 19 - 3 - 19));
  bench.send({148, 0});
  EXPECT_EQ(bench.value(PacketId::Distance), 0);
}

TEST(FirmwareTravelTest, IsKeptWhenAStreamIsTooLongToBeSent) {
  FirmwareBench bench = safe();
  bench.roll(0.1, 0.1);
  bench.send({148, 4, 100, 100, 100, 100});
  EXPECT_THAT(bench.tick(), IsEmpty());
  bench.send({148, 0});
  EXPECT_EQ(bench.value(PacketId::Distance), 100);
}

TEST(FirmwareTravelTest, IsCappedWhereTheBytesEnd) {
  FirmwareBench bench = safe();
  bench.roll(40.0, 40.0);
  EXPECT_EQ(bench.value(PacketId::Distance), 32767);
  EXPECT_EQ(bench.value(PacketId::Distance), 0) << "what is beyond the cap is lost";
  bench.roll(-40.0, -40.0);
  EXPECT_EQ(bench.value(PacketId::Distance), -32768);
  bench.roll(-80.0, 80.0);
  EXPECT_EQ(bench.value(PacketId::Angle), 32767);
  EXPECT_EQ(bench.value(PacketId::Angle), 0);
}

TEST(FirmwareQuirkTest, OldFirmwareCountsAnglesInItsOwnUnit) {
  FirmwareBench bench = safe({.quirks = {.angle_divisor = 0.324056, .sign_from_command = false}});
  bench.roll(-0.5 * kAxle * kPi, 0.5 * kAxle * kPi);
  const int reported = bench.value(PacketId::Angle);
  EXPECT_EQ(reported, 58) << "180 degrees";
  EXPECT_NEAR(oi::corrected_angle(reported, {.angle_divisor = 0.324056}), 180.0, 1.0 / 0.324056);
}

TEST(FirmwareQuirkTest, OldFirmwareKnowsNeitherDistanceNorRadius) {
  FirmwareBench bench =
      safe({.quirks = {.distance_wrong = true, .requested_radius_wrong = true, .sign_from_command = false}});
  bench.send({137, 0, 100, 0, 200});
  bench.roll(1.0, 1.0);
  EXPECT_EQ(bench.value(PacketId::Distance), 0);
  EXPECT_EQ(bench.value(PacketId::RequestedRadius), 0);
  EXPECT_NE(bench.value(PacketId::LeftEncoderCounts), 0);
}

TEST(FirmwareQuirkTest, SomeReportTheModeOneTooHigh) {
  FirmwareBench bench = safe({.quirks = {.mode_one_too_high = true, .sign_from_command = false}});
  EXPECT_EQ(bench.value(PacketId::OiMode), 3);
  bench.send({132});
  EXPECT_EQ(bench.value(PacketId::OiMode), 4);
}

TEST(FirmwareQuirkTest, EncodersCountTheWayTheWheelsWereTold) {
  FirmwareBench bench = safe({.quirks = {.sign_from_command = true}});
  bench.send({145, 0, 100, 0xFF, 0x9C});                          // right 100, left -100
  bench.roll(100.5 * kMetresPerCount, -100.5 * kMetresPerCount);  // pushed the other way
  EXPECT_EQ(bench.value(PacketId::LeftEncoderCounts), -101);
  EXPECT_EQ(bench.value(PacketId::RightEncoderCounts), 100);
}

TEST(FirmwareQuirkTest, SomeHaveTheirEncodersSwapped) {
  FirmwareBench bench = safe({.quirks = {.sign_from_command = false, .swapped_encoders = true}});
  bench.roll(10.5 * kMetresPerCount, 20.5 * kMetresPerCount);
  EXPECT_EQ(bench.value(PacketId::LeftEncoderCounts), 20);
  EXPECT_EQ(bench.value(PacketId::RightEncoderCounts), 10);
}

}  // namespace
}  // namespace scrubjay::test
