#include <gtest/gtest.h>

#include <scrubjay/robot/frame_maker.hpp>

#include "scripted_channel.hpp"

namespace scrubjay {
namespace {

using oi::PacketId;

const double kCount = DifferentialDrive{}.metres_per_count();

/// What a frame maker makes of one reading after another.
class Readings {
 public:
  explicit Readings(oi::Model protocol = oi::Model::Create2, const oi::FirmwareQuirks& quirks = {})
      : maker_(speaking(protocol), quirks) {}

  Frame make(const oi::Sensors& sensors, double elapsed = kTick, const ToldSpeeds& told = {}) {
    stamp_ += elapsed;
    return maker_.make(sensors, stamp_, elapsed, told);
  }
  /// Counts that the left wheel is said to have turned, by a reading of both encoders.
  double left(int count, double elapsed = kTick, double told = 0.0) {
    return make(counted(count, count), elapsed, {told, told}).left_travel / kCount;
  }

 private:
  static RobotModel speaking(oi::Model protocol) {
    RobotModel model;
    model.protocol = protocol;
    return model;
  }

  FrameMaker maker_;
  double stamp_ = 100.0;
};

TEST(FrameMakerTest, CountsFromTheFirstReadingOnWhateverItIs) {
  for (const int begin : {0, 7, -1, 12'345, -32'768}) {
    Readings readings;
    const Frame first = readings.make(counted(begin, begin));
    EXPECT_EQ(first.left_travel, 0.0);
    EXPECT_EQ(first.right_travel, 0.0);
    const Frame next = readings.make(counted(begin + 3, begin + 4));
    EXPECT_DOUBLE_EQ(next.left_travel, 3 * kCount);
    EXPECT_DOUBLE_EQ(next.right_travel, 4 * kCount);
  }
}

TEST(FrameMakerTest, ASilenceBeforeTheFirstReadingIsNoRestart) {
  for (const int begin : {20'000, 300}) {
    Readings readings;
    EXPECT_EQ(readings.left(begin, 60.0), 0.0);
    EXPECT_NEAR(readings.left(begin + 7), 7.0, 1e-9);
  }
}

TEST(FrameMakerTest, StampsAFrameAsTheReading) {
  FrameMaker maker({});
  EXPECT_EQ(maker.make(at_rest(), 12.25, kTick, {}).stamp, 12.25);
}

TEST(FrameMakerTest, AStepIsAsLongAsALateFrameAtTwiceFullSpeedAtMost) {
  // 1 m/s over 115 ms is 258 counts.
  for (const int way : {250, -250}) {
    Readings readings;
    readings.left(1000);
    EXPECT_NEAR(readings.left(1000 + way), way, 1e-9);
  }
  for (const int way : {270, -270, 20'000}) {
    Readings readings;
    readings.left(1000);
    EXPECT_EQ(readings.left(1000 + way), 0.0);
  }
}

TEST(FrameMakerTest, EachWheelIsBelievedOrNotByItself) {
  Readings readings;
  readings.make(counted(1000, 1000));
  const Frame frame = readings.make(counted(1005, 9000));
  EXPECT_DOUBLE_EQ(frame.left_travel, 5 * kCount);
  EXPECT_EQ(frame.right_travel, 0.0);
  const Frame next = readings.make(counted(1010, 1011));
  EXPECT_NEAR(next.left_travel / kCount, 5.0, 1e-9);
  EXPECT_NEAR(next.right_travel / kCount, 11.0, 1e-9) << "9000 was false";
}

TEST(FrameMakerTest, AFalseCountCostsNoWayWhetherItWasBelievedOrNot) {
  for (const int false_count : {1200, 9000, -9000}) {
    Readings readings;
    readings.left(1000);
    const double way = readings.left(false_count) + readings.left(1010) + readings.left(1015);
    EXPECT_NEAR(way, 15.0, 1e-9) << false_count;
  }
}

TEST(FrameMakerTest, TheWayOfAGapCounts) {
  // 1 m/s over 0.5 s and 100 ms is 1350 counts.
  Readings readings;
  readings.left(1000);
  EXPECT_NEAR(readings.left(2300, 0.5), 1300.0, 1e-9);
  Readings slower;
  slower.left(1000);
  EXPECT_EQ(slower.left(2400, 0.5), 0.0);
}

TEST(FrameMakerTest, TheWayOfAGapMayComeWithAFrameSoonAfterIt) {
  // What was held up on the wire comes first behind a gap, and only then what was sent since.
  Readings readings;
  readings.left(1000);
  readings.left(1001, 0.5);
  EXPECT_NEAR(readings.left(1002), 1.0, 1e-9);
  EXPECT_NEAR(readings.left(2202), 1200.0, 1e-9);

  Readings later;
  later.left(1000);
  later.left(1001, 0.5);
  for (int i = 0; i < 20; ++i) later.left(1001);
  EXPECT_EQ(later.left(2201), 0.0) << "0.3 s behind the gap";
  later.left(1001);
  later.left(1001, 0.5);
  EXPECT_NEAR(later.left(2201), 1200.0, 1e-9) << "another gap";
}

TEST(FrameMakerTest, ARobotThatWasOffAndOnAgainCountsFromItsStart) {
  Readings readings;
  readings.make(counted(20'000, 21'000));
  const Frame frame = readings.make(counted(30, -40), 3.0);
  EXPECT_DOUBLE_EQ(frame.left_travel, 30 * kCount);
  EXPECT_DOUBLE_EQ(frame.right_travel, -40 * kCount);
  EXPECT_NEAR(readings.left(33), 3.0, 1e-9);
}

TEST(FrameMakerTest, NoCountOfBeforeARestartIsTakenBackBehindIt) {
  Readings readings;
  readings.left(20'000);
  EXPECT_EQ(readings.left(29'000), 0.0);
  EXPECT_NEAR(readings.left(30, 3.0), 30.0, 1e-9);
  EXPECT_EQ(readings.left(-8960), 0.0);
  EXPECT_NEAR(readings.left(33), 3.0, 1e-9);
}

TEST(FrameMakerTest, NoRobotIsOffAndOnAgainWithinTwoSeconds) {
  Readings readings;
  readings.left(20'000);
  EXPECT_EQ(readings.left(30, 1.9), 0.0);
}

TEST(FrameMakerTest, OneWheelNearZeroIsNoRestart) {
  Readings readings;
  readings.make(counted(20, 20'000));
  const Frame frame = readings.make(counted(10, 20'007), 3.0);
  EXPECT_DOUBLE_EQ(frame.left_travel, -10 * kCount);
  EXPECT_DOUBLE_EQ(frame.right_travel, 7 * kCount);
}

TEST(FrameMakerTest, AfterALongSilenceAStepMustFitWhatTheWheelsWereTold) {
  // Half as far again as 0.2 m/s takes in 3 s, and 0.2 m more: 1.1 m, 2474 counts; backwards 0.2 m, 449 counts.
  const auto way = [](int step, double told) {
    Readings readings;
    readings.left(5000);
    return readings.left(5000 + step, 3.0, told);
  };
  EXPECT_NEAR(way(2400, 0.2), 2400.0, 1e-9);
  EXPECT_EQ(way(2550, 0.2), 0.0);
  EXPECT_NEAR(way(-440, 0.2), -440.0, 1e-9);
  EXPECT_EQ(way(-460, 0.2), 0.0);
  EXPECT_NEAR(way(-2400, -0.2), -2400.0, 1e-9);
  EXPECT_EQ(way(2400, -0.2), 0.0);
  EXPECT_NEAR(way(-440, -0.2), -440.0, 1e-9) << "it hardly got on";
  EXPECT_NEAR(way(440, 0.0), 440.0, 1e-9) << "it was pushed";
  EXPECT_EQ(way(2400, 0.0), 0.0);
}

TEST(FrameMakerTest, ACounterThatBeganAnewElsewhereIsTakenAsItIs) {
  Readings readings;
  readings.left(20'000);
  EXPECT_EQ(readings.left(5000, 3.0), 0.0);
  // Its first count was right: one that is as far back is false.
  EXPECT_EQ(readings.left(20'010), 0.0);
  EXPECT_NEAR(readings.left(5010), 10.0, 1e-9);
}

TEST(FrameMakerTest, MeasuresMillimetresAndDegreesWhereThereAreNoEncoders) {
  Readings readings(oi::Model::Create1);
  const Frame first = readings.make(measured(40, 5));
  EXPECT_EQ(first.left_travel, 0.0) << "since it was asked before, whenever that was";
  const Frame frame = readings.make(measured(10, 2));
  const double half_turn = 0.5 * DifferentialDrive{}.wheel_separation * radians(2.0);
  EXPECT_NEAR(frame.left_travel, 0.010 - half_turn, 1e-12);
  EXPECT_NEAR(frame.right_travel, 0.010 + half_turn, 1e-12);
}

TEST(FrameMakerTest, AMeasureThatEitherWheelCannotHaveMadeIsNone) {
  Readings readings(oi::Model::Create1);
  readings.make(measured(0, 0));
  for (const auto& [distance, angle] : {std::pair(200, 0), std::pair(100, 60), std::pair(100, -60)}) {
    const Frame jump = readings.make(measured(distance, angle));
    EXPECT_EQ(jump.left_travel, 0.0);
    EXPECT_EQ(jump.right_travel, 0.0);
  }
}

TEST(FrameMakerTest, ARoomba400TellsHalfTheWheelsDifferenceAsItsAngle) {
  Readings readings(oi::Model::Roomba400);
  readings.make(measured(0, 0));
  const Frame frame = readings.make(measured(10, 3));
  EXPECT_NEAR(frame.left_travel, 0.007, 1e-12);
  EXPECT_NEAR(frame.right_travel, 0.013, 1e-12);
}

TEST(FrameMakerTest, ADistanceThatTheFirmwareGetsWrongIsNone) {
  Readings readings(oi::Model::Create1, {.distance_wrong = true});
  readings.make(measured(0, 0));
  const Frame frame = readings.make(measured(50, 2));
  EXPECT_DOUBLE_EQ(frame.left_travel, -frame.right_travel);
  EXPECT_GT(frame.right_travel, 0.0);
}

TEST(FrameMakerTest, MeasuresOfALongSilenceMustFitWhatTheWheelsWereTold) {
  Readings readings(oi::Model::Create1);
  readings.make(measured(0, 0));
  EXPECT_NEAR(readings.make(measured(600, 0), 3.0, {0.2, 0.2}).left_travel, 0.6, 1e-12);
  EXPECT_EQ(readings.make(measured(600, 0), 3.0).left_travel, 0.0);
}

TEST(FrameMakerTest, FollowsTheModeThroughWhatTheFirmwareMakesOfIt) {
  const auto mode = [](int reported, const oi::FirmwareQuirks& quirks) {
    oi::Sensors sensors;
    sensors.set(PacketId::OiMode, reported);
    return Readings(oi::Model::Create2, quirks).make(sensors).mode;
  };
  EXPECT_EQ(mode(1, {}), oi::OiMode::Passive);
  EXPECT_EQ(mode(3, {}), oi::OiMode::Full);
  EXPECT_EQ(mode(2, {.mode_one_too_high = true}), oi::OiMode::Passive);
  EXPECT_EQ(mode(0, {.mode_one_too_high = true}), oi::OiMode::Off) << "no mode at all";
}

TEST(FrameMakerTest, NoInfraredCharacterIsZeroInEveryDialect) {
  oi::Sensors sensors = at_rest();
  sensors.set(PacketId::InfraredCharacterOmni, 255);
  EXPECT_EQ(Readings(oi::Model::Create1).make(sensors).infrared_omni, 0);
  EXPECT_EQ(Readings(oi::Model::Roomba400).make(sensors).infrared_omni, 0);
  EXPECT_EQ(Readings(oi::Model::Create2).make(sensors).infrared_omni, 255);
}

}  // namespace
}  // namespace scrubjay
