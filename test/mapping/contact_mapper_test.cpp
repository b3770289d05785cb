#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <scrubjay/error.hpp>
#include <scrubjay/mapping/contact_mapper.hpp>

namespace scrubjay {
namespace {

/// Drives a robot that feels and sees exactly within a room from -1 to 1 in x and y, in straight lines between walls.
class RoomDrive {
 public:
  explicit RoomDrive(const RobotModel& robot) : robot_(robot), mapper(robot, 0.05) {}

  void drive(int bounces) {
    Pose2 pose{0.0, 0.0, 0.3};
    for (int bounce = 0; bounce < bounces; ++bounce) {
      while (sense(pose), !frame_.bumped()) pose = pose * Pose2{0.005, 0.0, 0.0};
      pose = pose * Pose2{-0.05, 0.0, 0.0};
      sense(pose);
      for (int i = 0; i < 24; ++i) {
        pose.yaw = wrap_angle(pose.yaw + radians(5.3));
        sense(pose);
      }
    }
  }

 private:
  static double clearance(const Point2& p) { return 1.0 - p.cwiseAbs().maxCoeff(); }

  void sense(const Pose2& pose) {
    frame_ = {};
    for (std::size_t i = 0; i < frame_.light_signal.size(); ++i) {
      const Pose2 sensor = pose * robot_.light.mount[i];
      const Point2 beam = direction(sensor.yaw);
      const double range = std::min((std::copysign(1.0, beam.x()) - sensor.x) / beam.x(),
                                    (std::copysign(1.0, beam.y()) - sensor.y) / beam.y());
      const double signal = robot_.light.gain * std::exp(-robot_.light.attenuation * range) + robot_.light.ambient;
      frame_.light_signal[i] = static_cast<std::uint16_t>(std::lround(signal));
    }
    for (double bearing = -90.0; bearing <= 90.0; bearing += 1.0) {
      const Point2 shell = pose.position() + robot_.radius * direction(pose.yaw + radians(bearing));
      if (clearance(shell) > 0.0) continue;
      frame_.bump_left = frame_.bump_left || bearing > -30.0;
      frame_.bump_right = frame_.bump_right || bearing < 30.0;
    }
    PoseEstimate estimate;
    estimate.pose = pose;
    mapper.update(frame_, estimate);
  }

  RobotModel robot_;
  Frame frame_;

 public:
  ContactMapper mapper;
};

TEST(ContactMapperTest, KnowsNothingBeforeTheFirstFrame) {
  const ContactMapper mapper({}, 0.05);
  EXPECT_EQ(mapper.map().geometry.size(), 0u);
  EXPECT_EQ(mapper.occupancy().cells, std::vector<Occupancy>{kUnknown});
}

TEST(ContactMapperTest, MapsTheWallsOfARoomAndNothingElse) {
  RobotModel blind;
  blind.has_light_sensors = false;
  for (const RobotModel& robot : {RobotModel{}, blind}) {
    RoomDrive room(robot);
    room.drive(300);
    const OccupancyGrid grid = room.mapper.occupancy();
    int walls = 0;
    int free = 0;
    for (std::int32_t y = 0; y < grid.geometry.height; ++y) {
      for (std::int32_t x = 0; x < grid.geometry.width; ++x) {
        const Occupancy cell = grid.view()[{x, y}];
        const double beyond = grid.geometry.center({x, y}).cwiseAbs().maxCoeff() - 1.0;
        // Blind robots know only the half that was hit, and smear corners.
        if (cell == kOccupied) {
          EXPECT_NEAR(beyond, 0.0, robot.has_light_sensors ? 0.05 : 0.08);
          ++walls;
        } else if (cell == kFree) {
          EXPECT_LT(beyond, 0.03);
          ++free;
        }
      }
    }
    EXPECT_GT(walls, 60);   // of 160 cells around
    EXPECT_GT(free, 1000);  // of 1600
  }
}

TEST(ContactMapperTest, GrowsOnlyForFramesThatSaySomethingNew) {
  ContactMapper mapper({}, 0.05);
  PoseEstimate estimate;
  mapper.update({}, estimate);
  const GridGeometry before = mapper.map().geometry;
  estimate.pose.x = 0.01;
  for (int i = 0; i < 10; ++i) mapper.update({}, estimate);
  EXPECT_EQ(mapper.map().geometry, before);
  estimate.pose.x = 5.0;
  mapper.update({}, estimate);
  EXPECT_GT(mapper.map().geometry.size(), before.size());
  EXPECT_EQ(trinary(mapper.map()[mapper.map().geometry.cell_at({5.0, 0.0})]), kFree);
}

TEST(ContactMapperTest, RefusesAPoseThatWentAstray) {
  PoseEstimate astray;
  for (const double x : {1e6, std::numeric_limits<double>::quiet_NaN()}) {
    ContactMapper mapper({}, 0.05);
    astray.pose.x = x;
    EXPECT_THROW(mapper.update({}, astray), Error);
    ContactMapper begun({}, 0.05);
    begun.update({}, {});
    EXPECT_THROW(begun.update({}, astray), Error) << "x = " << x;
  }
}

}  // namespace
}  // namespace scrubjay
