#include <gtest/gtest.h>

#include <scrubjay/io/hand_check.hpp>

namespace scrubjay {
namespace {

using oi::PacketId;

/// Hands on a robot of which each frame comes 15 ms after the one before.
class HandCheckTest : public testing::Test {
 protected:
  HandCheckTest() { sensors_.set(PacketId::LeftEncoderCounts, 32700); }
  void frames(HandCheck& check, int count) {
    for (int i = 0; i < count; ++i) check.update(sensors_, stamp_ += 0.015);
  }
  void shell(HandCheck& check, int bits) {
    sensors_.set(PacketId::BumpsAndWheelDrops, bits);
    frames(check, 5);
  }
  void press(HandCheck& check, int bits) {
    shell(check, 0);
    shell(check, bits);
    shell(check, 0);
  }
  /// Turns the wheels by these counts, forward or backward, in steps that a hand makes.
  void turn(HandCheck& check, int left, int right) {
    for (int i = 0; i < 50; ++i) {
      left_ += left;
      right_ += right;
      sensors_.set(PacketId::LeftEncoderCounts, static_cast<std::int16_t>(left_ / 50));
      sensors_.set(PacketId::RightEncoderCounts, static_cast<std::int16_t>(right_ / 50));
      frames(check, 1);
    }
  }

  oi::Sensors sensors_;
  double stamp_ = 100.0;
  int left_ = 32700 * 50;  // shortly before they wrap around
  int right_ = 0;
};

TEST_F(HandCheckTest, IsDoneWhenTheRobotFeltEverything) {
  HandCheck check(oi::Model::Create2);
  press(check, 0b10);
  EXPECT_EQ(check.step(), HandStep::BumpRight);
  press(check, 0b01);
  EXPECT_EQ(check.step(), HandStep::Lift);
  shell(check, 0b1100);
  EXPECT_EQ(check.step(), HandStep::TurnLeft);
  turn(check, 250, 0);
  EXPECT_EQ(check.step(), HandStep::TurnRight);
  turn(check, 0, -250);
  ASSERT_TRUE(check.done());
  for (std::size_t i = 0; i < kHandSteps; ++i) EXPECT_EQ(check.result(static_cast<HandStep>(i)), HandResult::Felt) << i;
}

TEST_F(HandCheckTest, ABumperThatIsStuckIsNotFelt) {
  HandCheck check(oi::Model::Create2, 3.0);
  shell(check, 0b10);
  frames(check, 250);
  EXPECT_EQ(check.result(HandStep::BumpLeft), HandResult::NotFelt);
}

TEST_F(HandCheckTest, ABumperThatIsNotLetGoIsNotFeltYet) {
  HandCheck check(oi::Model::Create2);
  shell(check, 0);
  shell(check, 0b10);
  EXPECT_EQ(check.step(), HandStep::BumpLeft);
}

TEST_F(HandCheckTest, TellsThatTheOtherSideAnswers) {
  HandCheck check(oi::Model::Create2, 3.0);
  press(check, 0b01);
  frames(check, 250);
  EXPECT_EQ(check.result(HandStep::BumpLeft), HandResult::OtherSide);
  check.skip();  // bumper right
  check.skip();  // lift
  turn(check, 0, 250);
  frames(check, 250);
  EXPECT_EQ(check.result(HandStep::TurnLeft), HandResult::OtherSide);
}

TEST_F(HandCheckTest, APalmOnBothHalvesPassesEither) {
  HandCheck check(oi::Model::Create2);
  press(check, 0b11);
  EXPECT_EQ(check.result(HandStep::BumpLeft), HandResult::Felt);
}

TEST_F(HandCheckTest, OneWheelIsNotLifted) {
  HandCheck check(oi::Model::Create2, 3.0);
  check.skip();
  check.skip();
  shell(check, 0b0100);
  frames(check, 250);
  EXPECT_EQ(check.result(HandStep::Lift), HandResult::NotFelt);
}

TEST_F(HandCheckTest, WaitsForEachStepAnewAndThenGoesOn) {
  HandCheck check(oi::Model::Create2, 3.0);
  frames(check, 190);
  EXPECT_EQ(check.step(), HandStep::BumpLeft);
  frames(check, 5 * 205 - 190);
  EXPECT_TRUE(check.done());
}

TEST_F(HandCheckTest, FeelsWheelsWithoutEncodersByDistanceAndAngle) {
  HandCheck check(oi::Model::Create1);
  for (int i = 0; i < 3; ++i) check.skip();
  // The left wheel alone: half of its way forward, and a turn to the right.
  sensors_.set(PacketId::Distance, 2);
  sensors_.set(PacketId::Angle, -1);
  frames(check, 30);
  EXPECT_EQ(check.result(HandStep::TurnLeft), HandResult::Felt);
}

}  // namespace
}  // namespace scrubjay
