#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <scrubjay/error.hpp>
#include <scrubjay/geometry/random.hpp>
#include <scrubjay/geometry/segment2.hpp>
#include <scrubjay/grid/traversal.hpp>
#include <scrubjay/mapping/lidar_mapper.hpp>

#include "lidar_room.hpp"

namespace scrubjay {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

LidarMapper mapper_for(const RobotModel& robot, LidarMapperParams params = {}, double resolution = 0.05) {
  return LidarMapper(robot, resolution, params);
}

Occupancy at(const LidarMapper& mapper, const Point2& p) {
  const CellIndex cell = mapper.map().geometry.cell_at(p);
  return mapper.map().contains(cell) ? trinary(mapper.map()[cell]) : kUnknown;
}

LogOdds evidence_at(const LidarMapper& mapper, const Point2& p) {
  const CellIndex cell = mapper.map().geometry.cell_at(p);
  return mapper.map().contains(cell) ? mapper.map()[cell] : LogOdds{0};
}

/// All cells, by their centre.
void for_each_cell(const LidarMapper& mapper, const std::function<void(const Point2&, LogOdds)>& visit) {
  const auto map = mapper.map();
  for (std::int32_t y = 0; y < map.geometry.height; ++y) {
    for (std::int32_t x = 0; x < map.geometry.width; ++x) visit(map.geometry.center({x, y}), map[{x, y}]);
  }
}

/// The same evidence everywhere, whatever each of them has room for.
void expect_same_map(const LidarMapper& a, const LidarMapper& b) {
  for_each_cell(a, [&](const Point2& p, LogOdds cell) { ASSERT_EQ(cell, evidence_at(b, p)) << p.transpose(); });
  for_each_cell(b, [&](const Point2& p, LogOdds cell) { ASSERT_EQ(cell, evidence_at(a, p)) << p.transpose(); });
}

TEST(LidarMapperTest, KnowsNothingBeforeTheFirstScan) {
  LidarMapper mapper = mapper_for(test::lidar_robot());
  EXPECT_EQ(mapper.map().geometry.size(), 0u);
  mapper.update({}, {});
  EXPECT_TRUE(mapper.changed().empty());
  EXPECT_EQ(mapper.occupancy().cells, std::vector<Occupancy>{kUnknown});
}

TEST(LidarMapperTest, MarksEveryCellAlongABeamAndItsEnd) {
  const RobotModel robot = test::lidar_robot();
  LidarMapper mapper = mapper_for(robot, {.robot_radius = 0.0});
  test::Scans scans({1.0F});
  for (int i = 0; i < 3; ++i) mapper.update(scans.next(), test::at({0.01, 0.02, radians(37.0)}));
  const Point2 from{0.01, 0.02};
  const Point2 to = from + static_cast<double>(1.0F) * direction(radians(37.0));
  const auto map = mapper.map();
  std::size_t on_line = 0;
  visit_line(map.geometry, from, to, [&](CellIndex c) {
    EXPECT_EQ(trinary(map[c]), c == map.geometry.cell_at(to) ? kOccupied : kFree);
    ++on_line;
  });
  std::size_t known = 0;
  for_each_cell(mapper, [&](const Point2&, LogOdds cell) { known += cell != 0; });
  EXPECT_EQ(known, on_line);
}

TEST(LidarMapperTest, FindsTheWallsOfARoomAndTheFloorWithin) {
  const test::Room room;
  LidarMapper mapper = mapper_for(room.robot());
  room.drive(mapper);
  std::size_t walls = 0;
  std::size_t walls_found = 0;
  for (const Point2& p : room.points_on_walls(0.02)) {
    bool found = false;
    for (int y = -1; y <= 1; ++y) {
      for (int x = -1; x <= 1; ++x) found = found || at(mapper, p + 0.05 * Point2(x, y)) == kOccupied;
    }
    ++walls;
    walls_found += found;
  }
  EXPECT_GT(static_cast<double>(walls_found), 0.99 * static_cast<double>(walls));
  for_each_cell(mapper, [&](const Point2& p, LogOdds cell) {
    const double inside = room.clearance(p);
    if (inside > 0.04) {
      EXPECT_EQ(trinary(cell), kFree) << p.transpose();
    }
    if (inside < -0.08) {
      EXPECT_EQ(cell, 0) << p.transpose() << " lies behind a wall";
    }
  });
}

TEST(LidarMapperTest, ANoisyWallEndsWhereItIs) {
  // LDS-01's noise, 1.67 % of the range, from 2 m: it spreads over three cells and more.
  const test::Room room;
  LidarMapper mapper = mapper_for(room.robot());
  Random random(5);
  for (int i = 0; i < 60; ++i) room.scan(mapper, {-1.0 + 0.04 * i, 0.1, 0.1 * i}, 0.0167, &random);
  std::size_t walls = 0;
  std::size_t free = 0;
  std::size_t floor = 0;
  for (const Point2& p : room.points_on_walls(0.05)) walls += at(mapper, p) == kOccupied;
  EXPECT_GT(static_cast<double>(walls), 0.9 * static_cast<double>(room.points_on_walls(0.05).size()));
  for_each_cell(mapper, [&](const Point2& p, LogOdds cell) {
    if (room.clearance(p) < 0.12) return;
    ++floor;
    free += trinary(cell) == kFree;
  });
  EXPECT_GT(static_cast<double>(free), 0.995 * static_cast<double>(floor));
}

TEST(LidarMapperTest, AWallSeenAtAGrazingAngleStaysAWall) {
  const test::Room room;
  LidarMapper mapper = mapper_for(room.robot());
  // Along the upper wall, 20 cm off: most beams that meet it pass many of its cells before they end in it.
  for (int i = 0; i < 40; ++i) room.scan(mapper, {-1.5 + 0.05 * i, room.kTop - 0.2, 0.0});
  for (double x = -1.3; x < 0.9; x += 0.05) EXPECT_EQ(at(mapper, {x, room.kTop + 0.001}), kOccupied) << x;
}

TEST(LidarMapperTest, HitsWinOverMissesOfTheSameScanAndCountOnce) {
  const RobotModel robot = test::lidar_robot();
  const LidarMapperParams params{.robot_radius = 0.0};
  LidarMapper mapper = mapper_for(robot, params);
  // Three beams through one cell at 1 m: two end there, one goes on.
  test::Scans scans({1.01F, 2.0F, 1.02F}, radians(0.2));
  mapper.update(scans.next(), test::at({0.0, 0.01, 0.0}));
  EXPECT_EQ(evidence_at(mapper, {1.01, 0.011}), log_odds(params.hit));
  EXPECT_EQ(evidence_at(mapper, {0.51, 0.011}), log_odds(params.miss));
}

TEST(LidarMapperTest, UnknownBeyondAHitAndBeyondRangeStaysUnknown) {
  const RobotModel robot = test::lidar_robot();  // clear up to 3 m where nothing returns
  LidarMapper mapper = mapper_for(robot, {.robot_radius = 0.0});
  test::Scans scans({1.0F, std::numeric_limits<float>::infinity()}, radians(90.0));
  for (int i = 0; i < 5; ++i) mapper.update(scans.next(), test::at({0.01, 0.01, 0.0}));
  EXPECT_EQ(at(mapper, {0.9, 0.01}), kFree);
  EXPECT_EQ(evidence_at(mapper, {1.2, 0.01}), 0);
  EXPECT_EQ(at(mapper, {0.01, 2.9}), kFree);
  EXPECT_EQ(evidence_at(mapper, {0.01, 3.1}), 0);
}

TEST(LidarMapperTest, ReturnsBeyondMaxRangeClearUpToThereAndMarkNothing) {
  const RobotModel robot = test::lidar_robot();
  LidarMapper mapper = mapper_for(robot, {.max_range = 1.5, .robot_radius = 0.0});
  test::Scans scans({2.0F});
  for (int i = 0; i < 5; ++i) mapper.update(scans.next(), test::at({0.01, 0.01, 0.0}));
  EXPECT_EQ(at(mapper, {1.4, 0.01}), kFree);
  for_each_cell(mapper, [&](const Point2& p, LogOdds cell) {
    if (p.x() > 1.56) {
      EXPECT_EQ(cell, 0);
    }
    EXPECT_LE(cell, 0);
  });
}

TEST(LidarMapperTest, OddRangesMarkNothing) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  RobotModel robot = test::lidar_robot();
  robot.lidar->clear_range = 0.0;
  LidarMapper mapper = mapper_for(robot, {.robot_radius = 0.0});
  test::Scans scans({nan, -1.0F, infinity, -infinity, 0.0F, 0.05F, 99.0F, -0.0F}, radians(45.0));
  mapper.update(scans.next(), {});
  EXPECT_TRUE(mapper.changed().empty());
  for_each_cell(mapper, [](const Point2&, LogOdds cell) { EXPECT_EQ(cell, 0); });
}

