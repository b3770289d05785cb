#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <scrubjay/oi/packet.hpp>
#include <scrubjay/oi/sensor_id.hpp>
#include <string>

#include "csv.hpp"

namespace scrubjay::oi {
namespace {

struct PacketRow {
  int id;
  std::string name;
  int bytes;
  bool is_signed;
  int min;
  int max;
  std::string units;
  std::string models;
};

/// The specification, for Create 2 (the ranges of the others follow in their own tests).
const PacketRow kPacketRows[] = {
    {7, "bumps_and_wheel_drops", 1, false, 0, 15, "bits", "C2 C1 R4"},
    {8, "wall", 1, false, 0, 1, "bool", "C2 C1 R4"},
    {9, "cliff_left", 1, false, 0, 1, "bool", "C2 C1 R4"},
    {10, "cliff_front_left", 1, false, 0, 1, "bool", "C2 C1 R4"},
    {11, "cliff_front_right", 1, false, 0, 1, "bool", "C2 C1 R4"},
    {12, "cliff_right", 1, false, 0, 1, "bool", "C2 C1 R4"},
    {13, "virtual_wall", 1, false, 0, 1, "bool", "C2 C1 R4"},
    {14, "wheel_overcurrents", 1, false, 0, 31, "bits", "C2 C1 R4"},
    {15, "dirt_detect", 1, false, 0, 255, "level", "C2 C1 R4"},
    {16, "unused_1", 1, false, 0, 0, "", "C2 C1 R4"},
    {17, "infrared_character_omni", 1, false, 0, 255, "char", "C2 C1 R4"},
    {18, "buttons", 1, false, 0, 255, "bits", "C2 C1 R4"},
    {19, "distance", 2, true, -32768, 32767, "mm", "C2 C1 R4"},
    {20, "angle", 2, true, -32768, 32767, "deg", "C2 C1 R4"},
    {21, "charging_state", 1, false, 0, 5, "enum", "C2 C1 R4"},
    {22, "voltage", 2, false, 0, 65535, "mV", "C2 C1 R4"},
    {23, "current", 2, true, -32768, 32767, "mA", "C2 C1 R4"},
    {24, "temperature", 1, true, -128, 127, "degC", "C2 C1 R4"},
    {25, "battery_charge", 2, false, 0, 65535, "mAh", "C2 C1 R4"},
    {26, "battery_capacity", 2, false, 0, 65535, "mAh", "C2 C1 R4"},
    {27, "wall_signal", 2, false, 0, 1023, "raw", "C2 C1"},
    {28, "cliff_left_signal", 2, false, 0, 4095, "raw", "C2 C1"},
    {29, "cliff_front_left_signal", 2, false, 0, 4095, "raw", "C2 C1"},
    {30, "cliff_front_right_signal", 2, false, 0, 4095, "raw", "C2 C1"},
    {31, "cliff_right_signal", 2, false, 0, 4095, "raw", "C2 C1"},
    {32, "unused_2", 1, false, 0, 255, "", "C2 C1"},
    {33, "unused_3", 2, false, 0, 65535, "", "C2 C1"},
    {34, "charging_sources_available", 1, false, 0, 3, "bits", "C2 C1"},
    {35, "oi_mode", 1, false, 0, 3, "enum", "C2 C1"},
    {36, "song_number", 1, false, 0, 15, "", "C2 C1"},
    {37, "song_playing", 1, false, 0, 1, "bool", "C2 C1"},
    {38, "number_of_stream_packets", 1, false, 0, 108, "", "C2 C1"},
    {39, "requested_velocity", 2, true, -500, 500, "mm/s", "C2 C1"},
    {40, "requested_radius", 2, true, -32768, 32767, "mm", "C2 C1"},
    {41, "requested_right_velocity", 2, true, -500, 500, "mm/s", "C2 C1"},
    {42, "requested_left_velocity", 2, true, -500, 500, "mm/s", "C2 C1"},
    {43, "left_encoder_counts", 2, true, -32768, 32767, "counts", "C2"},
    {44, "right_encoder_counts", 2, true, -32768, 32767, "counts", "C2"},
    {45, "light_bumper", 1, false, 0, 127, "bits", "C2"},
    {46, "light_bump_left_signal", 2, false, 0, 4095, "raw", "C2"},
    {47, "light_bump_front_left_signal", 2, false, 0, 4095, "raw", "C2"},
    {48, "light_bump_center_left_signal", 2, false, 0, 4095, "raw", "C2"},
    {49, "light_bump_center_right_signal", 2, false, 0, 4095, "raw", "C2"},
    {50, "light_bump_front_right_signal", 2, false, 0, 4095, "raw", "C2"},
    {51, "light_bump_right_signal", 2, false, 0, 4095, "raw", "C2"},
    {52, "infrared_character_left", 1, false, 0, 255, "char", "C2"},
    {53, "infrared_character_right", 1, false, 0, 255, "char", "C2"},
    {54, "left_motor_current", 2, true, -32768, 32767, "mA", "C2"},
    {55, "right_motor_current", 2, true, -32768, 32767, "mA", "C2"},
    {56, "main_brush_motor_current", 2, true, -32768, 32767, "mA", "C2"},
    {57, "side_brush_motor_current", 2, true, -32768, 32767, "mA", "C2"},
    {58, "stasis", 1, false, 0, 3, "bits", "C2"},
};

/// Models as the table of facts writes them.
std::string models_of(const PacketInfo& info) {
  std::string models;
  for (const auto& [model, name] :
       {std::pair{Model::Create2, "C2"}, std::pair{Model::Create1, "C1"}, std::pair{Model::Roomba400, "R4"}}) {
    if (info.exists_on(model)) models.append(models.empty() ? "" : " ").append(name);
  }
  return models;
}

void expect_is(const PacketInfo& info, const PacketRow& row) {
  SCOPED_TRACE(row.name);
  EXPECT_EQ(number(info.id), row.id);
  EXPECT_EQ(info.name, row.name);
  EXPECT_EQ(info.bytes, row.bytes);
  EXPECT_EQ(info.is_signed, row.is_signed);
  EXPECT_EQ(info.range(Model::Create2), (ValueRange{row.min, row.max}));
  EXPECT_EQ(info.units, row.units);
  EXPECT_EQ(models_of(info), row.models);
}

TEST(PacketTest, TableIsTheSpecification) {
  ASSERT_EQ(std::size(kPacketRows), kPackets.size());
  for (std::size_t i = 0; i < kPackets.size(); ++i) expect_is(kPackets[i], kPacketRows[i]);
}

TEST(PacketTest, TableIsTheSharedFacts) {
  const auto rows = csv_rows("packets.csv");
  if (rows.empty()) GTEST_SKIP() << "packets.csv is not here";
  ASSERT_EQ(rows.size(), kPackets.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    auto row = rows[i];
    expect_is(kPackets[i], {std::stoi(row["id"]), row["name"], std::stoi(row["bytes"]), row["signed"] == "s",
                            std::stoi(row["min"]), std::stoi(row["max"]), row["units"], row["models"]});
    std::string groups;
    for (const GroupInfo& group : kGroups) {
      if (number(group.first) > number(kPackets[i].id) || number(group.last) < number(kPackets[i].id)) continue;
      groups.append(groups.empty() ? "" : " ").append(std::to_string(group.id));
    }
    EXPECT_EQ(groups, row["groups"]) << row["name"];
  }
}

TEST(PacketTest, EnumeratorsAreTheNumbersOfTheSpecification) {
  EXPECT_EQ(number(PacketId::BumpsAndWheelDrops), 7);
  EXPECT_EQ(number(PacketId::InfraredCharacterOmni), 17);
  EXPECT_EQ(number(PacketId::Angle), 20);
  EXPECT_EQ(number(PacketId::BatteryCapacity), 26);
  EXPECT_EQ(number(PacketId::OiMode), 35);
  EXPECT_EQ(number(PacketId::LeftEncoderCounts), 43);
  EXPECT_EQ(number(PacketId::LightBumper), 45);
  EXPECT_EQ(number(PacketId::LightBumpRightSignal), 51);
  EXPECT_EQ(number(PacketId::Stasis), 58);
}

TEST(PacketTest, RangesThatDifferByModel) {
  struct Row {
    PacketId id;
    Model model;
    ValueRange range;
  };
  const Row rows[] = {
      {PacketId::BumpsAndWheelDrops, Model::Create2, {0, 15}},
      {PacketId::BumpsAndWheelDrops, Model::Create1, {0, 31}},
      {PacketId::BumpsAndWheelDrops, Model::Roomba400, {0, 31}},
      {PacketId::WallSignal, Model::Create2, {0, 1023}},
      {PacketId::WallSignal, Model::Create1, {0, 4095}},
      {PacketId::NumberOfStreamPackets, Model::Create2, {0, 108}},
      {PacketId::NumberOfStreamPackets, Model::Create1, {0, 43}},
      {PacketId::Unused1, Model::Roomba400, {0, 255}},
      {PacketId::Unused2, Model::Create1, {0, 31}},
      {PacketId::Unused3, Model::Create1, {0, 1023}},
  };
  for (const Row& row : rows) EXPECT_EQ(packet_info(row.id).range(row.model), row.range) << packet_info(row.id).name;
}

TEST(PacketTest, UnusedPacketsAcceptAllTheirBytesCanSay) {
  EXPECT_EQ(accepted_range(PacketId::Unused1, Model::Create2), (ValueRange{0, 255}));
  EXPECT_EQ(accepted_range(PacketId::Unused2, Model::Create2), (ValueRange{0, 255}));
  EXPECT_EQ(accepted_range(PacketId::Unused3, Model::Create2), (ValueRange{0, 65535}));
  EXPECT_EQ(accepted_range(PacketId::Unused3, Model::Create1), (ValueRange{0, 1023}));
}

TEST(PacketTest, ModeOneTooHighIsAccepted) {
  EXPECT_TRUE(accepted_range(PacketId::OiMode, Model::Create2).contains(4));
  EXPECT_FALSE(accepted_range(PacketId::OiMode, Model::Create2).contains(5));
  EXPECT_FALSE(accepted_range(PacketId::OiMode, Model::Create1).contains(4));
}

const std::array<std::array<int, 5>, 11> kGroupRows{{
    {0, 26, 7, 26, 30},
    {1, 10, 7, 16, 14},
    {2, 6, 17, 20, 10},
    {3, 10, 21, 26, 14},
    {4, 14, 27, 34, 18},
    {5, 12, 35, 42, 16},
    {6, 52, 7, 42, 56},
    {100, 80, 7, 58, 84},
    {101, 28, 43, 58, 32},
    {106, 12, 46, 51, 16},
    {107, 9, 54, 58, 13},
}};

void expect_group(const std::array<int, 5>& row) {
  SCOPED_TRACE(row[0]);
  const GroupInfo* group = group_info(static_cast<std::uint8_t>(row[0]));
  ASSERT_NE(group, nullptr);
  EXPECT_EQ(group->bytes, row[1]);
  EXPECT_EQ(number(group->first), row[2]);
  EXPECT_EQ(number(group->last), row[3]);
  EXPECT_EQ(group->stream_frame_bytes, row[4]);
}

TEST(PacketTest, GroupsAreTheSpecification) {
  EXPECT_EQ(kGroups.size(), kGroupRows.size());
  for (const auto& row : kGroupRows) expect_group(row);
}

TEST(PacketTest, GroupsAreTheSharedFacts) {
  auto rows = csv_rows("groups.csv");
  if (rows.empty()) GTEST_SKIP() << "groups.csv is not here";
  EXPECT_EQ(rows.size(), kGroups.size());
  for (auto& row : rows) {
    expect_group({std::stoi(row["group"]), std::stoi(row["bytes"]), std::stoi(row["first"]), std::stoi(row["last"]),
                  std::stoi(row["stream_frame_bytes"])});
  }
}

TEST(PacketTest, NumbersBetweenGroupsAndPacketsAreNeither) {
  for (const int id : {59, 99, 102, 105, 108, 255}) {
    EXPECT_EQ(group_info(static_cast<std::uint8_t>(id)), nullptr) << id;
    EXPECT_FALSE(SensorId::of(id)) << id;
  }
  EXPECT_FALSE(SensorId::of(-1));
  EXPECT_FALSE(SensorId::of(256 + 7));
}

TEST(SensorIdTest, ExistsWhereAllItsPacketsDo) {
  EXPECT_TRUE(SensorId(100).exists_on(Model::Create2));
  EXPECT_FALSE(SensorId(100).exists_on(Model::Create1));
  EXPECT_TRUE(SensorId(6).exists_on(Model::Create1));
  EXPECT_FALSE(SensorId(6).exists_on(Model::Roomba400));
  EXPECT_TRUE(SensorId(0).exists_on(Model::Roomba400));
  EXPECT_FALSE(SensorId(PacketId::Stasis).exists_on(Model::Create1));
  EXPECT_FALSE(SensorId::of(101, Model::Create1));
  EXPECT_EQ(SensorId::of(101, Model::Create2), SensorId(101));
}

template <int Number>
concept IsSensorId = requires {
  typename std::bool_constant<(SensorId(Number), true)>;
};

TEST(SensorIdTest, LiteralsThatAreNoPacketDontCompile) {
  static_assert(IsSensorId<7> && IsSensorId<58> && IsSensorId<0> && IsSensorId<107>);
  static_assert(!IsSensorId<59> && !IsSensorId<99> && !IsSensorId<-1> && !IsSensorId<356>);
}

}  // namespace
}  // namespace scrubjay::oi
