#include <gmock/gmock.h>

#include <scrubjay/geometry/random.hpp>
#include <scrubjay/messages/geometry_msgs.hpp>
#include <scrubjay/messages/nav_msgs.hpp>

#include "io/temporary_folder.hpp"
#include "ros2/wire_fixture.hpp"

namespace scrubjay::ros {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

std::string content(const Bytes& message) {
  return decode<String>(message)->data;
}

TEST_F(WireTest, BytesArriveAsTheyWerePublished) {
  Participant robot(options());
  Participant listener(options());
  Inbox inbox;
  Writer& writer = robot.write("chatter", kTypeOf<String>);
  Reader& reader = listener.read("/chatter", kTypeOf<String>, {}, inbox.receive());
  ASSERT_TRUE(eventually([&] { return writer.readers() == 1 && reader.writers() == 1; }));
  writer.publish(text("hello"));
  ASSERT_TRUE(eventually([&] { return inbox.size() == 1; }));
  Bytes padded = text("hello");
  padded.resize(16);  // DDS has messages end on a boundary of four
  EXPECT_EQ(inbox.all(), std::vector<Bytes>{padded});
  EXPECT_EQ(reader.received(), 1U);
  EXPECT_EQ(writer.tally(), (WriterTally{1, 0, 0}));
}

TEST_F(WireTest, WhoComesLateGetsTheNewestOfWhatIsLatched) {
  Participant robot(options());
  Writer& map = robot.write("map", kTypeOf<String>, kLatched);
  Writer& chatter = robot.write("chatter", kTypeOf<String>);
  for (const char* words : {"old", "older", "newest"}) {
    map.publish(text(words));
    chatter.publish(text(words));
    ASSERT_TRUE(robot.flush(30.0));
  }
  Inbox latched;
  Inbox passing;
  Participant late(options());
  late.read("map", kTypeOf<String>, kLatched, latched.receive());
  late.read("chatter", kTypeOf<String>, {}, passing.receive());
  ASSERT_TRUE(eventually([&] { return latched.size() == 1 && chatter.readers() == 1; }));
  EXPECT_EQ(content(latched.all()[0]), "newest");
  chatter.publish(text("now"));
  ASSERT_TRUE(eventually([&] { return passing.size() == 1; }));
  EXPECT_EQ(content(passing.all()[0]), "now");
}

TEST_F(WireTest, AReliableWriterIsHeardByReadersOfBothKinds) {
  Participant robot(options());
  Participant listener(options());
  Inbox reliable;
  Inbox best_effort;
  Writer& writer = robot.write("chatter", kTypeOf<String>, {Reliability::Reliable, Durability::Volatile, 200});
  listener.read("chatter", kTypeOf<String>, {Reliability::Reliable, Durability::Volatile, 200}, reliable.receive());
  Reader& passing = listener.read("chatter", kTypeOf<String>, kBestEffort, best_effort.receive());
  ASSERT_TRUE(eventually([&] { return writer.readers() == 2 && passing.writers() == 1; }));
  for (int i = 0; i < 200; ++i) writer.publish(text(std::to_string(i)));
  ASSERT_TRUE(eventually([&] { return reliable.size() == 200; }));
  ASSERT_TRUE(eventually([&] { return best_effort.size() > 0; }));
  for (int i = 0; i < 200; ++i) EXPECT_EQ(content(reliable.all()[static_cast<std::size_t>(i)]), std::to_string(i));
  EXPECT_THAT(told_.all(), IsEmpty());
}

TEST_F(WireTest, ABestEffortReaderHearsAWriterOfAnyKind) {
  Participant robot(options());
  Participant one(options());
  Participant other(options());
  Reader& reader = robot.read("cmd_vel", kTypeOf<Twist>, kBestEffort, [](auto) {});
  one.write("cmd_vel", kTypeOf<Twist>, kBestEffort);
  other.write("cmd_vel", kTypeOf<Twist>);
  EXPECT_TRUE(eventually([&] { return reader.writers() == 2; }));
}

TEST_F(WireTest, AMapOfMegabytesArrivesWhole) {
  Participant robot(options());
  ParticipantOptions large = options();
  large.most_read = 8'000'000;
  Participant listener(large);
  Inbox inbox;
  Writer& writer = robot.write("map", kTypeOf<OccupancyGrid>, kLatched);
  listener.read("map", kTypeOf<OccupancyGrid>, kLatched, inbox.receive());
  OccupancyGrid map;
  Random random(7);
  map.data.resize(4'000'000);
  for (std::int8_t& cell : map.data) cell = static_cast<std::int8_t>(random.below(101));
  writer.publish(encode(map));
  ASSERT_TRUE(eventually([&] { return inbox.size() == 1; }));
  EXPECT_EQ(decode<OccupancyGrid>(inbox.all()[0]), map);
}

TEST_F(WireTest, WhatWasPublishedIsSentEvenWhereItsRobotEnds) {
  Participant listener(options());
  Inbox inbox;
  Reader& reader =
      listener.read("chatter", kTypeOf<String>, {Reliability::Reliable, Durability::Volatile, 100}, inbox.receive());
  {
    Participant robot(options());
    Writer& writer = robot.write("chatter", kTypeOf<String>, {Reliability::Reliable, Durability::Volatile, 100});
    ASSERT_TRUE(eventually([&] { return writer.readers() == 1 && reader.writers() == 1; }));
    for (int i = 0; i < 100; ++i) writer.publish(text(std::to_string(i)));
    ASSERT_TRUE(robot.flush(30.0));
  }
  EXPECT_TRUE(eventually([&] { return inbox.size() == 100; }));
}

TEST(ParticipantOptionsTest, AreMadeOfTheEnvironmentAndTheArguments) {
  const Environment environment{.domain = 7,
                                .distribution = Distribution::Humble,
                                .discovery = {DiscoveryRange::Localhost, {"a"}},
                                .warnings = {"of the environment"}};
  const RosArguments arguments{
      .remappings = {{"__ns", "/robot1"}, {"scan", "laser"}}, .enclave = "/e", .warnings = {"of the arguments"}};
  std::vector<std::string> warnings;
  const ParticipantOptions options = participant_options(environment, arguments, warnings);
  EXPECT_EQ(options.domain, 7);
  EXPECT_EQ(options.distribution, Distribution::Humble);
  EXPECT_EQ(options.discovery, environment.discovery);
  EXPECT_EQ(options.names.full_name(), "/robot1/scrubjay");
  EXPECT_EQ(options.names.topic("scan"), "/robot1/laser");
  EXPECT_EQ(options.enclave, "/e");
  EXPECT_FALSE(options.security);
  EXPECT_THAT(warnings, ElementsAre("of the environment", "of the arguments"));
}

TEST(ParticipantOptionsTest, SecurityThatIsToBeEnforcedIsThereOrAnError) {
  std::vector<std::string> warnings;
  Environment environment;
  environment.security = SecurityRequest{.enforce = true, .keystore = "/no/such/folder", .enclave_override = ""};
  EXPECT_THAT(message_of([&] { participant_options(environment, {}, warnings); }), HasSubstr("/no/such/folder"));
  environment.security->enforce = false;
  EXPECT_FALSE(participant_options(environment, {}, warnings).security);
  EXPECT_THAT(warnings, SizeIs(1));
}

}  // namespace
}  // namespace scrubjay::ros
