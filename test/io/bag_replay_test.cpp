/// \file
/// A run, recorded as its messages, makes the same map again.
#include <gmock/gmock.h>

#include <scrubjay/io/bag_robot.hpp>
#include <scrubjay/io/robot_file.hpp>
#include <scrubjay/io/world_reader.hpp>
#include <scrubjay/localization/scan_matching.hpp>
#include <scrubjay/mapping/contact_mapper.hpp>
#include <scrubjay/mapping/lidar_mapper.hpp>
#include <scrubjay/robot/oi_robot.hpp>
#include <scrubjay/simulation/simulated_roomba.hpp>
#include <scrubjay/simulation/simulated_turtlebot.hpp>

#include "bag_maker.hpp"
#include "temporary_folder.hpp"

namespace scrubjay::test {
namespace {

constexpr double kResolution = 0.05;  // [m]

sim::RobotSpec our_robot(const std::string& name) {
  return read_robot(std::filesystem::path(SCRUBJAY_SOURCE_DIR) / "urdf" / (name + ".urdf"));
}

/// A robot in the room, with the noise of real ones.
struct Scene {
  World world = read_world(std::filesystem::path(SCRUBJAY_SOURCE_DIR) / "worlds/room.yaml");
  SegmentIndex index{solid_segments(world)};
  sim::NoiseProfile noise = read_noise(std::filesystem::path(SCRUBJAY_SOURCE_DIR) / "urdf/noise.yaml", "hard-floor");
  Pose2 start = world.start.value_or(Pose2{});
};

/// Backs off from what it bumps into, and else drives a curve.
Motion wandering(const Frame& frame, int tick, int& backing) {
  if (frame.bumped()) backing = 60;
  if (backing > 0) return backing-- > 30 ? Motion{-0.1, 0.0} : Motion{0.0, 1.5};
  return {0.15, 0.4 * ((tick / 200) % 3 - 1)};
}

/// Drives for some frames, recording what is published of each.
template <class Publish>
void run(Robot& robot, Localizer& localizer, Mapper& mapper, int frames, const Publish& publish) {
  int backing = 0;
  for (int tick = 0; tick < frames; ++tick) {
    const auto frame = robot.next();
    if (!frame) continue;
    mapper.update(*frame, localizer.update(*frame));
    publish(*frame);
    robot.drive(wandering(*frame, tick, backing));
  }
}

int replay(const std::filesystem::path& bag, Localizer& localizer, Mapper& mapper) {
  BagRobot robot(bag, find_senses(bag));
  int frames = 0;
  while (const auto frame = robot.next()) {
    ++frames;
    mapper.update(*frame, localizer.update(*frame));
  }
  EXPECT_EQ(robot.left_out(), 0U);
  return frames;
}

/// How many cells differ, of maps that are equally large.
std::size_t different_cells(const OccupancyGrid& a, const OccupancyGrid& b) {
  EXPECT_EQ(a.geometry, b.geometry);
  std::size_t different = 0;
  for (std::size_t i = 0; i < std::min(a.cells.size(), b.cells.size()); ++i) different += a.cells[i] != b.cells[i];
  return different;
}

class BagReplayTest : public testing::TestWithParam<const char*> {
 protected:
  const TemporaryFolder folder_{};
  const std::filesystem::path bag_ = folder_ / GetParam();
  const Scene scene_{};
};

TEST_P(BagReplayTest, OfALidarMakesTheSameMap) {
  const sim::RobotSpec spec = our_robot("turtlebot3_burger");
  const RobotModel& model = spec.model;
  LidarMapper live(model, kResolution);
  {
    sim::SimulatedTurtlebot robot(scene_.world, scene_.index, spec, scene_.noise, Random(1), scene_.start, {true});
    DeadReckoning wheels(model.drive);
    ScanMatching localizer(model, live);
    BagMaker bag(bag_);
    const Pose2& mount = model.lidar->mount;
    bag.add("/tf_static", 0.0, ros::TFMessage{{transform_at(0.0, "base_footprint", "base_scan", mount)}});
    run(robot, localizer, live, 1'500, [&](const Frame& frame) {
      bag.add("/odom", frame.stamp, odometry_at(frame.stamp, wheels.update(frame).pose));
      if (!frame.scan) return;
      bag.add("/scan", frame.stamp, ros::scan_message(header_at(frame.scan->stamp, "base_scan"), *frame.scan));
    });
  }
  const RobotModel told = robot_of(find_senses(bag_), model);
  EXPECT_EQ(told.lidar->mount, model.lidar->mount);
  LidarMapper again(told, kResolution);
  ScanMatching localizer(told, again);
  EXPECT_EQ(replay(bag_, localizer, again), 1'500);
  EXPECT_EQ(different_cells(live.occupancy(), again.occupancy()), 0U);
}

TEST_P(BagReplayTest, OfABumperMakesTheSameMap) {
  const sim::RobotSpec spec = our_robot("roomba_600");
  const RobotModel& model = spec.model;
  ContactMapper live(model, kResolution);
  int frames = 0;
  int bumps = 0;
  {
    sim::SimulatedRoomba roomba(scene_.world, scene_.index, spec, scene_.noise, Random(1), scene_.start);
    OiRobot robot(roomba, model);
    DeadReckoning localizer(model.drive);
    DeadReckoning wheels(model.drive);
    BagMaker bag(bag_);
    run(robot, localizer, live, 4'000, [&](const Frame& frame) {
      ++frames;
      bumps += frame.bumped();
      bag.add("/odom", frame.stamp, odometry_at(frame.stamp, wheels.update(frame).pose));
      bag.add("/bumper", frame.stamp, ros::bumper_message(header_at(frame.stamp), frame));
      bag.add("/cliff", frame.stamp, ros::cliff_message(header_at(frame.stamp), frame));
    });
  }
  EXPECT_GT(bumps, 10) << "or this says little";
  const RobotModel told = robot_of(find_senses(bag_), model);
  ContactMapper again(told, kResolution);
  DeadReckoning localizer(told.drive);
  EXPECT_EQ(replay(bag_, localizer, again), frames);
  EXPECT_EQ(different_cells(live.occupancy(), again.occupancy()), 0U);
}

INSTANTIATE_TEST_SUITE_P(Formats, BagReplayTest, testing::Values("run.mcap", "run"));

}  // namespace
}  // namespace scrubjay::test
