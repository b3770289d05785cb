#include <gtest/gtest.h>

#include <cmath>
#include <scrubjay/geometry/random.hpp>
#include <string>

#include "ros2/commands_fixture.hpp"

namespace scrubjay::ros {
namespace {

/// All that bytes can be given to, and a message that each of them takes.
struct Taker {
  const char* name;
  void (*take)(Commands&, Commands::Bytes);
  Bytes sound;
};

std::vector<Taker> takers() {
  const Pose pose = pose_at(1.0, 2.0, quaternion(0.5));
  return {{"twist", [](Commands& c, Commands::Bytes b) { c.take_twist(b); }, twist(0.1, 0.2)},
          {"twist_stamped", [](Commands& c, Commands::Bytes b) { c.take_twist_stamped(b); }, twist_stamped(0.1, 0.2)},
          {"goal", [](Commands& c, Commands::Bytes b) { c.take_goal(b); }, goal(pose)},
          {"initial_pose", [](Commands& c, Commands::Bytes b) { c.take_initial_pose(b); }, initial_pose(pose)},
          {"dock", [](Commands& c, Commands::Bytes b) { c.take_dock(b); }, encode(Empty{})},
          {"undock", [](Commands& c, Commands::Bytes b) { c.take_undock(b); }, encode(Empty{})},
          {"song", [](Commands& c, Commands::Bytes b) { c.take_song(b); }, song(0, 2, {60, 61}, {0.5F, 1.0F})},
          {"play", [](Commands& c, Commands::Bytes b) { c.take_play(b); }, encode(PlaySong{1})},
          {"led", [](Commands& c, Commands::Bytes b) { c.take_led(oi::Leds::kDock, b); }, encode(Bool{true})},
          {"power_led", [](Commands& c, Commands::Bytes b) { c.take_power_led(b); }, octets({1, 2})},
          {"digits", [](Commands& c, Commands::Bytes b) { c.take_digits(b); }, octets({'a'})}};
}

using CommandsGarbageTest = CommandsTest;

Bytes random_bytes(Random& random, std::size_t size) {
  Bytes bytes(size);
  for (std::byte& byte : bytes) byte = static_cast<std::byte>(random.below(256));
  return bytes;
}

TEST_F(CommandsGarbageTest, AMessageThatIsCutAnywhereIsMalformed) {
  for (const Taker& taker : takers()) {
    taker.take(commands, taker.sound);
    expect_taken();
    forget();
    // Empty says all it has to with its encapsulation.
    const bool empty = taker.sound == encode(Empty{});
    const std::size_t whole = empty ? 4 : taker.sound.size();
    for (std::size_t size = 0; size < whole; ++size) {
      SCOPED_TRACE(std::string(taker.name) + ", " + std::to_string(size) + " bytes");
      taker.take(commands, Commands::Bytes(taker.sound).first(size));
      expect_malformed();
      expect_nothing_wanted();
    }
  }
}

TEST_F(CommandsGarbageTest, GarbageIsCountedAndNothingComesOfIt) {
  Random random(1);
  for (const Taker& taker : takers()) {
    SCOPED_TRACE(taker.name);
    for (int i = 0; i < 10000; ++i) {
      Bytes bytes = random_bytes(random, random.below(200));
      // No encapsulation of plain CDR: by chance one of 32768 would have one.
      if (bytes.size() >= 2 && bytes[0] == std::byte{0}) bytes[0] = std::byte{1};
      taker.take(commands, bytes);
    }
    EXPECT_EQ(counted().malformed, 10000u);
    expect_nothing_wanted();
  }
}

/// Random bytes behind a sound head may be a message, by chance; then it is one that a robot can obey.
TEST_F(CommandsGarbageTest, GarbageWithASoundHeadIsAtMostAnObeyableCommand) {
  Random random(2);
  for (const Taker& taker : takers()) {
    SCOPED_TRACE(taker.name);
    for (int i = 0; i < 10000; ++i) {
      Bytes bytes = random_bytes(random, 4 + random.below(400));
      bytes[0] = std::byte{0};
      bytes[1] = static_cast<std::byte>(random.below(2));
      taker.take(commands, bytes);
      const CommandTally tally = counted();
      ASSERT_EQ(tally.taken + tally.malformed + tally.out_of_range + tally.other_frame, 1u);
      const Wishes wishes = commands.wishes();
      if (const auto& velocity = wishes.velocity) {
        ASSERT_LE(std::fabs(velocity->linear), kLimits.linear * (1.0 + 1e-12));
        ASSERT_LE(std::fabs(velocity->angular), kLimits.angular * (1.0 + 1e-12));
      }
      for (const auto& pose : {wishes.goal, commands.initial_pose()}) {
        if (!pose) continue;
        ASSERT_LE(std::fabs(pose->x), Commands::kReach);
        ASSERT_LE(std::fabs(pose->y), Commands::kReach);
        ASSERT_LE(std::fabs(pose->yaw), 3.1416);
      }
      for (const oi::Command& order : orders()) {
        ASSERT_TRUE(oi::valid_on(order, oi::Model::Create2) || oi::valid_on(order, oi::Model::Create1));
      }
    }
  }
}

/// A sound message with some bytes changed: the likeliest garbage, and the most dangerous.
TEST_F(CommandsGarbageTest, DamagedMessagesAreAtMostObeyableCommands) {
  Random random(3);
  for (const Taker& taker : takers()) {
    SCOPED_TRACE(taker.name);
    for (int i = 0; i < 10000; ++i) {
      Bytes bytes = taker.sound;
      for (std::uint32_t n = 1 + random.below(4); n > 0; --n) {
        bytes[random.below(static_cast<std::uint32_t>(bytes.size()))] = static_cast<std::byte>(random.below(256));
      }
      taker.take(commands, bytes);
      const CommandTally tally = counted();
      ASSERT_EQ(tally.taken + tally.malformed + tally.out_of_range + tally.other_frame, 1u);
      if (const auto told = velocity()) {
        ASSERT_LE(std::fabs(told->linear), kLimits.linear * (1.0 + 1e-12));
        ASSERT_LE(std::fabs(told->angular), kLimits.angular * (1.0 + 1e-12));
      }
      forget();
    }
  }
}

}  // namespace
}  // namespace scrubjay::ros
