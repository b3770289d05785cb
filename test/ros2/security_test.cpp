#include <gmock/gmock.h>

#include <scrubjay/ros2/bridge.hpp>

#include "ros2/test_keystore.hpp"
#include "ros2/wire_fixture.hpp"

namespace scrubjay::ros {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class SecurityTest : public WireTest {
 protected:
  void SetUp() override {
    if (!keystore_.made()) GTEST_SKIP() << "there is no openssl on the command line to make certificates with";
  }
  ParticipantOptions secured(TestKeystore& keystore, const std::string& enclave, const std::string& allowed = "rt/*") {
    ParticipantOptions secured = options(NodeNames(enclave.substr(1)));
    secured.enclave = enclave;
    secured.security = keystore.enclave(enclave, allowed);
    return secured;
  }

  TestKeystore keystore_{domain_.number()};
};

/// One that talks and listens, on topics of its own and of others.
struct Talker {
  Talker(const ParticipantOptions& options, const std::string& says, const std::string& hears)
      : participant(options),
        writer(participant.write(says, kTypeOf<String>, kLatched)),
        reader(participant.read(hears, kTypeOf<String>, kLatched, inbox.receive())) {}

  Inbox inbox;
  Participant participant;
  Writer& writer;
  Reader& reader;
};

TEST_F(SecurityTest, TheSecureHearOneAnotherAndTheInsecureHearAndSayNothing) {
  Talker robot(secured(keystore_, "/robot"), "map", "cmd_vel");
  Talker insecure(options(), "cmd_vel", "map");
  insecure.writer.publish(text("from the insecure"));
  robot.writer.publish(text("to the secure"));
  Talker driver(secured(keystore_, "/driver"), "cmd_vel", "map");
  driver.writer.publish(text("from the secure"));
  ASSERT_TRUE(eventually([&] { return robot.inbox.size() == 1 && driver.inbox.size() == 1; }));
  EXPECT_EQ(decode<String>(robot.inbox.all()[0])->data, "from the secure");
  EXPECT_EQ(decode<String>(driver.inbox.all()[0])->data, "to the secure");
  // Another insecure one comes after all of this, and hears the insecure alone.
  Talker late(options(), "cmd_vel", "cmd_vel");
  ASSERT_TRUE(eventually([&] { return late.inbox.size() == 1; }));
  EXPECT_EQ(decode<String>(late.inbox.all()[0])->data, "from the insecure");
  EXPECT_THAT(insecure.inbox.all(), IsEmpty());
  EXPECT_EQ(robot.inbox.size(), 1U);
  EXPECT_EQ(robot.writer.readers(), 1);
  EXPECT_EQ(robot.reader.writers(), 1);
  EXPECT_EQ(insecure.writer.readers(), 1);
}

TEST_F(SecurityTest, TheSecureDriveARobotAndTheInsecureDoNot) {
  Commands commands{{0.5, 4.0}};
  Bridge robot(secured(keystore_, "/robot"), kTopics);
  robot.listen(commands);
  Participant insecure(options());
  Participant driver(secured(keystore_, "/driver"));
  Writer& forged = insecure.write("cmd_vel", kTypeOf<Twist>);
  Writer& sound = driver.write("cmd_vel", kTypeOf<Twist>);
  Inbox overheard;
  insecure.read("odom", kTypeOf<Odometry>, {}, overheard.receive());
  Inbox heard;
  driver.read("odom", kTypeOf<Odometry>, {}, heard.receive());
  const auto odometry = std::make_shared<const Bytes>(encode(Odometry{}));
  ASSERT_TRUE(eventually([&] {
    forged.publish(encode(Twist{.linear = {0.4, 0.0, 0.0}, .angular = {}}));
    sound.publish(encode(Twist{.linear = {0.25, 0.0, 0.0}, .angular = {}}));
    robot.publish(kOdomTopic, 0, odometry);
    const std::optional<Motion> told = commands.wishes().velocity;
    EXPECT_EQ(told.value_or(Motion{0.25, 0.0}), (Motion{0.25, 0.0}));
    return told && heard.size() > 10;
  }));
  EXPECT_EQ(forged.readers(), 0);
  EXPECT_THAT(overheard.all(), IsEmpty());
}

TEST_F(SecurityTest, ThoseOfAnotherAuthorityAreStrangers) {
  TestKeystore other(domain_.number());
  Talker robot(secured(keystore_, "/robot"), "map", "cmd_vel");
  Talker stranger(secured(other, "/stranger"), "cmd_vel", "map");
  robot.writer.publish(text("to friends"));
  stranger.writer.publish(text("from a stranger"));
  Talker friendly(secured(keystore_, "/friendly"), "cmd_vel", "map");
  friendly.writer.publish(text("from a friend"));
  ASSERT_TRUE(eventually([&] { return robot.inbox.size() == 1 && friendly.inbox.size() == 1; }));
  EXPECT_EQ(decode<String>(robot.inbox.all()[0])->data, "from a friend");
  EXPECT_THAT(stranger.inbox.all(), IsEmpty());
}

TEST_F(SecurityTest, WhatPermissionsForbidIsAnError) {
  Participant robot(secured(keystore_, "/robot", "rt/map"));
  robot.write("map", kTypeOf<String>);
  EXPECT_THAT(message_of([&] { robot.write("cmd_vel", kTypeOf<String>); }),
              HasSubstr("can't write /cmd_vel: rt/cmd_vel topic not found in allow rule"));
  EXPECT_THAT(message_of([&] { robot.read("odom", kTypeOf<String>, {}, [](auto) {}); }),
              HasSubstr("can't read /odom: rt/odom topic not found in allow rule"));
  // Nothing is left of what wasn't allowed.
  EXPECT_EQ(robot.endpoints().size(), 1U);
  EXPECT_THAT(robot.unheard(), ::testing::ElementsAre("/map"));
}

TEST_F(SecurityTest, FilesThatDoNotFitAreAnErrorWithAReason) {
  ParticipantOptions broken = secured(keystore_, "/robot");
  broken.security->private_key = broken.security->certificate;
  EXPECT_THAT(message_of([&] { Participant robot(broken); }),
              AllOf(HasSubstr("Fast DDS can't join domain"), HasSubstr("private key")));
}

}  // namespace
}  // namespace scrubjay::ros
