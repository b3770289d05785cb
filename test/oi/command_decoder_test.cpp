#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <scrubjay/oi/command_decoder.hpp>
#include <variant>
#include <vector>

#include "random_values.hpp"

namespace scrubjay::oi {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Bytes = std::vector<std::uint8_t>;
using Event = std::variant<Command, Rejected>;
using Why = Rejected::Why;

/// All that a decoder says of the bytes.
std::vector<Event> feed(CommandDecoder& decoder, std::span<const std::uint8_t> bytes) {
  std::vector<Event> events;
  decoder.feed(
      bytes, [&](const Command& command) { events.emplace_back(command); },
      [&](const Rejected& rejected) { events.emplace_back(rejected); });
  return events;
}

std::vector<Event> decoded(const Bytes& bytes, Model model = Model::Create2) {
  CommandDecoder decoder(model);
  return feed(decoder, bytes);
}

TEST(CommandDecoderTest, DecodesTheExampleOfTheSpecification) {
  EXPECT_THAT(decoded({137, 255, 56, 1, 244}), ElementsAre(Event(Drive{-200, 500})));
}

TEST(CommandDecoderTest, BothNumbersForStraightAreStraight) {
  EXPECT_THAT(decoded({137, 0, 1, 0x80, 0, 137, 0, 1, 0x7F, 0xFF}),
              ElementsAre(Event(Drive{1, Radius::straight()}), Event(Drive{1, Radius::straight()})));
}

TEST(CommandDecoderTest, DecodesWhatWasEncoded) {
  Random random(1);
  for (const Model model : {Model::Create2, Model::Create1, Model::Roomba400}) {
    CommandDecoder decoder(model);
    for (int i = 0; i < 20000; ++i) {
      const Command command = random_command(random, model);
      ASSERT_THAT(feed(decoder, encode(command)), ElementsAre(Event(command)));
    }
    EXPECT_EQ(decoder.commands(), 20000U);
    EXPECT_EQ(decoder.rejected() + decoder.unknown_opcodes(), 0U);
  }
}

TEST(CommandDecoderTest, ChunksDontMatter) {
  Random random(2);
  for (int run = 0; run < 200; ++run) {
    Bytes bytes;
    for (int i = 0; i < 20; ++i) {
      const CommandBytes command = encode(random_command(random, Model::Create2));
      bytes.insert(bytes.end(), command.bytes().begin(), command.bytes().end());
      if (random.between(0, 3) == 0) bytes.push_back(static_cast<std::uint8_t>(random.next()));
    }
    const auto whole = decoded(bytes);
    CommandDecoder decoder(Model::Create2);
    std::vector<Event> pieces;
    for (std::size_t at = 0; at < bytes.size();) {
      const auto count = std::min<std::size_t>(static_cast<std::size_t>(random.between(0, 9)), bytes.size() - at);
      for (Event& event : feed(decoder, std::span(bytes).subspan(at, count))) pieces.push_back(std::move(event));
      at += count;
    }
    ASSERT_EQ(pieces, whole);
  }
}

TEST(CommandDecoderTest, UnknownOpcodesAreSkippedAndCounted) {
  CommandDecoder decoder(Model::Create2);
  EXPECT_THAT(feed(decoder, Bytes{0, 255, 131}),
              ElementsAre(Event(Rejected{0, Why::UnknownOpcode}), Event(Rejected{255, Why::UnknownOpcode}),
                          Event(Command(Safe{}))));
  EXPECT_EQ(decoder.unknown_opcodes(), 2U);
  EXPECT_EQ(decoder.rejected(), 0U);
}

TEST(CommandDecoderTest, DataOutOfRangeAreConsumedWithTheirCommand) {
  // 501 mm/s; song slot 5; radius 2001; minute 60; packet 59; a pause state of 2.
  const std::vector<Bytes> wrong{
      {145, 1, 245, 0, 0}, {141, 5},        {137, 0, 0, 7, 0xD1}, {168, 0, 0, 60},      {142, 59}, {150, 2},
      {129, 12},           {148, 2, 7, 59}, {144, 0x80, 0, 0},    {164, 31, 65, 65, 65}};
  for (Bytes bytes : wrong) {
    const std::uint8_t opcode = bytes[0];
    bytes.push_back(128);
    EXPECT_THAT(decoded(bytes), ElementsAre(Event(Rejected{opcode, Why::OutOfRange}), Event(Command(Start{}))));
  }
}

TEST(CommandDecoderTest, SongsOfWrongLengthAreConsumedWhole) {
  for (const int notes : {0, 17, 255}) {
    Bytes bytes{140, 0, static_cast<std::uint8_t>(notes)};
    bytes.insert(bytes.end(), static_cast<std::size_t>(2 * notes), 128);
    bytes.push_back(131);
    EXPECT_THAT(decoded(bytes), ElementsAre(Event(Rejected{140, Why::OutOfRange}), Event(Command(Safe{})))) << notes;
  }
}

TEST(CommandDecoderTest, CommandsOfOtherModelsAreConsumedWhole) {
  EXPECT_THAT(decoded({152, 2, 128, 128, 131}),
              ElementsAre(Event(Rejected{152, Why::NotOnThisModel}), Event(Command(Safe{}))));
  EXPECT_THAT(decoded({164, 65, 65, 65, 128, 131}, Model::Create1),
              ElementsAre(Event(Rejected{164, Why::NotOnThisModel}), Event(Command(Safe{}))));
}

TEST(CommandDecoderTest, OneOpcodeIsMaxOrDemoByModel) {
  EXPECT_THAT(decoded({136, 131}), ElementsAre(Event(Command(Max{})), Event(Command(Safe{}))));
  EXPECT_THAT(decoded({136, 3, 131}, Model::Create1), ElementsAre(Event(Command(Demo{3})), Event(Command(Safe{}))));
  EXPECT_THAT(decoded({144, 1, 2, 3}, Model::Create1), ElementsAre(Event(Command(PwmLowSideDrivers{1, 2, 3}))));
  EXPECT_THAT(decoded({144, 1, 2, 3}), ElementsAre(Event(Command(PwmMotors{1, 2, 3}))));
}

TEST(CommandDecoderTest, PacketsThatTheModelLacksAreOutOfRange) {
  EXPECT_THAT(decoded({142, 100}, Model::Create1), ElementsAre(Event(Rejected{142, Why::OutOfRange})));
  EXPECT_THAT(decoded({142, 6}, Model::Create1), ElementsAre(Event(Command(Query{6}))));
}

TEST(CommandDecoderTest, ResetForgetsACommandThatHasBegun) {
  CommandDecoder decoder(Model::Create2);
  EXPECT_THAT(feed(decoder, Bytes{137, 255, 56}), IsEmpty());
  EXPECT_EQ(decoder.pending(), 3U);
  decoder.reset();
  EXPECT_EQ(decoder.pending(), 0U);
  EXPECT_THAT(feed(decoder, Bytes{131}), ElementsAre(Event(Command(Safe{}))));
}

}  // namespace
}  // namespace scrubjay::oi
