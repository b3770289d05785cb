#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <scrubjay/behavior/edge_follow.hpp>
#include <scrubjay/localization/localizer.hpp>
#include <scrubjay/mapping/contact_mapper.hpp>
#include <scrubjay/mission/mission.hpp>
#include <scrubjay/mission/track.hpp>
#include <scrubjay/robot/oi_robot.hpp>
#include <scrubjay/simulation/simulated_roomba.hpp>
#include <scrubjay/world/score.hpp>

namespace scrubjay::test {
namespace {

World closed_room(double width, double height, const Pose2& start) {
  World world;
  world.walls = {{{{0.0, 0.0}, {width, 0.0}, {width, height}, {0.0, height}, {0.0, 0.0}}}};
  world.start = start;
  return world;
}

/// `edge-follow` on a perfect robot in a small world.
struct EdgeDrive {
  explicit EdgeDrive(World scenery, const EdgeFollowParams& params = {}, const sim::RobotSpec& robot_spec = {},
                     std::uint64_t seed = 1)
      : world(std::move(scenery)),
        index(solid_segments(world)),
        spec(robot_spec),
        roomba(world, index, spec, {}, Random(seed).fork(0), *world.start),
        mapper(spec.model, 0.05),
        behavior(spec.model, Random(seed).fork(1), params) {}

  Report run(double seconds, std::function<void(const Snapshot&)> each_tick = {}) {
    struct Watcher final : Observer {
      void notify(const Snapshot& now) override {
        if (act) act(now);
      }
      std::function<void(const Snapshot&)> act;
    };
    Watcher watcher;
    watcher.act = std::move(each_tick);
    OiRobot robot(roomba, spec.model);
    DeadReckoning localizer(spec.model.drive);
    Mission mission(robot, localizer, mapper, behavior, {seconds});
    mission.watch(watcher);
    mission.watch(track);
    return mission.run({});
  }

  const Pose2& pose() const { return roomba.truth().pose; }
  double clearance() const { return index.distance(pose().position(), 10.0) - spec.model.radius; }
  MapScore score() const {
    const GroundTruth truth = ground_truth(world, *world.start, spec.model.radius, 0.05);
    const OccupancyGrid map = mapper.occupancy();
    return score_map(map.view(), truth);
  }
  /// Whether a cell within `reach` of the world's point is occupied in the map.
  bool mapped(const Point2& point, double reach) const {
    const OccupancyGrid map = mapper.occupancy();
    const Point2 middle = inverse(*world.start) * point;
    for (std::int32_t y = 0; y < map.geometry.height; ++y) {
      for (std::int32_t x = 0; x < map.geometry.width; ++x) {
        const bool near = (map.geometry.center({x, y}) - middle).norm() <= reach;
        if (near && map.view()[{x, y}] >= kOccupiedFrom) return true;
      }
    }
    return false;
  }

  World world;
  SegmentIndex index;
  sim::RobotSpec spec;
  sim::SimulatedRoomba roomba;
  ContactMapper mapper;
  EdgeFollow behavior;
  Track track;
};

/// Sum of the robot's turns on its way [rad]: positive is counter-clockwise.
class TurnCount {
 public:
  void add(double yaw) {
    sum_ += angle_difference(yaw, last_);
    last_ = yaw;
  }
  double sum() const { return sum_; }