TEST(LidarMapperTest, UsesTheForwardConeAlone) {
  const test::Room room;
  LidarMapper mapper = mapper_for(room.robot(), {.forward_cone = radians(10.0), .robot_radius = 0.0});
  for (int i = 0; i < 3; ++i) room.scan(mapper, {0.0, 0.0, radians(90.0)});
  EXPECT_EQ(at(mapper, {0.0, 1.0}), kFree);
  for_each_cell(mapper, [](const Point2& p, LogOdds cell) {
    const double off = std::fabs(angle_difference(atan2(p.y(), p.x()), radians(90.0)));
    if (p.norm() > 0.3 && off > radians(10.0) + 0.08 / p.norm()) {
      EXPECT_EQ(cell, 0) << p.transpose();
    }
  });
}

TEST(LidarMapperTest, FloorWhollyUnderTheRobotIsFree) {
  RobotModel robot = test::lidar_robot();
  robot.lidar->clear_range = 0.0;
  LidarMapper mapper = mapper_for(robot, {.robot_radius = 0.3});
  // Beams that meet the robot itself, and none that says anything else.
  test::Scans scans({0.2F, 0.2F, 0.2F, 0.2F}, radians(90.0));
  for (int i = 0; i < 3; ++i) mapper.update(scans.next(), test::at({0.013, 0.021, 1.0}));
  const Point2 center{0.013, 0.021};
  std::size_t free = 0;
  for_each_cell(mapper, [&](const Point2& p, LogOdds cell) {
    const double far_corner = ((p - center).cwiseAbs() + Point2(0.025, 0.025)).norm();
    EXPECT_EQ(trinary(cell), far_corner <= 0.3 ? kFree : kUnknown) << p.transpose();
    free += trinary(cell) == kFree;
  });
  EXPECT_GT(free, 80u);
}

