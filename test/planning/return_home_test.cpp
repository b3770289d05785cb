#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <scrubjay/planning/return_home.hpp>
#include <string>
#include <vector>

#include "planning/house.hpp"

namespace scrubjay {
namespace {

using test::House;
using test::MapDrawing;

/// Drives somewhere and is done, with one thing left.
class Errand final : public Behavior {
 public:
  Errand(const RobotModel& robot, const Point2& goal) : costs_(params(robot)), navigator_(robot) {
    navigator_.go_to(goal);
  }
  Decision decide(const Situation& now) override {
    const CellRect changed = costs_.update(now.map, now.changed);
    const Navigator::Step step = navigator_.step(now, costs_.view(), changed);
    return {step.motion, "errand", step.travel != Travel::Driving};
  }
  std::span<const Leftover> leftovers() const override { return {&left_, 1}; }

 private:
  static CostMapParams params(const RobotModel& robot) {
    CostMapParams params;
    params.radius = robot.radius;
    return params;
  }
  CostMap costs_;
  Navigator navigator_;
  Leftover left_{{9.0, 9.0}, 1.0, "too narrow"};
};

struct Homecoming {
  bool done = false;
  Decision last;
  bool went_home = false;
};

template <typename Meddle>
Homecoming run(House& house, ReturnHome& behavior, Meddle&& meddle) {
  Homecoming result;
  while (!result.done && house.stamp() < 300.0) {
    house.tick([&](const Situation& now) {
      result.last = behavior.decide(now);
      result.done = result.last.done;
      if (std::string(result.last.doing) == "going home") {
        if (!result.went_home) meddle();
        result.went_home = true;
      }
      return result.last.motion;
    });
  }
  return result;
}

const std::vector<std::string> kRooms{"############",  //
                                      "#....#.....#",  //
                                      "#.a..#..b..#",  //
                                      "#..........#",  //
                                      "############"};

TEST(ReturnHomeTest, ComesBackToWhereItBegan) {
  for (const RobotModel& robot : {test::burger(), test::roomba()}) {
    const MapDrawing map(kRooms, 0.05, 10);
    const Pose2 start{map.point('a').x(), map.point('a').y(), 2.0};
    House house(robot, map, map, start);
    ReturnHome behavior(robot, std::make_unique<Errand>(robot, map.point('b')));
    const Homecoming result = run(house, behavior, [&] {
      EXPECT_LT((house.pose().position() - map.point('b')).norm(), 0.1);
      EXPECT_EQ(behavior.leftovers().size(), 1u);
    });
    EXPECT_TRUE(result.done);
    EXPECT_TRUE(result.went_home);
    EXPECT_EQ(result.last.motion, Motion{});
    EXPECT_LT((house.pose().position() - start.position()).norm(), 0.06);
    EXPECT_LT(std::fabs(angle_difference(house.pose().yaw, start.yaw)), radians(4.0));
    ASSERT_EQ(behavior.leftovers().size(), 1u);
    EXPECT_STREQ(behavior.leftovers()[0].why, "too narrow");
  }
}

TEST(ReturnHomeTest, SaysSoIfThereIsNoWayBack) {
  const RobotModel robot = test::burger();
  const MapDrawing map(kRooms, 0.05, 10);
  House house(robot, map, map, {map.point('a').x(), map.point('a').y(), 0.0}, 5.0);
  ReturnHome behavior(robot, std::make_unique<Errand>(robot, map.point('b')));
  const Homecoming result = run(house, behavior, [&] { house.truth().set({{50, 0}, {60, 50}}, '#'); });
  EXPECT_TRUE(result.done);
  ASSERT_EQ(behavior.leftovers().size(), 2u);
  EXPECT_STREQ(behavior.leftovers()[1].why, "home: no way back");
  EXPECT_EQ(behavior.leftovers()[1].where, map.point('a'));
}

TEST(ReturnHomeTest, SaysSoIfItIsHeldUp) {
  const RobotModel robot = test::roomba();
  const MapDrawing map(kRooms, 0.05, 10);
  House house(robot, map, map, {map.point('a').x(), map.point('a').y(), 0.0}, 0.01);
  ReturnHome behavior(robot, std::make_unique<Errand>(robot, map.point('b')));
  const Homecoming result = run(house, behavior, [&] { house.truth().set({{50, 0}, {60, 50}}, '#'); });
  EXPECT_TRUE(result.done);
  ASSERT_EQ(behavior.leftovers().size(), 2u);
  EXPECT_STREQ(behavior.leftovers()[1].why, "home: held up on the way back");
}

TEST(ReturnHomeTest, BacksOffFromWhatItBumpsInto) {
  const RobotModel robot = test::roomba();
  const MapDrawing map(kRooms, 0.05, 10);
  ReturnHome behavior(robot, std::make_unique<Errand>(robot, map.point('a')));
  Frame frame;
  PoseEstimate estimate;
  const Situation situation{frame, estimate, map.view(), map.all()};
  estimate.pose = {map.point('a').x(), map.point('a').y() - 0.4, 0.0};  // home
  EXPECT_STREQ(behavior.decide(situation).doing, "errand");
  estimate.pose = {map.point('a').x(), map.point('a').y(), 0.0};
  EXPECT_STREQ(behavior.decide(situation).doing, "going home");
  frame.bump_left = true;
  EXPECT_LT(behavior.decide(situation).motion.linear, 0.0);
  frame.bump_left = false;
  frame.stamp += 0.3;
  EXPECT_LT(behavior.decide(situation).motion.linear, 0.0);
  frame.stamp += 0.6;
  EXPECT_GE(behavior.decide(situation).motion.linear, 0.0);
}

}  // namespace
}  // namespace scrubjay
