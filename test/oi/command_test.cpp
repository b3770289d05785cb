#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <scrubjay/oi/command.hpp>
#include <vector>

#include "random_values.hpp"

namespace scrubjay::oi {
namespace {

using testing::ElementsAre;
using testing::ElementsAreArray;

std::vector<int> bytes_of(const Command& command) {
  const CommandBytes bytes = encode(command);
  return {bytes.bytes().begin(), bytes.bytes().end()};
}

TEST(CommandTest, DriveIsTheExampleOfTheSpecification) {
  EXPECT_THAT(bytes_of(Drive{-200, 500}), ElementsAre(137, 255, 56, 1, 244));
}

TEST(CommandTest, SpecialRadii) {
  EXPECT_THAT(bytes_of(Drive{100, Radius::straight()}), ElementsAre(137, 0, 100, 0x80, 0));
  EXPECT_THAT(bytes_of(Drive{100, Radius::spin_clockwise()}), ElementsAre(137, 0, 100, 255, 255));
  EXPECT_THAT(bytes_of(Drive{100, Radius::spin_counter_clockwise()}), ElementsAre(137, 0, 100, 0, 1));
}

TEST(CommandTest, RightWheelComesFirst) {
  EXPECT_THAT(bytes_of(DriveDirect{.right = 300, .left = -2}), ElementsAre(145, 1, 44, 255, 254));
  EXPECT_THAT(bytes_of(DrivePwm{.right = 255, .left = -255}), ElementsAre(146, 0, 255, 255, 1));
}

TEST(CommandTest, EachCommandHasItsBytes) {
  struct Row {
    Command command;
    std::vector<int> bytes;
  };
  const std::vector<Row> rows{
      {Reset{}, {7}},
      {Start{}, {128}},
      {Baud{11}, {129, 11}},
      {Control{}, {130}},
      {Safe{}, {131}},
      {Full{}, {132}},
      {Power{}, {133}},
      {Spot{}, {134}},
      {Clean{}, {135}},
      {Cover{}, {135}},
      {Max{}, {136}},
      {Demo{-1}, {136, 255}},
      {Motors{Motors::kMainBrush | Motors::kVacuum}, {138, 6}},
      {Leds{Leds::kDock, 255, 128}, {139, 4, 255, 128}},
      {Song{3, {{60, 32}, {0, 64}}}, {140, 3, 2, 60, 32, 0, 64}},
      {Play{3}, {141, 3}},
      {Query{100}, {142, 100}},
      {SeekDock{}, {143}},
      {CoverAndDock{}, {143}},
      {PwmMotors{-127, 127, 64}, {144, 129, 127, 64}},
      {PwmLowSideDrivers{128, 1, 0}, {144, 128, 1, 0}},
      {DigitalOutputs{5}, {147, 5}},
      {Stream{{29, PacketId::VirtualWall}}, {148, 2, 29, 13}},
      {Stream{}, {148, 0}},
      {QueryList{{7, 100}}, {149, 2, 7, 100}},
      {PauseResumeStream{1}, {150, 1}},
      {SendIr{161}, {151, 161}},
      {Script{{137, 1}}, {152, 2, 137, 1}},
      {PlayScript{}, {153}},
      {ShowScript{}, {154}},
      {WaitTime{20}, {155, 20}},
      {WaitDistance{-400}, {156, 254, 112}},
      {WaitAngle{90}, {157, 0, 90}},
      {WaitEvent{-5}, {158, 251}},
      {SchedulingLeds{1, 24}, {162, 1, 24}},
      {DigitLedsRaw{{1, 2, 4, 8}}, {163, 1, 2, 4, 8}},
      {DigitLedsAscii{{65, 66, 67, 126}}, {164, 65, 66, 67, 126}},
      {Buttons{1}, {165, 1}},
      {Schedule{40, {{{0, 0}, {0, 0}, {0, 0}, {15, 0}, {0, 0}, {10, 36}, {0, 0}}}},
       {167, 40, 0, 0, 0, 0, 0, 0, 15, 0, 0, 0, 10, 36, 0, 0}},
      {SetDayTime{6, 23, 59}, {168, 6, 23, 59}},
      {Stop{}, {173}},
  };
  for (const Row& row : rows) {
    EXPECT_THAT(bytes_of(row.command), ElementsAreArray(row.bytes)) << row.bytes[0];
    EXPECT_EQ(static_cast<int>(opcode_of(row.command)), row.bytes[0]);
  }
}

TEST(CommandTest, LengthIsThatOfTheTable) {
  Random random(7);
  for (const Model model : {Model::Create2, Model::Create1, Model::Roomba400}) {
    for (int i = 0; i < 2000; ++i) {
      const Command command = random_command(random, model);
      const auto bytes = bytes_of(command);
      const DataLength length = opcode_info(opcode_of(command), model)->data;
      const int count = length.variable() ? bytes[length.fixed] : 0;
      EXPECT_EQ(static_cast<int>(bytes.size()), 1 + length.fixed + count * length.per_item) << bytes[0];
    }
  }
}

TEST(CommandTest, NothingIsWrittenWhereItDoesntFit) {
  Random random(8);
  for (int i = 0; i < 1000; ++i) {
    const Command command = random_command(random, Model::Create2);
    const CommandBytes whole = encode(command);
    std::vector<std::uint8_t> room(whole.size, 0xEE);
    EXPECT_EQ(encode(command, std::span(room).first(whole.size - 1)), 0U);
    EXPECT_TRUE(std::all_of(room.begin(), room.end(), [](std::uint8_t b) { return b == 0xEE; }));
    EXPECT_EQ(encode(command, room), whole.size);
  }
}

TEST(CommandTest, TheLongestCommandFits) {
  const std::vector<SensorId> ids(255, SensorId(100));
  EXPECT_EQ(encode(QueryList{*decltype(QueryList::ids)::of(ids)}).size, kMaxCommandBytes);
}

TEST(CommandTest, ValidityDependsOnTheModel) {
  EXPECT_TRUE(valid_on(Play{4}, Model::Create2));
  EXPECT_FALSE(valid_on(Play{5}, Model::Create2));
  EXPECT_TRUE(valid_on(Play{15}, Model::Create1));
  EXPECT_TRUE(valid_on(Query{100}, Model::Create2));
  EXPECT_FALSE(valid_on(Query{100}, Model::Create1));
  EXPECT_FALSE(valid_on(Stream{{7, 43}}, Model::Create1));
  EXPECT_FALSE(valid_on(Stream{{7}}, Model::Roomba400));
  EXPECT_TRUE(valid_on(Max{}, Model::Create2));
  EXPECT_FALSE(valid_on(Max{}, Model::Create1));
  EXPECT_FALSE(valid_on(Demo{1}, Model::Create2));
  EXPECT_FALSE(valid_on(PwmMotors{}, Model::Create1));
  EXPECT_FALSE(valid_on(PwmLowSideDrivers{}, Model::Create2));
  EXPECT_TRUE(valid_on(Cover{}, Model::Create1));
}

}  // namespace
}  // namespace scrubjay::oi
