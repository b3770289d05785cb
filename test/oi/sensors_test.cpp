#include <gtest/gtest.h>

#include <array>
#include <scrubjay/oi/sensors.hpp>
#include <vector>

#include "random_values.hpp"

namespace scrubjay::oi {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::int32_t decoded(PacketId id, const Bytes& bytes, Model model = Model::Create2) {
  Sensors sensors;
  EXPECT_TRUE(decode(id, bytes, model, sensors).ok);
  EXPECT_TRUE(sensors.has(id));
  return sensors[id];
}

TEST(SensorsTest, TwoBytesComeHighByteFirst) {
  EXPECT_EQ(decoded(PacketId::Voltage, {0x3A, 0x98}), 15000);
  EXPECT_EQ(decoded(PacketId::Voltage, {0xFF, 0xFE}), 65534);
  EXPECT_EQ(decoded(PacketId::Current, {0xFF, 0x38}), -200);
  EXPECT_EQ(decoded(PacketId::LeftEncoderCounts, {0x80, 0x00}), -32768);
  EXPECT_EQ(decoded(PacketId::Temperature, {0xFB}), -5);
  EXPECT_EQ(decoded(PacketId::DirtDetect, {0xFB}), 251);
}

TEST(SensorsTest, NothingIsKnownAtFirst) {
  const Sensors sensors;
  for (const PacketInfo& packet : kPackets) {
    EXPECT_FALSE(sensors.has(packet.id));
    EXPECT_EQ(sensors[packet.id], 0);
  }
}

TEST(SensorsTest, DecodesWhatWasEncodedOnEveryModelAndId) {
  Random random(3);
  for (const Model model : {Model::Create2, Model::Create1, Model::Roomba400}) {
    for (int number = 0; number < 256; ++number) {
      const auto id = SensorId::of(number, model);
      if (!id) continue;
      for (int run = 0; run < 200; ++run) {
        const Sensors sent = random_sensors(random, model);
        std::array<std::uint8_t, 80> bytes{};
        ASSERT_EQ(encode(*id, sent, model, bytes), id->bytes());
        Sensors received;
        ASSERT_EQ(decode(*id, std::span(bytes).first(id->bytes()), model, received), (DecodeStatus{.ok = true}));
        for (int n = kFirstPacket; n <= kLastPacket; ++n) {
          const auto packet = static_cast<PacketId>(n);
          const bool inside = n >= id->run().first && n <= id->run().last;
          ASSERT_EQ(received.has(packet), inside) << number << " " << n;
          ASSERT_EQ(received[packet], inside ? sent[packet] : 0) << number << " " << n;
        }
      }
    }
  }
}

/// The unrolled code of group 100 must do what the packets do one by one.
TEST(SensorsTest, GroupIsItsPacketsInARow) {
  Random random(4);
  for (int run = 0; run < 5000; ++run) {
    std::array<std::uint8_t, 80> bytes{};
    ASSERT_EQ(encode(100, random_sensors(random, Model::Create2), Model::Create2, bytes), 80U);
    // Some packets out of range.
    for (int spoilt = random.between(0, 3); spoilt > 0; --spoilt) {
      bytes[static_cast<std::size_t>(random.between(0, 79))] = static_cast<std::uint8_t>(random.next());
    }
    Sensors at_once = random_sensors(random, Model::Create2);
    Sensors one_by_one = at_once;
    int rejected = 0;
    std::size_t at = 0;
    for (const PacketInfo& packet : kPackets) {
      const DecodeStatus status =
          decode(packet.id, std::span(bytes).subspan(at, packet.bytes), Model::Create2, one_by_one);
      ASSERT_TRUE(status.ok);
      rejected += status.rejected;
      at += packet.bytes;
    }
    const DecodeStatus status = decode(100, bytes, Model::Create2, at_once);
    ASSERT_TRUE(status.ok);
    ASSERT_EQ(status.rejected, rejected);
    ASSERT_EQ(at_once, one_by_one);
  }
}

TEST(SensorsTest, ValuesOutOfRangeLeaveTheEarlierOnes) {
  struct Row {
    PacketId id;
    Bytes good;
    Bytes bad;
  };
  const Row rows[] = {{PacketId::BumpsAndWheelDrops, {15}, {16}},
                      {PacketId::Wall, {1}, {2}},
                      {PacketId::WallSignal, {0x03, 0xFF}, {0x04, 0x00}},
                      {PacketId::CliffLeftSignal, {0x0F, 0xFF}, {0x10, 0x00}},
                      {PacketId::RequestedVelocity, {0xFE, 0x0C}, {0xFE, 0x0B}},
                      {PacketId::OiMode, {4}, {5}},
                      {PacketId::LightBumper, {127}, {128}},
                      {PacketId::Stasis, {3}, {4}}};
  for (const Row& row : rows) {
    SCOPED_TRACE(packet_info(row.id).name);
    Sensors sensors;
    EXPECT_EQ(decode(row.id, row.bad, Model::Create2, sensors), (DecodeStatus{true, 1}));
    EXPECT_FALSE(sensors.has(row.id));
    EXPECT_EQ(decode(row.id, row.good, Model::Create2, sensors), (DecodeStatus{true, 0}));
    const Sensors before = sensors;
    EXPECT_EQ(decode(row.id, row.bad, Model::Create2, sensors), (DecodeStatus{true, 1}));
    EXPECT_EQ(sensors, before);
  }
}

TEST(SensorsTest, OneBadValueInAGroupCostsThatOneOnly) {
  Sensors sensors;
  sensors.set(PacketId::CliffLeft, 1);
  std::array<std::uint8_t, 80> bytes{};
  bytes[2] = 7;   // cliff left, 0 to 1
  bytes[3] = 1;   // cliff front left
  bytes[79] = 9;  // stasis, 0 to 3
  EXPECT_EQ(decode(100, bytes, Model::Create2, sensors), (DecodeStatus{true, 2}));
  EXPECT_EQ(sensors[PacketId::CliffLeft], 1);
  EXPECT_EQ(sensors[PacketId::CliffFrontLeft], 1);
  EXPECT_TRUE(sensors.has(PacketId::SideBrushMotorCurrent));
  EXPECT_FALSE(sensors.has(PacketId::Stasis));
}

TEST(SensorsTest, RangesAreTheModels) {
  EXPECT_EQ(decoded(PacketId::BumpsAndWheelDrops, {31}, Model::Create1), 31);
  EXPECT_EQ(decoded(PacketId::WallSignal, {0x0F, 0xFF}, Model::Create1), 4095);
}

TEST(SensorsTest, UnusedPacketsSayAnything) {
  EXPECT_EQ(decoded(PacketId::Unused1, {200}), 200);
  EXPECT_EQ(decoded(PacketId::Unused3, {0xFF, 0xFF}), 65535);
}

TEST(SensorsTest, WrongLengthOrModelStoresNothing) {
  Sensors sensors;
  const std::array<std::uint8_t, 81> bytes{};
  EXPECT_FALSE(decode(100, std::span(bytes).first(79), Model::Create2, sensors).ok);
  EXPECT_FALSE(decode(100, std::span(bytes).first(81), Model::Create2, sensors).ok);
  EXPECT_FALSE(decode(PacketId::Wall, std::span(bytes).first(0), Model::Create2, sensors).ok);
  EXPECT_FALSE(decode(100, std::span(bytes).first(80), Model::Create1, sensors).ok);
  EXPECT_FALSE(decode(6, std::span(bytes).first(52), Model::Roomba400, sensors).ok);
  EXPECT_EQ(sensors, Sensors{});
}

TEST(SensorsTest, EncodesNothingWhereItDoesntFit) {
  std::array<std::uint8_t, 80> bytes{};
  EXPECT_EQ(encode(100, Sensors{}, Model::Create2, std::span(bytes).first(79)), 0U);
  EXPECT_EQ(encode(100, Sensors{}, Model::Create1, bytes), 0U);
  EXPECT_EQ(encode(PacketId::Angle, Sensors{}, Model::Create2, std::span(bytes).first(1)), 0U);
}

TEST(SensorsTest, CountersWiderThanTheirPacketWrapAround) {
  Sensors sensors;
  sensors.set(PacketId::LeftEncoderCounts, 32768 + 5);
  std::array<std::uint8_t, 2> bytes{};
  ASSERT_EQ(encode(PacketId::LeftEncoderCounts, sensors, Model::Create2, bytes), 2U);
  EXPECT_EQ(decoded(PacketId::LeftEncoderCounts, {bytes[0], bytes[1]}), -32768 + 5);
}

TEST(SensorsTest, UpdateTakesOverWhatIsKnown) {
  Sensors sensors;
  sensors.set(PacketId::Wall, 1);
  sensors.set(PacketId::Angle, 5);
  Sensors newer;
  newer.set(PacketId::Angle, -7);
  newer.set(PacketId::Stasis, 0);
  sensors.update(newer);
  EXPECT_EQ(sensors[PacketId::Wall], 1);
  EXPECT_EQ(sensors[PacketId::Angle], -7);
  EXPECT_TRUE(sensors.has(PacketId::Stasis));
  EXPECT_FALSE(sensors.has(PacketId::Voltage));
}

}  // namespace
}  // namespace scrubjay::oi