TEST(LidarMapperTest, StandingStillMakesNothingSurerThanTheClamp) {
  const test::Room room;
  LidarMapper mapper = mapper_for(room.robot());
  for (int i = 0; i < 300; ++i) room.scan(mapper, {0.3, 0.2, 0.1});
  LogOdds least = 0;
  LogOdds most = 0;
  for_each_cell(mapper, [&](const Point2&, LogOdds cell) {
    least = std::min(least, cell);
    most = std::max(most, cell);
  });
  EXPECT_EQ(least, -kMaxLogOdds);
  EXPECT_EQ(most, kMaxLogOdds);
}

TEST(LidarMapperTest, WhatIsGoneFadesAndWhatComesAppears) {
  test::Room room;
  LidarMapper mapper = mapper_for(room.robot());
  const Point2 front{0.801, 0.01};  // of a box, as seen from the origin
  room.box = Bounds2{{0.8, -0.3}, {1.2, 0.3}};
  for (int i = 0; i < 50; ++i) room.scan(mapper, {});
  EXPECT_EQ(at(mapper, front), kOccupied);
  room.box.reset();
  int until_free = 0;
  for (; at(mapper, front) != kFree && until_free < 100; ++until_free) room.scan(mapper, {});
  EXPECT_LE(until_free, 10);  // two seconds of LDS-01
  for (int i = 0; i < 50; ++i) room.scan(mapper, {});
  room.box = Bounds2{{0.8, -0.3}, {1.2, 0.3}};
  int until_occupied = 0;
  for (; at(mapper, front) != kOccupied && until_occupied < 100; ++until_occupied) room.scan(mapper, {});
  EXPECT_LE(until_occupied, 10);
}

