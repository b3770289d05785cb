#include <gmock/gmock.h>

#include <scrubjay/mission/mission.hpp>

#include "fakes.hpp"

namespace scrubjay::test {
namespace {

/// A mission of fakes.
struct Rig {
  explicit Rig(FakeRobot robot_, int last = 1'000'000, const Limits& limits = {})
      : robot(std::move(robot_)), behavior(last), mission(robot, localizer, mapper, behavior, limits) {
    mission.watch(observer);
  }
  Report run() { return mission.run({}); }

  FakeRobot robot;
  FakeLocalizer localizer;
  FakeMapper mapper;
  FakeBehavior behavior;
  FakeObserver observer;
  Mission mission;
};

TEST(MissionTest, EndsWhenTheBehaviorIsDone) {
  Rig rig(FakeRobot(100), 10);
  const Report report = rig.run();
  EXPECT_EQ(report.ended, Ended::Done);
  EXPECT_EQ(rig.robot.given, 10);
  EXPECT_TRUE(rig.observer.done) << "observers see the last tick";
}

TEST(MissionTest, EndsWhenItsTimeIsUp) {
  Rig rig(FakeRobot(1000), 1'000'000, {.max_time = 1.5});
  const Report report = rig.run();
  EXPECT_EQ(report.ended, Ended::TimeLimit);
  EXPECT_NEAR(report.time, 1.5, kTick);
  EXPECT_GE(report.time, 1.5 - 1e-9);
}

TEST(MissionTest, EndsWhenItIsAskedTo) {
  Rig rig(FakeRobot(1000));
  std::stop_source source;
  rig.observer.act = [&](const Snapshot& now) {
    if (now.frame.stamp >= 100.0 + 20 * kTick - 1e-9) source.request_stop();
  };
  const Report report = rig.mission.run(source.get_token());
  EXPECT_EQ(report.ended, Ended::Stopped);
  EXPECT_EQ(rig.robot.given, 21);
}

TEST(MissionTest, EndsAtOnceWhenItWasAskedToBefore) {
  Rig rig(FakeRobot(1000));
  std::stop_source source;
  source.request_stop();
  EXPECT_EQ(rig.mission.run(source.get_token()).ended, Ended::Stopped);
  EXPECT_EQ(rig.robot.given, 1);
  EXPECT_TRUE(rig.robot.motions.empty());
}

TEST(MissionTest, EndsWhenTheRobotIsStuck) {
  Rig rig(FakeRobot(10'000, [](int i, Frame& frame) {
    if (i < 100) frame.left_travel = frame.right_travel = 0.01;
    frame.bump_left = i >= 100;
  }));
  const Report report = rig.run();
  EXPECT_EQ(report.ended, Ended::Stuck);
  ASSERT_TRUE(report.stuck.has_value());
  EXPECT_NEAR(report.stuck->x(), 1.0, 1e-9);
  EXPECT_NEAR(report.time, 100 * kTick + StuckParams().patience, 0.1);
}

TEST(MissionTest, EndsWhenTheRobotIsGone) {
  Rig rig(FakeRobot(50));
  const Report report = rig.run();
  EXPECT_EQ(report.ended, Ended::RobotGone);
  EXPECT_EQ(rig.observer.stamps.size(), 50u);
}

TEST(MissionTest, EndsWithARobotThatNeverAnswered) {
  Rig rig{FakeRobot(0)};
  const Report report = rig.run();
  EXPECT_EQ(report.ended, Ended::RobotGone);
  EXPECT_EQ(report.time, 0.0);
  EXPECT_EQ(rig.robot.stops, 1);
}

TEST(MissionTest, IsStoppedWhereTheRobotWasSilentWhenItWasAskedTo) {
  Rig rig{FakeRobot(0)};
  std::stop_source source;
  source.request_stop();
  EXPECT_EQ(rig.mission.run(source.get_token()).ended, Ended::Stopped);
}

TEST(MissionTest, LeavesTheRobotStandingHoweverItEnds) {
  const auto held = [](int, Frame& frame) { frame.bump_left = true; };
  Rig done(FakeRobot(100), 10);
  Rig late(FakeRobot(1000), 1'000'000, {.max_time = 1.0});
  Rig stuck(FakeRobot(10'000, held));
  Rig gone(FakeRobot(50));
  for (Rig* rig : {&done, &late, &stuck, &gone}) {
    rig->run();
    EXPECT_EQ(rig->robot.stops, 1);
    EXPECT_EQ(rig->robot.motions.size(), rig->robot.motions_before_stop) << "nothing comes after the stop";
  }
}

TEST(MissionTest, DrivesTellsAndMapsEveryTick) {
  Rig rig(FakeRobot(100), 80);
  FakeObserver second;
  rig.mission.watch(second);
  rig.run();
  EXPECT_EQ(rig.mapper.updates, 80);
  EXPECT_EQ(rig.behavior.decisions, 80);
  EXPECT_EQ(rig.robot.motions.size(), 79u) << "the last decision is to end";
  EXPECT_EQ(rig.robot.motions.front(), (Motion{0.1, 0.0}));
  ASSERT_EQ(rig.observer.stamps.size(), 80u);
  EXPECT_EQ(second.stamps, rig.observer.stamps);
  for (std::size_t i = 0; i < 80; ++i) EXPECT_DOUBLE_EQ(rig.observer.stamps[i], 100.0 + kTick * static_cast<double>(i));
}

TEST(MissionTest, ReportsTimeDistanceBumpsAndPose) {
  Rig rig(FakeRobot(101, [](int i, Frame& frame) {
    frame.left_travel = frame.right_travel = i < 50 ? 0.002 : -0.001;
    frame.bump_left = (i >= 10 && i < 15) || i == 30;
    frame.bump_right = i >= 12 && i < 18;
  }));
  const Report report = rig.run();
  EXPECT_EQ(report.frames, 101u);
  EXPECT_NEAR(report.time, 100 * kTick, 1e-9);
  EXPECT_NEAR(report.distance, 50 * 0.002 + 51 * 0.001, 1e-12) << "backwards counts as well";
  EXPECT_EQ(report.bumps, 2u);
  EXPECT_NEAR(report.pose.x, 50 * 0.002 - 51 * 0.001, 1e-12);
  EXPECT_FALSE(report.stuck.has_value());
}

TEST(MissionTest, ABumpOnTheWayIsNotStuck) {
  Rig rig(FakeRobot(5000, [](int i, Frame& frame) {
    frame.bump_left = i % 200 < 20;
    frame.left_travel = frame.right_travel = 0.0001;
  }));
  EXPECT_EQ(rig.run().ended, Ended::RobotGone);
}

TEST(MissionTest, EachEndHasItsName) {
  EXPECT_EQ(to_string(Ended::Done), "done");
  EXPECT_EQ(to_string(Ended::TimeLimit), "time limit");
  EXPECT_EQ(to_string(Ended::Stopped), "stopped");
  EXPECT_EQ(to_string(Ended::Stuck), "stuck");
  EXPECT_EQ(to_string(Ended::RobotGone), "robot gone");
  EXPECT_EQ(to_string(Ended::EndOfRecording), "end of the recording");
}

TEST(MissionTest, CountsTheWayOfOwnOdometryToo) {
  // A metre along x, then back again, starting anywhere; and its wheels say nothing.
  Rig rig(FakeRobot(21, [](int i, Frame& frame) {
    frame.odometry = Pose2{5.0 + 0.1 * (10 - std::abs(10 - i)), 2.0, 1.0};
  }));
  EXPECT_NEAR(rig.run().distance, 2.0, 1e-12);
}

}  // namespace
}  // namespace scrubjay::test
