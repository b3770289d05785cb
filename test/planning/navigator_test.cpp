#include <gtest/gtest.h>

#include <cmath>
#include <scrubjay/planning/navigator.hpp>
#include <string>
#include <vector>

#include "planning/house.hpp"

namespace scrubjay {
namespace {

using test::House;
using test::MapDrawing;

using Rows = std::vector<std::string>;
constexpr int kScale = 10;  // characters of half a metre

MapDrawing drawn(const Rows& rows) {
  return MapDrawing(rows, 0.05, kScale);
}

Pose2 at(const MapDrawing& map, char mark, double yaw = 0.0) {
  return {map.point(mark).x(), map.point(mark).y(), yaw};
}

struct Trip {
  Travel travel = Travel::Driving;
  double time = 0.0;  // [s]
  int paths = 0;      // how many times the end of the path or its length jumped
};

/// Drives until it isn't Driving any more; `meddle` may change the house each tick.
template <typename Meddle>
Trip drive(House& house, Navigator& navigator, CostMap& costs, Meddle&& meddle, double longest = 400.0) {
  Trip trip;
  double before = -1.0;
  const double begin = house.stamp();
  while (trip.travel == Travel::Driving && house.stamp() - begin < longest) {
    meddle();
    house.tick([&](const Situation& now) {
      const CellRect changed = costs.update(now.map, now.changed);
      const Navigator::Step step = navigator.step(now, costs.view(), changed);
      trip.travel = step.travel;
      double left = 0.0;
      for (std::size_t i = 1; i < navigator.path().size(); ++i) {
        left += (navigator.path()[i] - navigator.path()[i - 1]).norm();
      }
      if (std::fabs(left - before) > 0.1) ++trip.paths;
      before = left;
      return step.motion;
    });
  }
  trip.time = house.stamp() - begin;
  return trip;
}

Trip drive(House& house, Navigator& navigator, CostMap& costs) {
  return drive(house, navigator, costs, [] {});
}

CostMap costs_for(const RobotModel& robot, bool through_unknown = false) {
  CostMapParams params;
  params.radius = robot.radius;
  params.through_unknown = through_unknown;
  return CostMap(params);
}

const Rows kTwoRooms{"############",  //
                     "#....#.....#",  //
                     "#.a..#..b..#",  //
                     "#....#.....#",  //
                     "#.......c..#",  //
                     "#....#.....#",  //
                     "############"};

TEST(NavigatorTest, DrivesThroughADoor) {
  for (const RobotModel& robot : {test::burger(), test::roomba()}) {
    const MapDrawing map = drawn(kTwoRooms);
    House house(robot, map, map, at(map, 'a'));
    CostMap costs = costs_for(robot);
    Navigator navigator(robot);
    navigator.go_to(map.point('b'), kPi / 2.0);
    const Trip trip = drive(house, navigator, costs);
    EXPECT_EQ(trip.travel, Travel::Arrived);
    EXPECT_LE((house.pose().position() - map.point('b')).norm(), 0.06);
    EXPECT_LE(std::fabs(angle_difference(house.pose().yaw, kPi / 2.0)), radians(4.0));
    EXPECT_GT(house.nearest(), robot.radius);
    EXPECT_EQ(navigator.goal(), map.point('b'));
    // It stays there until it is sent elsewhere.
    house.tick([&](const Situation& now) {
      EXPECT_EQ(navigator.step(now, costs.view(), {}).travel, Travel::Arrived);
      return Motion{};
    });
  }
}

TEST(NavigatorTest, PassesADoorOfThreeQuartersOfAMetre) {
  const RobotModel robot = test::roomba();
  MapDrawing map = drawn({"#######", "#..#..#", "#a.#.b#", "#..#..#", "#######"});
  map.set({{30, 18}, {40, 33}}, '.');
  House house(robot, map, map, at(map, 'a', 2.0));
  CostMap costs = costs_for(robot);
  Navigator navigator(robot);
  navigator.go_to(map.point('b'));
  EXPECT_EQ(drive(house, navigator, costs).travel, Travel::Arrived);
  EXPECT_GT(house.nearest(), robot.radius);
}

TEST(NavigatorTest, HasArrivedWhereItIs) {
  const MapDrawing map = drawn(kTwoRooms);
  const RobotModel robot = test::burger();
  House house(robot, map, map, at(map, 'a'));
  CostMap costs = costs_for(robot);
  Navigator navigator(robot);
  navigator.go_to(map.point('a') + Point2(0.03, 0.0));
  EXPECT_EQ(drive(house, navigator, costs).time, test::IdealDrive::kTick);
  navigator.go_to(map.point('a'), 1.0);
  EXPECT_EQ(drive(house, navigator, costs).travel, Travel::Arrived);
  EXPECT_NEAR(house.pose().yaw, 1.0, radians(4.0));
}

TEST(NavigatorTest, SaysWhenThereIsNoWay) {
  const RobotModel robot = test::burger();
  const MapDrawing map = drawn({"#########", "#.a.#.b.#", "#########"});
  House house(robot, map, map, at(map, 'a'));
  CostMap costs = costs_for(robot);
  Navigator navigator(robot);
  navigator.go_to(map.point('b'));
  EXPECT_EQ(drive(house, navigator, costs).travel, Travel::NoWay);
  navigator.go_to(map.point('#'));  // where it can't be
  EXPECT_EQ(drive(house, navigator, costs).travel, Travel::NoWay);
  navigator.go_to({-50.0, 0.0});  // off the map
  EXPECT_EQ(drive(house, navigator, costs).travel, Travel::NoWay);
}

TEST(NavigatorTest, GoesAroundAWallThatItSeesOnlyOnTheWay) {
  for (const RobotModel& robot : {test::burger(), test::roomba()}) {
    const Rows empty{"############", "#..........#", "#..........#", "#.a......b.#",
                     "#..........#", "#..........#", "############"};
    const Rows walled{"############", "#..........#", "#.....#....#", "#.a...#..b.#",
                      "#.....#....#", "#.....#....#", "############"};
    const MapDrawing truth = drawn(walled);
    House house(robot, truth, drawn(empty), at(truth, 'a'), 0.6);
    CostMap costs = costs_for(robot);
    Navigator navigator(robot);
    navigator.go_to(truth.point('b'));
    const Trip trip = drive(house, navigator, costs);
    EXPECT_EQ(trip.travel, Travel::Arrived);
    EXPECT_LE(trip.paths, 12);
    EXPECT_GT(house.nearest(), robot.radius);
  }
}

TEST(NavigatorTest, GetsAwayFromAWallThatItStandsTooNearTo) {
  for (const RobotModel& robot : {test::burger(), test::roomba()}) {
    const MapDrawing map = drawn(kTwoRooms);
    Pose2 start = at(map, 'a', kPi);
    start.x = 0.5 + robot.radius + 0.005;  // its shell almost touches the left wall
    House house(robot, map, map, start);
    CostMap costs = costs_for(robot);
    Navigator navigator(robot);
    navigator.go_to(map.point('c'));
    EXPECT_EQ(drive(house, navigator, costs).travel, Travel::Arrived);
  }
}

TEST(NavigatorTest, KeepsItsPathWhenAShorterOneAppears) {
  const RobotModel robot = test::burger();
  const Rows closed{"##########", "#........#", "#.######.#", "#.a....b##", "#.######.#", "#........#", "##########"};
  MapDrawing map =
      drawn({"##########", "#........#", "#..####..#", "#.a#..#b.#", "#..####..#", "#........#", "##########"});
  House house(robot, map, map, at(map, 'a'));
  CostMap costs = costs_for(robot);
  Navigator navigator(robot);
  navigator.go_to(map.point('b'));
  int ticks = 0;
  const Trip trip = drive(house, navigator, costs, [&] {
    // Above and below, the ways are equal; now one is a little shorter, now the other.
    const char mark = ++ticks / 40 % 2 == 0 ? '#' : '.';
    house.truth().set({{30, 44}, {34, 45}}, mark);
    house.truth().set({{30, 25}, {34, 26}}, mark == '#' ? '.' : '#');
  });
  EXPECT_EQ(trip.travel, Travel::Arrived);
  EXPECT_LE(trip.paths, 2);
}

TEST(NavigatorTest, StallsAgainstWhatTheMapDoesntShow) {
  const RobotModel robot = test::roomba();
  const MapDrawing map = drawn({"##########", "#.a.....b#", "##########"});
  MapDrawing truth = map;
  truth.set({{50, 10}, {52, 20}}, '#');
  House house(robot, truth, map, at(map, 'a'), 0.01);
  CostMap costs = costs_for(robot);
  Navigator navigator(robot);
  navigator.go_to(map.point('b'));
  const Trip trip = drive(house, navigator, costs);
  EXPECT_EQ(trip.travel, Travel::Stalled);
  EXPECT_LT(trip.time, 15.0 + 12.0);
}

TEST(NavigatorTest, StallsWhenItIsSentToAndFro) {
  const RobotModel robot = test::burger();
  const MapDrawing map =
      drawn({"###########", "#....c....#", "#.#######.#", "#.#######.#", "#.#######.#", "#....a....#", "###########"});
  House house(robot, map, map, at(map, 'a'));
  CostMap costs = costs_for(robot);
  Navigator navigator(robot);
  navigator.go_to(map.point('c'));
  // Whichever way it takes, a door falls shut before it, and the other one opens.
  const CellRect left{{10, 30}, {20, 32}};
  const CellRect right{{90, 30}, {100, 32}};
  const Trip trip = drive(
      house, navigator, costs,
      [&] {
        if (house.pose().x < 1.5) {
          house.truth().set(left, '#');
          house.change_openly(right, '.');
        } else if (house.pose().x > 4.0) {
          house.truth().set(right, '#');
          house.change_openly(left, '.');
        }
      },
      2000.0);
  EXPECT_EQ(trip.travel, Travel::Stalled);
  EXPECT_GE(trip.paths, 3);
  EXPECT_LT(trip.time, 400.0);
}

TEST(NavigatorTest, GoesAlongAWayThatWasFoundForIt) {
  const RobotModel robot = test::burger();
  const MapDrawing map = drawn(kTwoRooms);
  House house(robot, map, map, at(map, 'a'));
  CostMap costs = costs_for(robot);
  costs.update(map.view(), map.all());
  PathSearch search;
  search.spread(costs.view(), map.cell('a'));
  Navigator navigator(robot);
  navigator.go_along(search.path_to(map.cell('b')), costs.view());
  EXPECT_EQ(navigator.path().back(), map.point('b'));
  EXPECT_EQ(drive(house, navigator, costs).travel, Travel::Arrived);
  EXPECT_LE((house.pose().position() - map.point('b')).norm(), 0.06);
}

TEST(NavigatorTest, DrivesOverUnknownFloorWhereItMay) {
  const RobotModel robot = test::roomba();
  const MapDrawing truth = drawn({"##########", "#.a.....b#", "##########"});
  const MapDrawing known = drawn({"??????????", "?.a??????.", "??????????"});
  for (const bool bold : {false, true}) {
    House house(robot, truth, known, at(truth, 'a'), 0.01);
    CostMap costs = costs_for(robot, bold);
    Navigator navigator(robot);
    navigator.go_to(truth.point('b'));
    EXPECT_EQ(drive(house, navigator, costs).travel, bold ? Travel::Arrived : Travel::NoWay);
  }
}

TEST(NavigatorTest, DoesTheSameEachTime) {
  const RobotModel robot = test::roomba();
  const MapDrawing map = drawn(kTwoRooms);
  const auto end = [&] {
    House house(robot, map, map, at(map, 'a', 1.0));
    CostMap costs = costs_for(robot);
    Navigator navigator(robot);
    navigator.go_to(map.point('c'), -1.0);
    drive(house, navigator, costs);
    return house.pose();
  };
  EXPECT_EQ(end(), end());
}

}  // namespace
}  // namespace scrubjay
