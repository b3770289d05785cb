#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <scrubjay/geometry/random.hpp>
#include <scrubjay/grid/contact_model.hpp>
#include <vector>

namespace scrubjay {
namespace {

/// Cells all around the origin, and a model that writes them.
struct Floor {
  explicit Floor(const RobotModel& body = {}, double resolution = 0.05, std::int32_t half_width = 40)
      : robot(body), model(body) {
    geometry.resolution = resolution;
    geometry.origin = {-half_width * resolution, -half_width * resolution};
    geometry.width = geometry.height = 2 * half_width;
    cells.resize(geometry.size());
  }
  void integrate(const Frame& frame, const Pose2& pose) { model.integrate(frame, pose, {geometry, cells.data()}); }
  LogOdds at(const Point2& p) const { return cells[geometry.index(geometry.cell_at(p))]; }
  /// Calls `check(centre, log-odds)` for each cell.
  template <typename Check>
  void each(Check&& check) const {
    for (std::int32_t y = 0; y < geometry.height; ++y) {
      for (std::int32_t x = 0; x < geometry.width; ++x) {
        check(geometry.center({x, y}), cells[geometry.index({x, y})]);
      }
    }
  }
  int count(Occupancy value) const {
    int count = 0;
    for (const LogOdds cell : cells) count += trinary(cell) == value;
    return count;
  }
  LogOdds highest() const { return *std::max_element(cells.begin(), cells.end()); }

  RobotModel robot;
  ContactModel model;
  GridGeometry geometry;
  std::vector<LogOdds> cells;
};

RobotModel blind_robot() {
  RobotModel robot;
  robot.has_light_sensors = false;
  return robot;
}

Frame bump(bool left, bool right) {
  Frame frame;
  frame.bump_left = left;
  frame.bump_right = right;
  return frame;
}

/// A light sensor's signal of a surface at `range` [m].
std::uint16_t signal_at(double range) {
  const LightSensorModel light;
  return static_cast<std::uint16_t>(std::lround(light.gain * std::exp(-light.attenuation * range) + light.ambient));
}

double bearing(const Point2& p) {
  return std::atan2(p.y(), p.x());
}

TEST(ContactModelTest, TheSweptDiscIsFree) {
  Floor floor;
  for (int i = 0; i <= 50; ++i) floor.integrate({}, {i * 0.01, 0.0, 0.0});
  floor.each([&](const Point2& center, LogOdds cell) {
    const double beside = (center - Point2{std::clamp(center.x(), 0.0, 0.5), 0.0}).norm() - floor.robot.radius;
    if (beside < -0.25 * floor.geometry.resolution - 1e-9) {
      EXPECT_EQ(trinary(cell), kFree) << center.transpose();
    } else if (beside > 1e-9) {
      EXPECT_EQ(cell, 0) << center.transpose();
    }
  });
}

TEST(ContactModelTest, StandingStillMakesNothingMoreCertain) {
  Floor floor;
  Frame frame = bump(true, true);
  frame.light_signal[2] = signal_at(0.03);
  floor.integrate(frame, {});
  const auto before = floor.cells;
  EXPECT_NE(before, std::vector<LogOdds>(before.size()));
  for (int i = 0; i < 1000; ++i) floor.integrate(frame, {i % 2 * 1e-3, 0.0, i % 3 * 1e-3});
  EXPECT_EQ(floor.cells, before);
  EXPECT_FALSE(floor.model.wants(frame, {}));
  EXPECT_TRUE(floor.model.wants(frame, {0.02, 0.0, 0.0}));
  EXPECT_TRUE(floor.model.wants(frame, {0.0, 0.0, radians(-4.0)}));
}

TEST(ContactModelTest, ABumpThatBeginsIsWantedOnTheSpot) {
  Floor floor;
  floor.integrate({}, {});
  EXPECT_FALSE(floor.model.wants({}, {}));
  EXPECT_TRUE(floor.model.wants(bump(true, false), {}));
  floor.integrate(bump(true, false), {});
  EXPECT_FALSE(floor.model.wants(bump(true, false), {}));
  EXPECT_TRUE(floor.model.wants(bump(true, true), {}));
}

TEST(ContactModelTest, NoSingleBumpMakesAWallAtAnyPose) {
  Random random(1);
  for (int run = 0; run < 20000; ++run) {
    Floor floor(run % 2 == 0 ? RobotModel{} : blind_robot(), 0.05, 8);
    const Frame frame = bump(random.below(2) == 0, true);
    floor.integrate(frame, {random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), random.uniform(-kPi, kPi)});
    EXPECT_GT(floor.highest(), 0);
    ASSERT_EQ(floor.count(kOccupied), 0) << "run " << run;
  }
}

TEST(ContactModelTest, NoSingleBumpThatALightSensorExplainsMakesAWall) {
  // The sensor's own reading is a second witness; here it counted before the bump.
  Random random(2);
  int marked = 0;
  for (int run = 0; run < 20000; ++run) {
    Floor floor({}, 0.05, 8);
    const Pose2 pose{random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), random.uniform(-kPi, kPi)};
    floor.integrate({}, pose);
    Frame frame = bump(true, true);
    frame.light_signal[2 + random.below(2)] = signal_at(0.03);
    floor.integrate(frame, pose);
    marked += floor.highest() > 0;
    ASSERT_EQ(floor.count(kOccupied), 0) << "run " << run;
  }
  EXPECT_GT(marked, 19000);  // in the others, all cells on the short arc have their centres under the robot
}