 private:
  double last_ = 0.0;
  double sum_ = 0.0;
};

TEST(EdgeFollowDriveTest, FollowsARoomsWallsOnThePreferredSide) {
  for (const Side side : {Side::Left, Side::Right}) {
    EdgeFollowParams params;
    params.preferred_side = side;
    EdgeDrive drive(closed_room(2.0, 1.6, {1.0, 0.8, 0.0}), params);
    TurnCount turns;
    int following = 0;
    double worst = 0.0;
    drive.run(100.0, [&](const Snapshot& now) {
      if (drive.behavior.loops_closed() > 0) return;
      turns.add(drive.pose().yaw);
      if (std::string_view(now.decision.doing) != "following the edge") return;
      ++following;
      worst = std::max(worst, drive.clearance());
    });
    EXPECT_EQ(drive.behavior.loops_closed(), 1);
    EXPECT_GT(following, 1500);
    EXPECT_LT(worst, 0.1);
    // Walls on the left: clockwise around the room.
    EXPECT_NEAR(turns.sum(), side == Side::Left ? -2.0 * kPi : 2.0 * kPi, radians(130.0));
    EXPECT_GE(drive.score().wall_recall, 0.99);
  }
}

TEST(EdgeFollowDriveTest, RoundsInsideAndOutsideCorners) {
  // An L: five corners inside, one outside.
  World world;
  world.walls = {{{{0.0, 0.0}, {2.4, 0.0}, {2.4, 1.0}, {1.2, 1.0}, {1.2, 2.2}, {0.0, 2.2}, {0.0, 0.0}}}};
  world.start = Pose2{0.6, 0.5, 0.3};
  EdgeDrive drive(std::move(world));
  drive.run(200.0);
  EXPECT_GE(drive.behavior.loops_closed(), 1);
  EXPECT_GE(drive.score().wall_recall, 0.97);
  EXPECT_GE(drive.score().wall_precision, 0.97);
}

TEST(EdgeFollowDriveTest, PassesANarrowPassage) {
  // 0.42 m between two rooms: 7 cm more than the robot.
  World world = closed_room(3.0, 1.4, {0.7, 0.7, 1.0});
  world.furniture = {{"south", {box({1.5, 0.245}, {0.2, 0.49}, 0.0)}},
                     {"north", {box({1.5, 1.155}, {0.2, 0.49}, 0.0)}}};
  EdgeDrive drive(std::move(world));
  double farthest = 0.0;
  drive.run(400.0, [&](const Snapshot&) { farthest = std::max(farthest, drive.pose().x); });
  EXPECT_GT(farthest, 2.4);
  EXPECT_GE(drive.score().wall_recall, 0.95);
}

TEST(EdgeFollowDriveTest, OrbitsATableLegAndMapsIt) {
  World world = closed_room(3.0, 3.0, {0.8, 1.5, 0.0});
  world.furniture = {{"leg", {disc({1.5, 1.52}, 0.02)}}};
  EdgeDrive drive(std::move(world));
  double nearest_behind = 10.0;
  drive.run(120.0, [&](const Snapshot&) {
    if (drive.behavior.loops_closed() > 0) return;
    const Point2 from_leg = drive.pose().position() - Point2(1.5, 1.52);
    if (from_leg.x() > 0.1) nearest_behind = std::min(nearest_behind, from_leg.norm());
  });
  EXPECT_GE(drive.behavior.loops_closed(), 1);
  EXPECT_LT(nearest_behind, 0.35) << "it went round the leg";
  EXPECT_TRUE(drive.mapped({1.5, 1.52}, 0.06));
}

TEST(EdgeFollowDriveTest, ClosesTheRoomThenTheIslandThenEnds) {
  World world = closed_room(2.8, 2.4, {0.5, 0.5, 0.0});
  world.furniture = {{"island", {box({1.4, 1.2}, {0.6, 0.4}, 0.0)}}};
  EdgeDrive drive(std::move(world));
  double first_loop = 0.0;
  double second_loop = 0.0;
  const Report report = drive.run(3600.0, [&](const Snapshot& now) {
    if (first_loop == 0.0 && drive.behavior.loops_closed() == 1) first_loop = now.frame.stamp;
    if (second_loop == 0.0 && drive.behavior.loops_closed() == 2) second_loop = now.frame.stamp;
  });
  EXPECT_GT(first_loop, 60.0);
  EXPECT_GT(second_loop, first_loop + 20.0);
  EXPECT_EQ(report.ended, Ended::Done);
  const MapScore score = drive.score();
  EXPECT_GE(score.wall_recall, 0.97);
  EXPECT_GE(score.wall_precision, 0.95);
  EXPECT_GE(score.coverage, 0.95);
}

TEST(EdgeFollowDriveTest, FollowsACliffWithoutDroppingAWheel) {
  World world = closed_room(3.0, 2.4, {0.6, 1.2, 0.0});
  world.cliffs = {box({2.5, 1.2}, {1.0, 1.2}, 0.0)};
  EdgeDrive drive(std::move(world));
  int over_cliff = 0;
  bool dropped = false;
  drive.run(400.0, [&](const Snapshot& now) {
    over_cliff += now.frame.cliff_flags != 0;
    dropped |= now.frame.wheel_dropped();
  });
  EXPECT_GT(over_cliff, 0) << "it met the cliff";
  EXPECT_FALSE(dropped);
  EXPECT_TRUE(drive.mapped({2.0, 1.2}, 0.08)) << "and mapped its edge";
}

TEST(EdgeFollowDriveTest, DoesNotCrossAVirtualWall) {
  World world = closed_room(4.0, 1.6, {0.8, 0.8, 0.1});
  world.virtual_walls = {{{2.5, 0.02, kPi / 2.0}, 1.58, 0.05}};
  EdgeDrive drive(std::move(world));
  bool seen = false;
  double farthest = 0.0;
  const Report report = drive.run(2400.0, [&](const Snapshot& now) {
    seen |= now.frame.virtual_wall;
    farthest = std::max(farthest, drive.pose().x);
  });
  EXPECT_TRUE(seen);
  EXPECT_LT(farthest, 2.5);
  EXPECT_NE(report.ended, Ended::Stuck);
}

TEST(EdgeFollowDriveTest, NeverBacksAgainstAWallForEver) {
  // Between a fence and a wall behind it there is little room to back off.
  World world = closed_room(1.6, 1.6, {0.5, 0.8, 0.0});
  world.virtual_walls = {{{0.9, 0.02, kPi / 2.0}, 1.58, 0.1}};
  EdgeDrive drive(std::move(world));
  double backing_since = 0.0;
  double longest = 0.0;
  drive.run(600.0, [&](const Snapshot& now) {
    if (now.decision.motion.linear >= 0.0) backing_since = now.frame.stamp;
    longest = std::max(longest, now.frame.stamp - backing_since);
  });
  EXPECT_GT(longest, 0.3) << "it does back off";
  EXPECT_LT(longest, 5.0);
}

TEST(EdgeFollowDriveTest, WithoutLightSensorsItBumpsItsWayAroundARoom) {
  sim::RobotSpec blind;
  blind.model.protocol = oi::Model::Create1;
  blind.model.has_light_sensors = false;
  EdgeDrive drive(closed_room(2.0, 1.6, {1.0, 0.8, 0.2}), {}, blind);
  double west = 2.0, east = 0.0, south = 1.6, north = 0.0;
  const Report report = drive.run(600.0, [&](const Snapshot&) {
    west = std::min(west, drive.pose().x);
    east = std::max(east, drive.pose().x);
    south = std::min(south, drive.pose().y);
    north = std::max(north, drive.pose().y);
  });
  EXPECT_GT(report.bumps, 20u);
  EXPECT_GE(drive.behavior.loops_closed(), 1);
  for (const double distance : {west, 2.0 - east, south, 1.6 - north}) EXPECT_LT(distance, 0.25);
  EXPECT_GE(drive.score().wall_recall, 0.7);
}

TEST(EdgeFollowDriveTest, TheSameSeedDrivesTheSameWay) {
  World world = closed_room(2.8, 2.4, {0.5, 0.5, 0.0});
  world.furniture = {{"island", {box({1.4, 1.2}, {0.6, 0.4}, 0.0)}}};
  std::vector<StampedPose> first;
  for (const std::uint64_t seed : {1u, 1u, 2u}) {
    EdgeDrive drive(world, {}, {}, seed);
    drive.run(400.0);
    if (first.empty()) first = drive.track.points();
    EXPECT_EQ(drive.track.points() == first, seed == 1);
  }
}

}  // namespace
}  // namespace scrubjay::test
