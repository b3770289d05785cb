#include <gmock/gmock.h>

#include "stage.hpp"

namespace scrubjay::test {
namespace {

constexpr double kReceiver = 0.153;  ///< in front of the robot's middle [m]
constexpr std::uint8_t kFence = 162;
constexpr std::uint8_t kForceField = 161;
constexpr std::uint8_t kGreen = 164;
constexpr std::uint8_t kRed = 168;
constexpr std::uint8_t kBoth = 172;

/// A robot whose receiver is `range` from `emitter` at `bearing`, and which looks at it.
Pose2 looking_at(const Pose2& emitter, double range, double bearing) {
  const double heading = emitter.yaw + bearing + kPi;
  const Point2 receiver = emitter.position() + range * direction(emitter.yaw + bearing);
  const Point2 middle = receiver - kReceiver * direction(heading);
  return {middle.x(), middle.y(), wrap_angle(heading)};
}

const Pose2 kEmitter{2.0, 1.0, 0.8};

World with_fence() {
  World world;
  world.virtual_walls = {{kEmitter, 1.5, 0.2}};
  return world;
}

TEST(VirtualWallTest, IsSeenInItsSector) {
  for (const double range : {0.3, 1.0, 1.49}) {
    for (const double bearing : {-0.19, 0.0, 0.19}) {
      Stage stage(with_fence(), looking_at(kEmitter, range, bearing));
      EXPECT_TRUE(stage.feel().virtual_wall) << range << " m, " << bearing << " rad";
      EXPECT_EQ(stage.feel().infrared_omni, kFence);
    }
  }
}

TEST(VirtualWallTest, IsNotSeenBesideOrBeyondIt) {
  const World world = with_fence();
  for (const auto& [range, bearing] : {std::pair{1.51, 0.0}, {1.0, 0.21}, {1.0, -0.21}, {1.0, kPi}}) {
    Stage stage(world, looking_at(kEmitter, range, bearing));
    EXPECT_FALSE(stage.feel().virtual_wall) << range << " m, " << bearing << " rad";
    EXPECT_EQ(stage.feel().infrared_omni, 0);
  }
}

TEST(VirtualWallTest, IsHiddenByAWall) {
  World world = with_fence();
  world.walls = {facing(kEmitter.position(), kEmitter.yaw, 0.5, 0.3)};
  EXPECT_FALSE(Stage(world, looking_at(kEmitter, 1.0, 0.0)).feel().virtual_wall);
  EXPECT_TRUE(Stage(world, looking_at(kEmitter, 0.4, 0.0)).feel().virtual_wall) << "in front of the wall";
}

TEST(VirtualWallTest, FadesWhenTheRobotLeaves) {
  Stage stage(with_fence(), looking_at(kEmitter, 1.4, 0.0));
  EXPECT_TRUE(stage.feel().virtual_wall);
  EXPECT_FALSE(stage.drive(-0.2, -0.2, 3.0).virtual_wall);
  EXPECT_EQ(stage.feel().infrared_omni, 0);
}

World with_dock() {
  World world;
  world.dock = Dock{kEmitter};
  return world;
}

std::uint8_t character_at(double range, double bearing_degrees) {
  return Stage(with_dock(), looking_at(kEmitter, range, radians(bearing_degrees))).feel().infrared_omni;
}

TEST(DockTest, SendsItsBuoysToTheirSides) {
  EXPECT_EQ(character_at(0.9, 0.0), kBoth);
  EXPECT_EQ(character_at(0.9, 4.0), kBoth);
  EXPECT_EQ(character_at(0.9, 15.0), kGreen);
  EXPECT_EQ(character_at(0.9, 24.0), kGreen);
  EXPECT_EQ(character_at(0.9, 26.0), 0);
  EXPECT_EQ(character_at(0.9, -15.0), kRed);
  EXPECT_EQ(character_at(0.9, -26.0), 0);
  EXPECT_EQ(character_at(0.9, 180.0), 0);
}

TEST(DockTest, ARobotThatComesHasRedOnItsLeft) {
  // Seen from a robot that looks at the dock, its left is where bearings from the dock are negative.
  const Pose2 robot = looking_at(kEmitter, 0.9, 0.0);
  const Point2 to_its_left = robot * Point2(kReceiver, 0.25);
  EXPECT_LT((inverse(kEmitter) * to_its_left).y(), 0.0);
  Stage stage(with_dock(), {robot.x + 0.25 * direction(robot.yaw + 0.5 * kPi).x(),
                            robot.y + 0.25 * direction(robot.yaw + 0.5 * kPi).y(), robot.yaw});
  EXPECT_EQ(stage.feel().infrared_omni, kRed);
}

TEST(DockTest, HasAForceFieldAllAroundIt) {
  EXPECT_EQ(character_at(0.6, 90.0), kForceField);
  EXPECT_EQ(character_at(0.6, 180.0), kForceField);
  EXPECT_EQ(character_at(0.62, 90.0), 0);
  EXPECT_EQ(character_at(0.6, 0.0), kBoth | kForceField);
  EXPECT_EQ(character_at(0.6, -15.0), kRed | kForceField);
}

TEST(DockTest, IsNotHeardBeyondItsRangeNorThroughAWall) {
  EXPECT_EQ(character_at(1.01, 0.0), 0);
  World world = with_dock();
  world.walls = {facing(kEmitter.position(), kEmitter.yaw, 0.3, 0.3)};
  EXPECT_EQ(Stage(world, looking_at(kEmitter, 0.9, 0.0)).feel().infrared_omni, 0);
}

TEST(DockTest, DirectionalReceiversHearItOnTheirSide) {
  Pose2 robot = looking_at(kEmitter, 0.5, 0.0);
  Stage ahead(with_dock(), robot);
  EXPECT_NE(ahead.feel().infrared_left, 0);
  EXPECT_NE(ahead.feel().infrared_right, 0);
  robot.yaw += radians(40.0);  // now the dock is on the right
  Stage right(with_dock(), robot);
  EXPECT_EQ(right.feel().infrared_left, 0);
  EXPECT_NE(right.feel().infrared_right, 0);
  robot.yaw -= radians(80.0);
  Stage left(with_dock(), robot);
  EXPECT_NE(left.feel().infrared_left, 0);
  EXPECT_EQ(left.feel().infrared_right, 0);
}

TEST(DockTest, TakesARobotThatStandsInItStraight) {
  EXPECT_TRUE(Stage(with_dock(), looking_at(kEmitter, 0.01, 0.0)).feel().docked);
  EXPECT_FALSE(Stage(with_dock(), looking_at(kEmitter, 0.05, 0.0)).feel().docked) << "too far";
  Pose2 askew = looking_at(kEmitter, 0.0, 0.0);
  askew = {kEmitter.x - kReceiver * direction(askew.yaw + 0.4).x(),
           kEmitter.y - kReceiver * direction(askew.yaw + 0.4).y(), askew.yaw + 0.4};
  EXPECT_FALSE(Stage(with_dock(), askew).feel().docked) << "askew";
}

TEST(BatteryTest, DrainsFasterWhileDriving) {
  const sim::BatterySpec pack;
  Stage standing({});
  const Battery idle = standing.drive(0.0, 0.0, 60.0).battery;
  EXPECT_NEAR(idle.charge, pack.capacity - pack.idle_current / 60.0, 1e-9);
  EXPECT_DOUBLE_EQ(idle.current, -pack.idle_current);
  EXPECT_LT(idle.voltage, pack.full_voltage);
  Stage driving({});
  const Battery busy = driving.drive(0.5, 0.5, 60.0).battery;
  EXPECT_NEAR(busy.current, -(pack.idle_current + 2.0 * pack.drive_current), 1e-12);
  EXPECT_LT(busy.charge, idle.charge);
}

TEST(BatteryTest, IsEmptyAtLast) {
  sim::RobotSpec spec;
  spec.battery.capacity = 0.001;
  Stage stage({}, {}, {}, 1, spec);
  const Battery battery = stage.drive(0.0, 0.0, 60.0).battery;
  EXPECT_EQ(battery.charge, 0.0);
  EXPECT_DOUBLE_EQ(battery.voltage, spec.battery.empty_voltage);
}

TEST(BatteryTest, ChargesInTheDockWhileStandingAndNeverBeyondFull) {
  sim::RobotSpec spec;
  spec.battery.capacity = 0.01;
  Stage stage(with_dock(), looking_at(kEmitter, 0.2, 0.0), {}, 1, spec);
  const double low = stage.drive(0.0, 0.0, 60.0).battery.charge;
  EXPECT_LT(low, 0.006);
  while (!stage.body.tick({0.1, 0.1}).docked) {
    ASSERT_LT(stage.body.truth().distance, 0.3);
  }
  EXPECT_FALSE(stage.body.tick({0.01, 0.01}).battery.charging) << "it moves";
  const Battery begun = stage.drive(0.0, 0.0, 1.0).battery;
  EXPECT_TRUE(begun.charging);
  EXPECT_DOUBLE_EQ(begun.current, spec.battery.charge_current);
  const Battery full = stage.drive(0.0, 0.0, 60.0).battery;
  EXPECT_NEAR(full.charge, spec.battery.capacity, 1e-5);
  EXPECT_LE(full.charge, spec.battery.capacity);
}

}  // namespace
}  // namespace scrubjay::test