TEST(ContactModelTest, BumpsFromSeveralPosesMakeAWall) {
  for (const RobotModel& robot : {RobotModel{}, blind_robot()}) {
    Floor floor(robot);
    const double wall = 0.5;
    for (int i = 0; i < 6; ++i) {
      const double y = -0.05 + 0.02 * i;
      const double contact = wall - robot.radius;
      floor.integrate({}, {contact - 0.05, y, 0.0});
      floor.integrate(bump(true, true), {contact, y, 0.0});
      floor.integrate({}, {contact - 0.05, y, 0.0});
    }
    EXPECT_EQ(trinary(floor.at({0.51, 0.01})), kOccupied);
    floor.each([&](const Point2& center, LogOdds cell) {
      if (trinary(cell) == kOccupied) {
        EXPECT_GT(center.x(), wall - 0.05);
      }
    });
  }
}

TEST(ContactModelTest, ABumpMarksOnlyTheHalfThatWasHit) {
  for (const RobotModel& robot : {RobotModel{}, blind_robot()}) {
    for (const double yaw : {0.0, 0.7, 2.5, -1.9}) {
      // Half a cell at the shell is 8 degrees.
      const auto expect_between = [&](const Frame& frame, double low, double high) {
        Floor floor(robot, 0.025);
        floor.integrate(frame, {0.0, 0.0, yaw});
        int marked = 0;
        floor.each([&](const Point2& center, LogOdds cell) {
          if (cell <= 0) return;
          ++marked;
          const double seen_at = wrap_angle(bearing(center) - yaw);
          EXPECT_GT(seen_at, radians(low - 6.0));
          EXPECT_LT(seen_at, radians(high + 6.0));
          EXPECT_NEAR(center.norm(), robot.radius, 0.03);
        });
        EXPECT_GT(marked, 5);
      };
      expect_between(bump(true, false), 30.0, 90.0);
      expect_between(bump(false, true), -90.0, -30.0);
      expect_between(bump(true, true), -30.0, 30.0);
    }
  }
}

