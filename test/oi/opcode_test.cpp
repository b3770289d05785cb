#include <gtest/gtest.h>

#include <map>
#include <scrubjay/oi/opcode.hpp>
#include <string>

#include "csv.hpp"

namespace scrubjay::oi {
namespace {

struct OpcodeRow {
  int opcode;
  std::string name;
  std::string data_bytes;  ///< as the specification writes it: "4", "2N+2"
  std::string modes;
  std::string mode_after;
  std::string models;
};

/// The specification, under the names that Roombas and Create 2 give.
const OpcodeRow kOpcodeRows[] = {
    {7, "reset", "0", "any", "off", "C2 500+"},
    {128, "start", "0", "any", "passive", "all"},
    {129, "baud", "1", "passive safe full", "-", "all"},
    {130, "control", "0", "passive safe full", "safe", "all"},
    {131, "safe", "0", "passive safe full", "safe", "all"},
    {132, "full", "0", "passive safe full", "full", "all"},
    {133, "power", "0", "passive safe full", "passive", "C2 R4"},
    {134, "spot", "0", "passive safe full", "passive", "all"},
    {135, "clean", "0", "passive safe full", "passive", "C2 R4"},
    {136, "max", "0", "passive safe full", "passive", "C2 R4"},
    {137, "drive", "4", "safe full", "-", "all"},
    {138, "motors", "1", "safe full", "-", "all"},
    {139, "leds", "3", "safe full", "-", "all"},
    {140, "song", "2N+2", "passive safe full", "-", "all"},
    {141, "play", "1", "safe full", "-", "all"},
    {142, "sensors", "1", "passive safe full", "-", "all"},
    {143, "seek_dock", "0", "passive safe full", "passive", "C2 R4"},
    {144, "pwm_motors", "3", "safe full", "-", "C2"},
    {145, "drive_direct", "4", "safe full", "-", "C2 C1"},
    {146, "drive_pwm", "4", "safe full", "-", "C2"},
    {147, "digital_outputs", "1", "safe full", "-", "C1"},
    {148, "stream", "N+1", "passive safe full", "-", "C2 C1"},
    {149, "query_list", "N+1", "passive safe full", "-", "C2 C1"},
    {150, "pause_resume_stream", "1", "passive safe full", "-", "C2 C1"},
    {151, "send_ir", "1", "safe full", "-", "C1"},
    {152, "script", "N+1", "passive safe full", "-", "C1"},
    {153, "play_script", "0", "passive safe full", "-", "C1"},
    {154, "show_script", "0", "passive safe full", "-", "C1"},
    {155, "wait_time", "1", "passive safe full", "-", "C1"},
    {156, "wait_distance", "2", "passive safe full", "-", "C1"},
    {157, "wait_angle", "2", "passive safe full", "-", "C1"},
    {158, "wait_event", "1", "passive safe full", "-", "C1"},
    {162, "scheduling_leds", "2", "safe full", "-", "C2"},
    {163, "digit_leds_raw", "4", "safe full", "-", "C2"},
    {164, "digit_leds_ascii", "4", "safe full", "-", "C2"},
    {165, "buttons", "1", "passive safe full", "-", "C2"},
    {167, "schedule", "15", "passive safe full", "-", "C2"},
    {168, "set_day_time", "3", "passive safe full", "-", "C2"},
    {173, "stop", "0", "passive safe full", "off", "C2"},
};

const std::map<std::string, DataLength> kLengths{{"0", {0}}, {"1", {1}},   {"2", {2}},      {"3", {3}},
                                                 {"4", {4}}, {"15", {15}}, {"N+1", {1, 1}}, {"2N+2", {2, 2}}};
const std::map<std::string, ModeSet> kModes{
    {"any", OiMode::Off | OiMode::Passive | OiMode::Safe | ModeSet(OiMode::Full)},
    {"passive safe full", OiMode::Passive | OiMode::Safe | ModeSet(OiMode::Full)},
    {"safe full", OiMode::Safe | OiMode::Full}};
const std::map<std::string, std::optional<OiMode>> kModesAfter{
    {"-", {}}, {"off", OiMode::Off}, {"passive", OiMode::Passive}, {"safe", OiMode::Safe}, {"full", OiMode::Full}};
const std::map<std::string, ModelSet> kModels{{"all", Model::Create2 | Model::Create1 | ModelSet(Model::Roomba400)},
                                              {"C2", Model::Create2},
                                              {"C2 500+", Model::Create2},
                                              {"C1", Model::Create1},
                                              {"C2 C1", Model::Create2 | Model::Create1},
                                              {"C2 R4", Model::Create2 | Model::Roomba400}};

const OpcodeInfo* row_named(const std::string& name) {
  for (const OpcodeInfo& info : kOpcodes) {
    if (info.name == name) return &info;
  }
  return nullptr;
}

void expect_in_table(const OpcodeRow& row) {
  SCOPED_TRACE(row.name);
  const OpcodeInfo* info = row_named(row.name);
  ASSERT_NE(info, nullptr);
  EXPECT_EQ(static_cast<int>(info->opcode), row.opcode);
  EXPECT_EQ(info->data, kLengths.at(row.data_bytes));
  EXPECT_EQ(info->modes, kModes.at(row.modes));
  EXPECT_EQ(info->mode_after, kModesAfter.at(row.mode_after));
  EXPECT_EQ(info->models, kModels.at(row.models));
}

TEST(OpcodeTest, TableIsTheSpecification) {
  for (const OpcodeRow& row : kOpcodeRows) expect_in_table(row);
  // Four more are other names that Create 1 gives.
  EXPECT_EQ(kOpcodes.size(), std::size(kOpcodeRows) + 4);
}

TEST(OpcodeTest, TableIsTheSharedFacts) {
  auto rows = csv_rows("opcodes.csv");
  if (rows.empty()) GTEST_SKIP() << "opcodes.csv is not here";
  EXPECT_EQ(kOpcodes.size(), rows.size() + 4);
  for (auto& row : rows) {
    expect_in_table(
        {std::stoi(row["opcode"]), row["name"], row["databytes"], row["modes"], row["mode_after"], row["models"]});
  }
}

TEST(OpcodeTest, DemoOfCreate1HasAByteWhereMaxHasNone) {
  EXPECT_EQ(opcode_info(136, Model::Create2)->name, "max");
  EXPECT_EQ(opcode_info(136, Model::Create2)->data, DataLength{0});
  EXPECT_EQ(opcode_info(136, Model::Roomba400)->data, DataLength{0});
  EXPECT_EQ(opcode_info(136, Model::Create1)->name, "demo");
  EXPECT_EQ(opcode_info(136, Model::Create1)->data, DataLength{1});
}

TEST(OpcodeTest, Create1GivesOtherNames) {
  EXPECT_EQ(opcode_info(135, Model::Create1)->name, "cover");
  EXPECT_EQ(opcode_info(143, Model::Create1)->name, "cover_and_dock");
  EXPECT_EQ(opcode_info(144, Model::Create1)->name, "pwm_low_side_drivers");
}

TEST(OpcodeTest, BytesThatAreNoOpcodeHaveNoRow) {
  for (const int byte : {0, 6, 8, 127, 159, 161, 166, 169, 172, 174, 255}) {
    EXPECT_EQ(opcode_info(static_cast<std::uint8_t>(byte), Model::Create2), nullptr) << byte;
  }
  EXPECT_EQ(opcode_info(Opcode::Script, Model::Create2), nullptr);
  EXPECT_EQ(opcode_info(Opcode::Stream, Model::Roomba400), nullptr);
  EXPECT_EQ(opcode_info(Opcode::Power, Model::Create1), nullptr);
}

TEST(OpcodeTest, MotorsObeyInSafeAndFullOnly) {
  EXPECT_FALSE(allowed_in(Opcode::Drive, OiMode::Off));
  EXPECT_FALSE(allowed_in(Opcode::Drive, OiMode::Passive));
  EXPECT_TRUE(allowed_in(Opcode::Drive, OiMode::Safe));
  EXPECT_TRUE(allowed_in(Opcode::Drive, OiMode::Full));
}

TEST(OpcodeTest, OffListensToStartAndReset) {
  for (const OpcodeInfo& info : kOpcodes) {
    const bool expected = info.opcode == Opcode::Start || info.opcode == Opcode::Reset;
    EXPECT_EQ(info.modes.contains(OiMode::Off), expected) << info.name;
  }
}

TEST(OpcodeTest, NothingIsAllowedThatTheModelLacks) {
  EXPECT_FALSE(allowed_in(Opcode::DrivePwm, OiMode::Full, Model::Create1));
  EXPECT_TRUE(allowed_in(Opcode::DrivePwm, OiMode::Full, Model::Create2));
}

}  // namespace
}  // namespace scrubjay::oi