TEST(LidarMapperTest, KeepsWallsAtAnyResolution) {
  const test::Room room;
  for (const double resolution : {0.02, 0.1, 0.25}) {
    LidarMapper mapper = mapper_for(room.robot(), {}, resolution);
    EXPECT_EQ(mapper.map().geometry.resolution, resolution);
    room.drive(mapper);
    EXPECT_EQ(mapper.map().geometry.resolution, resolution);
    for_each_cell(mapper, [&](const Point2& p, LogOdds cell) {
      const double inside = room.clearance(p);
      if (trinary(cell) == kOccupied) {
        EXPECT_LT(std::fabs(inside), 1.5 * resolution) << p.transpose();
      }
      if (trinary(cell) == kFree) {
        EXPECT_GT(inside, -0.75 * resolution) << p.transpose();
      }
    });
    EXPECT_EQ(at(mapper, {0.1, 0.1}), kFree);
    EXPECT_EQ(at(mapper, {0.1, room.kTop + 0.001}), kOccupied);
  }
}

TEST(LidarMapperTest, AMapThatGrowsIsTheMapThatWasLargeFromTheStart) {
  const test::Room room;
  for (const double resolution : {0.05, 0.03}) {
    LidarMapper grown = mapper_for(room.robot(), {}, resolution);
    LidarMapper large = mapper_for(room.robot(), {}, resolution);
    const test::Scans anything({1.0F});
    for (const double corner : {-40.0, 40.0}) large.update(anything.next(), test::at({corner, corner, 0.0}));
    const GridGeometry before = large.map().geometry;
    Random random(3);
    for (int i = 0; i < 30; ++i) {
      const Pose2 pose{random.uniform(-1.5, 1.5), random.uniform(-1.0, 1.0), random.uniform(-kPi, kPi)};
      room.scan(grown, pose);
      room.scan(large, pose);
    }
    EXPECT_EQ(large.map().geometry, before);
    std::size_t known = 0;
    for_each_cell(large, [&](const Point2& p, LogOdds cell) {
      if (p.cwiseAbs().maxCoeff() > 30.0) return;
      ASSERT_EQ(cell, evidence_at(grown, p)) << p.transpose();
      known += cell != 0;
    });
    EXPECT_GT(static_cast<double>(known) * resolution * resolution, 12.0);
  }
}

TEST(LidarMapperTest, ATurnThatWasMeasuredWhileTheRobotMovedMapsAsOneMeasuredAtOnce) {
  const test::Room room;
  LidarMapper standing = mapper_for(room.robot(), {.robot_radius = 0.0});
  LidarMapper moving = mapper_for(room.robot(), {.robot_radius = 0.0});
  LidarMapper distorted = mapper_for(room.robot(), {.robot_radius = 0.0});
  const Twist2 twist{0.0, 0.0, 1.0};  // turning on the spot, the sensor in the middle: the same rays in another order
  for (int i = 0; i < 5; ++i) {
    const Pose2 pose{0.2, 0.1, 0.3 * i};
    room.scan(standing, pose);
    room.scan_while_moving(moving, pose, twist, twist);
    room.scan_while_moving(distorted, pose, twist, {});
  }
  const auto walls_off = [&](const LidarMapper& mapper) {
    std::size_t off = 0;
    for_each_cell(mapper, [&](const Point2& p, LogOdds cell) {
      off += trinary(cell) == kOccupied && std::fabs(room.clearance(p)) > 0.05;
    });
    return off;
  };
  EXPECT_EQ(walls_off(standing), 0u);
  EXPECT_EQ(walls_off(moving), 0u);
  EXPECT_GT(walls_off(distorted), 50u);
}

