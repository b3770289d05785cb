#include <gtest/gtest.h>

#include <scrubjay/oi/infrared.hpp>
#include <set>
#include <string>

#include "csv.hpp"

namespace scrubjay::oi {
namespace {

TEST(InfraredTest, BeamsOfBothDocks) {
  struct Row {
    std::uint8_t character600;
    std::uint8_t discovery;
    DockBeams beams;  // red, green, force field
  };
  const Row rows[] = {{161, 242, {false, false, true}}, {164, 244, {false, true, false}},
                      {165, 246, {false, true, true}},  {168, 248, {true, false, false}},
                      {169, 250, {true, false, true}},  {172, 252, {true, true, false}},
                      {173, 254, {true, true, true}}};
  for (const Row& row : rows) {
    EXPECT_EQ(dock_beams(row.character600), row.beams) << int{row.character600};
    EXPECT_EQ(dock_beams(row.discovery), row.beams) << int{row.discovery};
    EXPECT_EQ(dock_character(row.beams), row.character600);
  }
  EXPECT_EQ(dock_character({}), 0);
}

TEST(InfraredTest, NothingElseIsADock) {
  const std::set<int> docks{161, 164, 165, 168, 169, 172, 173, 242, 244, 246, 248, 250, 252, 254};
  for (int c = 0; c < 256; ++c) {
    EXPECT_EQ(dock_beams(static_cast<std::uint8_t>(c)).has_value(), docks.contains(c)) << c;
  }
}

TEST(InfraredTest, LighthousesHaveAnIdAndABeam) {
  using Beam = Lighthouse::Beam;
  EXPECT_EQ(lighthouse(0b00001000), (Lighthouse{1, true, Beam::Fence}));
  EXPECT_EQ(lighthouse(0b01010011), (Lighthouse{10, true, Beam::Red}));
  EXPECT_EQ(lighthouse(0b01011001), (Lighthouse{11, false, Beam::ForceField}));
  EXPECT_EQ(lighthouse(0b00101010), (Lighthouse{5, true, Beam::Green}));
}

TEST(InfraredTest, NothingElseIsALighthouse) {
  EXPECT_FALSE(lighthouse(0));           // nothing received
  EXPECT_FALSE(lighthouse(0b00000010));  // id 0
  EXPECT_FALSE(lighthouse(0b01100000));  // id 12
  EXPECT_FALSE(lighthouse(0b00001100));  // bit 2 set
  EXPECT_FALSE(lighthouse(0b10001000));  // remote control
  EXPECT_FALSE(lighthouse(255));
}

TEST(InfraredTest, NoneDependsOnTheModel) {
  EXPECT_EQ(no_character(Model::Create2), 0);
  EXPECT_EQ(no_character(Model::Create1), 255);
  EXPECT_EQ(no_character(Model::Roomba400), 255);
}

TEST(InfraredTest, NamesOfCharacters) {
  EXPECT_EQ(infrared_character(130)->name, "forward");
  EXPECT_EQ(infrared_character(143)->source, InfraredSource::SchedulingRemote);
  EXPECT_EQ(infrared_character(kVirtualWall)->source, InfraredSource::VirtualWall);
  EXPECT_EQ(infrared_character(128), nullptr);
}

TEST(InfraredTest, TableIsTheSharedFacts) {
  auto rows = csv_rows("ir_characters.csv");
  if (rows.empty()) GTEST_SKIP() << "ir_characters.csv is not here";
  const std::map<std::string, InfraredSource> sources{{"remote", InfraredSource::Remote},
                                                      {"scheduling remote", InfraredSource::SchedulingRemote},
                                                      {"600 dock", InfraredSource::Dock600},
                                                      {"virtual wall", InfraredSource::VirtualWall},
                                                      {"Discovery dock", InfraredSource::DiscoveryDock}};
  std::size_t found = 0;
  for (auto& row : rows) {
    if (!sources.contains(row["source"])) continue;
    ++found;
    const InfraredCharacter* character = infrared_character(static_cast<std::uint8_t>(std::stoi(row["value"])));
    ASSERT_NE(character, nullptr) << row["value"];
    EXPECT_EQ(character->name, row["name"]);
    EXPECT_EQ(character->source, sources.at(row["source"]));
  }
  EXPECT_EQ(found, kInfraredCharacters.size());
}

}  // namespace
}  // namespace scrubjay::oi