TEST(ContactModelTest, AThingSeenOnTheOtherSideDoesntExplainABump) {
  Floor floor({}, 0.025);
  floor.integrate({}, {});
  Frame frame = bump(false, true);
  frame.light_signal[0] = signal_at(0.025);  // on the left; it counted where the robot stood before
  floor.integrate(frame, {});
  int marked = 0;
  floor.each([&](const Point2& center, LogOdds cell) {
    if (cell <= 0) return;
    ++marked;
    EXPECT_LT(center.y(), 0.0);
  });
  EXPECT_GT(marked, 3);
}

TEST(ContactModelTest, ACliffIsAnObstacleUnderItsSensor) {
  for (std::size_t sensor = 0; sensor < 4; ++sensor) {
    Floor floor;
    const Pose2 pose{0.1, 0.2, 1.0};
    Frame frame;
    frame.cliff_flags = static_cast<std::uint8_t>(1u << sensor);
    floor.integrate(frame, pose);
    EXPECT_EQ(trinary(floor.at(pose * floor.robot.cliff_sensors[sensor])), kOccupied);
    EXPECT_EQ(floor.count(kOccupied), 1);
  }
}

TEST(ContactModelTest, ARobotWithoutLightSensorsMarksTheWholeArcMoreFaintly) {
  Floor blind(blind_robot(), 0.025);
  Floor seeing({}, 0.025);
  Frame frame = bump(true, false);
  frame.light_signal[0] = signal_at(0.025);  // 65 degrees; the blind robot has no such sensor
  blind.integrate(frame, {});
  seeing.integrate(frame, {});
  int blind_cells = 0;
  int seeing_cells = 0;
  for (const LogOdds cell : blind.cells) blind_cells += cell > 0;
  for (const LogOdds cell : seeing.cells) seeing_cells += cell > 0;
  EXPECT_GT(blind_cells, seeing_cells);
  EXPECT_LT(blind.highest(), seeing.highest());
  const Point2 elsewhere = 0.18 * direction(radians(37.5));
  EXPECT_GT(blind.at(elsewhere), 0);
  EXPECT_EQ(seeing.at(elsewhere), 0);
}

TEST(ContactModelTest, ALightSignalMarksAnObstacleAtItsBearingAndRange) {
  for (std::size_t sensor = 0; sensor < 6; ++sensor) {
    for (const double range : {0.05, 0.08, 0.11}) {
      Floor floor({}, 0.01, 60);
      const Pose2 pose{0.1, -0.05, 0.4};
      Frame frame;
      frame.light_signal[sensor] = signal_at(range);
      floor.integrate(frame, pose);
      const Pose2 mount = pose * floor.robot.light.mount[sensor];
      const Point2 hit = mount.position() + range * direction(mount.yaw);
      int marked = 0;
      floor.each([&](const Point2& center, LogOdds cell) {
        if (cell <= 0) return;
        ++marked;
        EXPECT_LT((center - hit).norm(), 0.012);
      });
      EXPECT_EQ(marked, 1);
      // The beam before it is a little less likely to hold anything.
      const Point2 before = mount.position() + (range - 0.025) * direction(mount.yaw);
      EXPECT_LT(floor.at(before), 0);
    }
  }
}

TEST(ContactModelTest, ALightSignalNeedsMoreThanOneReading) {
  Floor floor;
  Frame frame;
  frame.light_signal[2] = signal_at(0.1);
  const Pose2 mount = floor.robot.light.mount[2];
  const Point2 hit = mount.position() + 0.1 * direction(mount.yaw);
  floor.integrate(frame, {});
  EXPECT_EQ(floor.count(kOccupied), 0);
  EXPECT_GT(floor.at(hit), 0);
  // Two centimetres nearer along the beam it sees the same thing.
  const Point2 nearer = 0.0201 * direction(mount.yaw);
  frame.light_signal[2] = signal_at(0.1 - 0.0201);
  floor.integrate(frame, {nearer.x(), nearer.y(), 0.0});
  EXPECT_EQ(trinary(floor.at(hit)), kOccupied);
  EXPECT_EQ(floor.count(kOccupied), 1);
}

