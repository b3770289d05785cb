#include <scrubjay/ros2/ordered_robot.hpp>

#include "ros2/commands_fixture.hpp"

namespace scrubjay::ros {
namespace {

/// Keeps what it is ordered.
struct Listening final : Robot {
  std::optional<Frame> next() override { return Frame{}; }
  void drive(const Motion&) override {}
  bool order(const oi::Command& command) override {
    ordered.push_back(command);
    return true;
  }
  void stop() override {}

  std::vector<oi::Command> ordered;
};

TEST(OrderedRobotTest, HandsOnOneOrderAFrameSoThatTheWheelsAreHeardBetween) {
  Listening robot;
  Commands commands(kLimits);
  OrderedRobot ordered(robot, commands);
  for (std::uint8_t i = 0; i < 3; ++i) commands.take_play(encode(PlaySong{i}));
  for (std::size_t frames = 1; frames <= 5; ++frames) {
    EXPECT_TRUE(ordered.next());
    EXPECT_EQ(robot.ordered.size(), std::min<std::size_t>(frames, 3));
  }
  EXPECT_EQ(as_bytes(robot.ordered), (std::vector<std::vector<int>>{{141, 0}, {141, 1}, {141, 2}}));
}

}  // namespace
}  // namespace scrubjay::ros
