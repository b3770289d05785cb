#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <thread>

#include "ros2/commands_fixture.hpp"

namespace scrubjay::ros {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST_F(CommandsTest, HandsOnAVelocityOnceAsItWasTold) {
  commands.take_twist(twist(0.2, -0.75));
  expect_taken();
  EXPECT_EQ(velocity(), (Motion{0.2, -0.75}));
  expect_nothing_wanted();
  commands.take_twist_stamped(twist_stamped(-0.25, 0.5));
  expect_taken();
  EXPECT_EQ(velocity(), (Motion{-0.25, 0.5}));
}

TEST_F(CommandsTest, KeepsTheNewestVelocityOfEitherKind) {
  commands.take_twist(twist(0.1, 0.0));
  commands.take_twist_stamped(twist_stamped(0.2, 0.0));
  commands.take_twist(twist(0.0, 0.0));
  EXPECT_EQ(velocity(), Motion{});
  EXPECT_EQ(counted().taken, 3u);
}

TEST_F(CommandsTest, SlowsDownWhatIsTooFastAndKeepsTheCurve) {
  for (const auto& [linear, angular] : {std::pair(1.0, 1.0), std::pair(-10.0, 0.5), std::pair(0.1, 100.0),
                                        std::pair(-0.6, -3.0), std::pair(0.5, 2.1), std::pair(10.0, -100.0)}) {
    commands.take_twist(twist(linear, angular));
    expect_taken();
    const Motion motion = velocity().value();
    EXPECT_LE(std::fabs(motion.linear), kLimits.linear * (1.0 + 1e-12));
    EXPECT_LE(std::fabs(motion.angular), kLimits.angular * (1.0 + 1e-12));
    EXPECT_NEAR(motion.linear * angular, motion.angular * linear, 1e-12) << "the curve";
    EXPECT_GE(motion.linear * linear, 0.0) << "the direction";
    EXPECT_TRUE(std::fabs(motion.linear) > kLimits.linear * (1.0 - 1e-12) ||
                std::fabs(motion.angular) > kLimits.angular * (1.0 - 1e-12))
        << "no slower than it must be";
  }
}

TEST_F(CommandsTest, RefusesVelocitiesThatAreNoNumbersOrAbsurd) {
  commands.take_twist(twist(0.1, 0.2));
  expect_taken();
  for (const double bad : {kNan, kInfinity, -kInfinity, 1e9, -1e300, 100.5, std::numeric_limits<double>::max()}) {
    commands.take_twist(twist(bad, 0.0));
    expect_out_of_range();
    commands.take_twist(twist(0.1, bad));
    expect_out_of_range();
    commands.take_twist_stamped(twist_stamped(bad, bad));
    expect_out_of_range();
    for (double Vector3::*axis : {&Vector3::x, &Vector3::y, &Vector3::z}) {
      Twist skewed;
      skewed.linear.x = 0.3;
      skewed.linear.*axis = bad;
      commands.take_twist(encode(skewed));
      expect_out_of_range();
      skewed.linear = {0.3, 0.0, 0.0};
      skewed.angular.*axis = bad;
      commands.take_twist(encode(skewed));
      expect_out_of_range();
    }
  }
  EXPECT_EQ(velocity(), (Motion{0.1, 0.2})) << "what is refused changes nothing";
}

TEST_F(CommandsTest, TakesTheSmallestNumbersThereAre) {
  const double least = std::numeric_limits<double>::denorm_min();
  commands.take_twist(twist(least, -least));
  expect_taken();
  EXPECT_EQ(velocity(), (Motion{least, -least}));
}

TEST_F(CommandsTest, HandsOnTheNewestGoalAndPlaceOnce) {
  commands.take_goal(goal(pose_at(9.0, 9.0, quaternion(0.0))));
  commands.take_goal(goal(pose_at(1.0, -2.0, quaternion(0.5))));
  commands.take_initial_pose(initial_pose(pose_at(-3.0, 4.0, quaternion(-2.5))));
  EXPECT_EQ(counted().taken, 3u);
  const Pose2 to = commands.wishes().goal.value();
  EXPECT_EQ(to.position(), Point2(1.0, -2.0));
  EXPECT_NEAR(to.yaw, 0.5, 1e-12);
  const Pose2 at = commands.initial_pose().value();
  EXPECT_EQ(at.position(), Point2(-3.0, 4.0));
  EXPECT_NEAR(at.yaw, -2.5, 1e-12);
  expect_nothing_wanted();
}

TEST_F(CommandsTest, TakesARotationThatIsRoundedAndRefusesWhatIsNone) {
  Quaternion rounded = quaternion(1.0);
  rounded.z *= 1.01;
  rounded.w *= 1.01;
  commands.take_goal(goal(pose_at(0.0, 0.0, rounded)));
  expect_taken();
  EXPECT_NEAR(commands.wishes().goal.value().yaw, 1.0, 1e-9);
  for (const Quaternion& bad :
       {Quaternion{0.0, 0.0, 0.0, 0.0}, Quaternion{0.0, 0.0, kNan, 1.0}, Quaternion{0.0, 0.0, 1e200, 1e200}}) {
    commands.take_goal(goal(pose_at(0.0, 0.0, bad)));
    expect_out_of_range();
    commands.take_initial_pose(initial_pose(pose_at(0.0, 0.0, bad)));
    expect_out_of_range();
  }
  expect_nothing_wanted();
}

TEST_F(CommandsTest, RefusesPlacesThatAreNoneOrFarFromEverything) {
  for (const double bad : {kNan, kInfinity, -100.5, -1e6, 1e300}) {
    commands.take_goal(goal(pose_at(bad, 0.0, quaternion(0.0))));
    expect_out_of_range();
    commands.take_goal(goal(pose_at(0.0, bad, quaternion(0.0))));
    expect_out_of_range();
    commands.take_initial_pose(initial_pose(pose_at(bad, bad, quaternion(0.0))));
    expect_out_of_range();
    Pose high = pose_at(0.0, 0.0, quaternion(0.0));
    high.position.z = bad;
    commands.take_goal(goal(high));
    expect_out_of_range();
  }
  expect_nothing_wanted();
}

TEST_F(CommandsTest, RefusesAPlaceWhoseCovarianceIsNone) {
  for (const double bad : {kNan, kInfinity}) {
    commands.take_initial_pose(initial_pose(pose_at(0.0, 0.0, quaternion(0.0)), "map", bad));
    expect_out_of_range();
  }
  expect_nothing_wanted();
}

TEST_F(CommandsTest, TakesPosesInTheMapsFrameAlone) {
  const Pose pose = pose_at(1.0, 2.0, quaternion(0.0));
  commands.take_goal(goal(pose, "/map"));
  expect_taken();
  commands.take_initial_pose(initial_pose(pose, "/map"));
  expect_taken();
  forget();
  for (const char* frame : {"odom", "base_link", "", "/", "//map", "maps", "Map"}) {
    SCOPED_TRACE(frame);
    commands.take_goal(goal(pose, frame));
    expect_other_frame();
    commands.take_initial_pose(initial_pose(pose, frame));
    expect_other_frame();
  }
  expect_nothing_wanted();
}

TEST(CommandsTellTest, TellsOnceOfPosesInOtherFrames) {
  std::vector<std::string> told;
  Commands commands(kLimits, [&](const std::string& line) { told.push_back(line); });
  const Pose pose = pose_at(1.0, 2.0, quaternion(0.0));
  commands.take_goal(goal(pose));
  EXPECT_THAT(told, IsEmpty());
  for (int i = 0; i < 10; ++i) {
    commands.take_goal(goal(pose, "odom"));
    commands.take_initial_pose(initial_pose(pose, "odom"));
  }
  EXPECT_THAT(told, ElementsAre("goal_pose: refused a pose that isn't in the frame map; want that for its frame_id (in "
                                "rviz, for the Fixed Frame)"));
}

TEST_F(CommandsTest, SaysWhichOfGoalAndVelocityIsNewer) {
  commands.take_goal(goal(pose_at(1.0, 0.0, quaternion(0.0))));
  commands.take_twist(twist(0.1, 0.0));
  EXPECT_FALSE(commands.wishes().goal_is_newer);
  commands.take_twist_stamped(twist_stamped(0.1, 0.0));
  commands.take_goal(goal(pose_at(1.0, 0.0, quaternion(0.0))));
  const Wishes wishes = commands.wishes();
  EXPECT_TRUE(wishes.goal && wishes.velocity && wishes.goal_is_newer);
}

TEST_F(CommandsTest, WhatWasWantedBeforeTheDockIsOver) {
  commands.take_goal(goal(pose_at(1.0, 0.0, quaternion(0.0))));
  commands.take_twist(twist(0.1, 0.0));
  commands.take_dock(encode(Empty{}));
  const Wishes before = commands.wishes();
  EXPECT_TRUE(before.dock);
  EXPECT_FALSE(before.goal);
  EXPECT_FALSE(before.velocity);
  commands.take_dock(encode(Empty{}));
  commands.take_twist(twist(0.1, 0.0));
  const Wishes behind = commands.wishes();
  EXPECT_TRUE(behind.dock);
  EXPECT_EQ(behind.velocity, (Motion{0.1, 0.0}));
}

TEST_F(CommandsTest, OrdersTheWayToTheDockAndControlAgain) {
  commands.take_dock(encode(Empty{}));
  commands.take_undock(encode(Empty{}));
  EXPECT_THAT(as_bytes(orders()), ElementsAre(ElementsAre(143), ElementsAre(131)));
  EXPECT_EQ(counted().taken, 2u);
}

TEST_F(CommandsTest, OrdersSongsInTicksOfTheRobot) {
  commands.take_song(song(3, 3, {60, 62, 30}, {1.0F, 0.25F, 0.008F}));
  commands.take_play(encode(PlaySong{3}));
  EXPECT_THAT(as_bytes(orders()), ElementsAre(ElementsAre(140, 3, 3, 60, 64, 62, 16, 30, 1), ElementsAre(141, 3)));
  EXPECT_EQ(counted().taken, 2u);
}

TEST_F(CommandsTest, TakesOnlyAsManyNotesAsTheSongSaysThatItHas) {
  commands.take_song(song(0, 1, {60, 61, 62}, {0.5F, 0.5F}));
  EXPECT_THAT(as_bytes(orders()), ElementsAre(ElementsAre(140, 0, 1, 60, 32)));
}

TEST_F(CommandsTest, TakesTheLongestSongAndTheLongestNote) {
  commands.take_song(song(15, 16, std::vector<std::uint8_t>(16, 127), std::vector<float>(16, 255.0F / 64.0F)));
  expect_taken();
  const auto bytes = as_bytes(orders());
  ASSERT_THAT(bytes, SizeIs(1));
  EXPECT_THAT(bytes[0], SizeIs(3 + 2 * 16));
  EXPECT_EQ(bytes[0].back(), 255);
}

TEST_F(CommandsTest, RefusesSongsThatNoRobotHas) {
  const std::vector<std::uint8_t> notes(20, 60);
  const std::vector<float> durations(20, 0.5F);
  const auto refused = [&](const Bytes& bytes) {
    commands.take_song(bytes);
    expect_out_of_range();
  };
  refused(song(16, 1, notes, durations));
  refused(song(255, 1, notes, durations));
  refused(song(0, 0, notes, durations));
  refused(song(0, 17, notes, durations));
  refused(song(0, 2, {60}, durations));
  refused(song(0, 2, notes, {0.5F}));
  refused(song(0, 1, {}, {}));
  for (const float bad : {4.0F, -0.1F, 1e30F, std::numeric_limits<float>::quiet_NaN(),
                          std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()}) {
    refused(song(0, 2, notes, {0.5F, bad}));
  }
  commands.take_play(encode(PlaySong{16}));
  expect_out_of_range();
  expect_nothing_wanted();
}

TEST_F(CommandsTest, JoinsTheLightsThatAreTurnedOnOneByOne) {
  commands.take_led(oi::Leds::kDebris, encode(Bool{true}));
  commands.take_led(oi::Leds::kCheckRobot, encode(Bool{true}));
  commands.take_power_led(octets({128, 64}));
  commands.take_led(oi::Leds::kDebris, encode(Bool{false}));
  commands.take_power_led(octets({7}));
  EXPECT_THAT(as_bytes(orders()),
              ElementsAre(ElementsAre(139, 1, 0, 255), ElementsAre(139, 9, 0, 255), ElementsAre(139, 9, 128, 64),
                          ElementsAre(139, 8, 128, 64), ElementsAre(139, 8, 7, 64)));
  EXPECT_EQ(counted().taken, 5u);
  commands.take_power_led(octets({}));
  expect_out_of_range();
  expect_nothing_wanted();
}

TEST_F(CommandsTest, LightsFromManyThreadsAllCountInTheEnd) {
  for (int round = 0; round < 200; ++round) {
    Commands lights(kLimits);
    std::vector<std::jthread> writers;
    for (const auto bit : {oi::Leds::kDebris, oi::Leds::kSpot, oi::Leds::kDock, oi::Leds::kCheckRobot}) {
      writers.emplace_back([&lights, bit] { lights.take_led(bit, encode(Bool{true})); });
    }
    writers.clear();
    const auto bytes = as_bytes(all_orders(lights));
    ASSERT_THAT(bytes, SizeIs(4));
    EXPECT_EQ(bytes.back().at(1), 15) << "the last order has what all of them asked for";
  }
}

TEST_F(CommandsTest, ShowsUpToFourCharacters) {
  commands.take_digits(octets({'A'}));
  commands.take_digits(octets({'1', '2', ':', '~'}));
  EXPECT_THAT(as_bytes(orders()),
              ElementsAre(ElementsAre(164, 'A', ' ', ' ', ' '), ElementsAre(164, '1', '2', ':', '~')));
  EXPECT_EQ(counted().taken, 2u);
  for (const std::vector<std::uint8_t>& bad :
       {std::vector<std::uint8_t>{}, {'1', '2', '3', '4', '5'}, {31}, {'a', 127}, {255}}) {
    commands.take_digits(octets(bad));
    expect_out_of_range();
  }
  expect_nothing_wanted();
}

TEST_F(CommandsTest, KeepsNoMoreThan32OrdersAndTheFirstOfThem) {
  for (std::uint8_t i = 0; i < 40; ++i) commands.take_play(encode(PlaySong{static_cast<std::uint8_t>(i % 16)}));
  const CommandTally tally = counted();
  EXPECT_EQ(tally.taken, 32u);
  EXPECT_EQ(tally.out_of_range, 8u);
  const auto bytes = as_bytes(orders());
  ASSERT_THAT(bytes, SizeIs(32));
  for (int i = 0; i < 32; ++i) EXPECT_THAT(bytes[static_cast<std::size_t>(i)], ElementsAre(141, i % 16));
  commands.take_play(encode(PlaySong{1}));
  EXPECT_THAT(orders(), SizeIs(1)) << "there is room again";
}

TEST_F(CommandsTest, ALightThatIsRefusedDoesNotComeOnLater) {
  for (int i = 0; i < 32; ++i) commands.take_play(encode(PlaySong{0}));
  commands.take_led(oi::Leds::kSpot, encode(Bool{true}));
  EXPECT_EQ(counted().out_of_range, 1u);
  EXPECT_THAT(orders(), SizeIs(32));
  commands.take_led(oi::Leds::kDock, encode(Bool{true}));
  EXPECT_THAT(as_bytes(orders()), ElementsAre(ElementsAre(139, 4, 0, 255)));
}

}  // namespace
}  // namespace scrubjay::ros