TEST(ContactModelTest, WantsAPoseThatIsNoNumber) {
  // So that a growing map refuses it, and it doesn't go unnoticed.
  Floor floor;
  floor.integrate({}, {});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(floor.model.wants({}, {nan, 0.0, 0.0}));
  EXPECT_TRUE(floor.model.wants({}, {0.0, nan, 0.0}));
}

TEST(ContactModelTest, FarSignalsSayNothing) {
  Floor floor;
  Frame frame;
  frame.light_signal.fill(signal_at(0.13));
  floor.integrate(frame, {});
  EXPECT_EQ(floor.highest(), 0);
}

TEST(ContactModelTest, TouchesNothingBeyondItsReachNorOutsideOfTheGrid) {
  Random random(2);
  for (int run = 0; run < 300; ++run) {
    Floor floor({}, 0.03, 9);  // 54 cm wide: smaller than what the model reaches
    const Pose2 pose{random.uniform(-0.6, 0.6), random.uniform(-0.6, 0.6), random.uniform(-kPi, kPi)};
    Frame frame = bump(random.below(2) == 0, random.below(2) == 0);
    for (auto& signal : frame.light_signal) signal = static_cast<std::uint16_t>(random.below(4096));
    floor.integrate(frame, pose);
    floor.each([&](const Point2& center, LogOdds cell) {
      if (cell == 0) return;
      const Point2 away = (center - pose.position()).cwiseAbs() - Point2::Constant(0.5 * floor.geometry.resolution);
      EXPECT_LE(away.cwiseMax(0.0).norm(), floor.model.reach());
    });
  }
}

/// A walk that bumps and sees here and there.
struct Step {
  Frame frame;
  Pose2 pose;
};

std::vector<Step> random_walk(std::uint64_t seed) {
  Random random(seed);
  std::vector<Step> steps;
  Pose2 pose{0.0, 0.0, random.uniform(-kPi, kPi)};
  for (int i = 0; i < 300; ++i) {
    pose = pose * Pose2{random.uniform(0.0, 0.01), 0.0, random.uniform(-0.05, 0.05)};
    Frame frame = bump(random.below(10) == 0, random.below(10) == 0);
    for (auto& signal : frame.light_signal) {
      signal = random.below(4) == 0 ? signal_at(random.uniform(0.0, 0.14)) : std::uint16_t{0};
    }
    steps.push_back({frame, pose});
  }
  return steps;
}

Floor mapped(const std::vector<Step>& steps, const Pose2& moved_by) {
  Floor floor({}, 0.0625, 80);
  for (const Step& step : steps) floor.integrate(step.frame, moved_by * step.pose);
  return floor;
}

TEST(ContactModelTest, MappingCommutesWithMovesByWholeCells) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const auto steps = random_walk(seed);
    const Floor plain = mapped(steps, {});
    for (const CellIndex by : {CellIndex{1, 0}, CellIndex{-7, 3}, CellIndex{12, -11}}) {
      const Floor moved = mapped(steps, {by.x * 0.0625, by.y * 0.0625, 0.0});
      plain.each([&](const Point2& center, LogOdds cell) {
        const Point2 there = center + Point2{by.x * 0.0625, by.y * 0.0625};
        if (moved.geometry.contains(moved.geometry.cell_at(there))) {
          ASSERT_EQ(moved.at(there), cell);
        }
      });
    }
  }
}

TEST(ContactModelTest, MappingCommutesWithQuarterTurns) {
  for (std::uint64_t seed = 20; seed < 30; ++seed) {
    const auto steps = random_walk(seed);
    const Floor plain = mapped(steps, {});
    const Floor turned = mapped(steps, {0.0, 0.0, 0.5 * kPi});
    plain.each([&](const Point2& center, LogOdds cell) { ASSERT_EQ(turned.at({-center.y(), center.x()}), cell); });
  }
}

}  // namespace
}  // namespace scrubjay
