#include <gmock/gmock.h>

#include <scrubjay/mission/paced_robot.hpp>

#include "fakes.hpp"

namespace scrubjay::test {
namespace {

TEST(PacedRobotTest, HandsOnEveryFrameAndTheEnd) {
  FakeRobot robot(100);
  PacedRobot paced(robot, 1e6);
  for (int i = 0; i < 100; ++i) {
    const auto frame = paced.next();
    ASSERT_TRUE(frame.has_value());
    EXPECT_DOUBLE_EQ(frame->stamp, 100.0 + kTick * i);
  }
  EXPECT_FALSE(paced.next().has_value());
}

TEST(PacedRobotTest, HandsOnMotionsAndTheStop) {
  FakeRobot robot(1);
  PacedRobot paced(robot, 1.0);
  paced.drive({0.1, 0.2});
  paced.stop();
  EXPECT_THAT(robot.motions, ::testing::ElementsAre(Motion{0.1, 0.2}));
  EXPECT_EQ(robot.stops, 1);
}

TEST(PacedRobotTest, HandsOnOrdersAndWhatBecameOfThem) {
  FakeRobot robot(1);
  PacedRobot paced(robot, 1.0);
  EXPECT_TRUE(paced.order(oi::SeekDock{}));
  EXPECT_EQ(robot.orders, 1);
  robot.obeys = false;
  EXPECT_FALSE(paced.order(oi::SeekDock{}));
}

TEST(PacedRobotTest, NoFrameComesBeforeItsTime) {
  FakeRobot robot(21);
  const auto begin = std::chrono::steady_clock::now();
  PacedRobot paced(robot, 10.0);
  while (paced.next()) {
  }
  // The last frame is 0.3 s after the first.
  EXPECT_GE(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(30));
}

}  // namespace
}  // namespace scrubjay::test