TEST(LidarMapperTest, ChangedHoldsEveryCellThatChangedAndHardlyMore) {
  Random random(11);
  const RobotModel robot = test::lidar_robot();
  LidarMapper mapper = mapper_for(robot);
  for (int run = 0; run < 60; ++run) {
    const LidarMapper before = mapper;
    std::vector<float> ranges(static_cast<std::size_t>(1 + random.below(40)));
    for (float& range : ranges) range = static_cast<float>(random.uniform(-0.5, 3.9));
    test::Scans scans(ranges, random.uniform(-0.2, 0.2));
    mapper.update(scans.next(),
                  test::at({random.uniform(-8.0, 8.0), random.uniform(-8.0, 8.0), random.uniform(-3.0, 3.0)}));
    const CellRect changed = mapper.changed();
    CellRect tight;
    const GridGeometry& geometry = mapper.map().geometry;
    for_each_cell(mapper, [&](const Point2& p, LogOdds cell) {
      if (cell == evidence_at(before, p)) return;
      const CellIndex c = geometry.cell_at(p);
      tight = bounding(tight, {c, {c.x + 1, c.y + 1}});
    });
    ASSERT_EQ(bounding(changed, tight), changed);
    ASSERT_EQ(intersection(changed, cells_of(geometry)), changed);
    const CellRect loose = grown(tight, 3);  // the robot's disc touches cells that don't lie under it whole
    ASSERT_EQ(intersection(changed, loose), changed);
  }
}

TEST(LidarMapperTest, MappingCommutesWithMotionByWholeCells) {
  const test::Room room;
  LidarMapper here = mapper_for(room.robot(), {}, 0.25);
  LidarMapper there = mapper_for(room.robot(), {}, 0.25);
  const Point2 shift{12.5, -7.75};
  Random random(4);
  for (int i = 0; i < 40; ++i) {
    const Pose2 pose{random.uniform(-1.5, 1.5), random.uniform(-1.0, 1.0), random.uniform(-kPi, kPi)};
    here.update(room.frame(pose), test::at(pose));
    there.update(room.frame(pose), test::at({pose.x + shift.x(), pose.y + shift.y(), pose.yaw}));
  }
  for_each_cell(here, [&](const Point2& p, LogOdds cell) { ASSERT_EQ(cell, evidence_at(there, p + shift)); });
}

TEST(LidarMapperTest, TheSameScansGiveTheSameMap) {
  const test::Room room;
  LidarMapper a = mapper_for(room.robot());
  LidarMapper b = mapper_for(room.robot());
  room.drive(a);
  room.drive(b);
  expect_same_map(a, b);
}

TEST(LidarMapperTest, RefusesAPoseThatWentAstrayAndKeepsItsMap) {
  const test::Room room;
  for (const Pose2& pose : {Pose2{kNan, 0.0, 0.0}, Pose2{0.0, kNan, 0.0}, Pose2{0.0, 0.0, kNan},
                            Pose2{kInfinity, 0.0, 0.0}, Pose2{1e6, 0.0, 0.0}, Pose2{0.0, -1e300, 0.0}}) {
    LidarMapper mapper = mapper_for(room.robot());
    room.scan(mapper, {});
    const LidarMapper before = mapper;
    EXPECT_THROW(room.scan(mapper, pose), Error);
    EXPECT_TRUE(mapper.changed().empty());
    expect_same_map(mapper, before);
    room.scan(mapper, {});  // and goes on
    EXPECT_FALSE(mapper.changed().empty());
  }
}

TEST(LidarMapperTest, RefusesParametersOutOfRange) {
  const RobotModel robot = test::lidar_robot();
  for (const LidarMapperParams& params :
       {LidarMapperParams{.hit = 0.5}, LidarMapperParams{.hit = 1.0}, LidarMapperParams{.miss = 0.5},
        LidarMapperParams{.miss = 0.0}, LidarMapperParams{.max_range = 0.0}, LidarMapperParams{.forward_cone = -1.0},
        LidarMapperParams{.robot_radius = -0.1}, LidarMapperParams{.hit = kNan}}) {
    EXPECT_THROW(mapper_for(robot, params), Error);
  }
  EXPECT_THROW(mapper_for(robot, {}, 0.0), Error);
  EXPECT_THROW(mapper_for(robot, {}, kNan), Error);
  EXPECT_THROW(mapper_for(RobotModel{}), Error);
}

}  // namespace
}  // namespace scrubjay
