#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <scrubjay/geometry/random.hpp>

#include "messages/publications_fixture.hpp"

namespace scrubjay::ros {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::Key;
using testing::Not;

TEST_F(PublicationsTest, TellsOdometryAndTransformsWithEveryFrame) {
  begin();
  for (int i = 0; i < 10; ++i) {
    frame_.left_travel = frame_.right_travel = 0.01;
    tick();
  }
  const auto odom = kept_.of(kOdomTopic);
  ASSERT_EQ(odom.size(), 10u);
  EXPECT_NEAR(odom.back().pose.pose.position.x, 0.1, 1e-9);
  EXPECT_EQ(odom.back().header.frame_id, "odom");
  EXPECT_EQ(odom.back().child_frame_id, "base_link");
  EXPECT_EQ(to_nanoseconds(odom.front().header.stamp), 15'000'000);
  EXPECT_EQ(kept_.of(kTfTopic).size(), 10u);
}

TEST_F(PublicationsTest, PutsWhatTheLocalizerKnowsBetterBetweenMapAndOdom) {
  begin();
  frame_.left_travel = frame_.right_travel = 0.1;
  estimate_.pose = {1.0, 2.0, radians(90.0)};
  tick();
  const TFMessage tf = kept_.of(kTfTopic).at(0);
  ASSERT_EQ(tf.transforms.size(), 2u);
  EXPECT_EQ(tf.transforms[0].header.frame_id, "map");
  EXPECT_EQ(tf.transforms[0].child_frame_id, "odom");
  const Pose2 base = pose_of(tf.transforms[0].transform) * pose_of(tf.transforms[1].transform);
  EXPECT_NEAR(base.x, 1.0, 1e-9);
  EXPECT_NEAR(base.y, 2.0, 1e-9);
  EXPECT_NEAR(base.yaw, radians(90.0), 1e-9);
}

TEST_F(PublicationsTest, CountsTimeFromTheEpoch) {
  PublicationParams params;
  params.epoch = 1'700'000'000'000'000'000;
  begin({}, params);
  tick();
  EXPECT_THAT(kept_.stamps().at("odom"), ElementsAre(1'700'000'000'015'000'000));
  EXPECT_EQ(kept_.of(kOdomTopic).at(0).header.stamp, (Time{1'700'000'000, 15'000'000}));
}

TEST_F(PublicationsTest, CountsFromTheSystemsClockUnlessItIsTold) {
  publications_.emplace(RobotModel{}, PublicationParams{}, std::vector<MessageSink*>{&kept_});
  const auto before = std::chrono::nanoseconds(std::chrono::system_clock::now().time_since_epoch()).count();
  ticks(2);
  const auto& stamps = kept_.stamps().at("odom");
  EXPECT_GE(stamps[0], before);
  EXPECT_EQ(stamps[1] - stamps[0], 15'000'000);
}

TEST_F(PublicationsTest, HasAClockInASimulationAlone) {
  begin();
  tick();
  EXPECT_THAT(kept_.stamps(), Not(Contains(Key("/clock"))));
  PublicationParams params;
  params.simulated = true;
  begin({}, params);
  tick();
  EXPECT_THAT(kept_.of(kClockTopic), ElementsAre(Clock{{0, 30'000'000}}));
}

TEST_F(PublicationsTest, TellsAllThatIsFixedOnceAndInOneMessage) {
  RobotModel robot;
  robot.lidar.emplace();
  PublicationParams params;
  params.description = "<robot/>";
  params.fixed = {{"base_link", "cliff_left", transform_message({0.1, 0.2, 0.0})}};
  begin(robot, params);
  ticks(3);
  const auto fixed = kept_.of(kTfStaticTopic);
  ASSERT_EQ(fixed.size(), 1u);
  ASSERT_EQ(fixed[0].transforms.size(), 2u);
  EXPECT_EQ(fixed[0].transforms[0].child_frame_id, "base_scan");
  EXPECT_NEAR(fixed[0].transforms[0].transform.translation.x, -0.032, 1e-12);
  EXPECT_EQ(fixed[0].transforms[1].child_frame_id, "cliff_left");
  EXPECT_THAT(kept_.of(kRobotDescriptionTopic), ElementsAre(String{"<robot/>"}));
}

TEST_F(PublicationsTest, TurnsWheelsAsTheyRoll) {
  PublicationParams params;
  params.left = WheelLink{"left_wheel_joint", {"base_link", "left_wheel", {}}};
  params.right = WheelLink{"right_wheel_joint", {"base_link", "right_wheel", {}}};
  begin({}, params);
  frame_.left_travel = 0.036;
  frame_.right_travel = -0.036;
  tick();
  const JointState joints = kept_.of(kJointStatesTopic).at(0);
  EXPECT_THAT(joints.name, ElementsAre("left_wheel_joint", "right_wheel_joint"));
  EXPECT_THAT(joints.position, ElementsAre(testing::DoubleNear(1.0, 1e-9), testing::DoubleNear(-1.0, 1e-9)));
  const TFMessage wheels = kept_.of(kTfTopic).at(1);
  EXPECT_EQ(wheels.transforms.at(0).child_frame_id, "left_wheel");
  EXPECT_NEAR(wheels.transforms.at(0).transform.rotation.y, sin(0.5), 1e-9);
}

TEST_F(PublicationsTest, TellsWhatARoombaFeels) {
  begin();
  frame_.bump_left = true;
  frame_.cliff_flags = 1;
  frame_.infrared_omni = 161;
  ticks(2);
  EXPECT_TRUE(kept_.of(kBumperTopic).at(0).is_left_pressed);
  EXPECT_TRUE(kept_.of(kCliffTopic).at(0).is_cliff_left);
  EXPECT_THAT(kept_.of(kIrOmniTopic), ElementsAre(UInt16{161}));  // and doesn't repeat it
}

TEST_F(PublicationsTest, TellsADroppedWheelWhenItDrops) {
  begin();
  tick();
  frame_.wheel_drop_left = true;
  ticks(5);
  frame_.wheel_drop_left = false;
  tick();
  frame_.wheel_drop_right = true;
  tick();
  EXPECT_EQ(kept_.of(kWheeldropTopic).size(), 2u);
}

TEST_F(PublicationsTest, SaysNothingOfBumpersThatALidarRobotHasNot) {
  RobotModel robot;
  robot.open_interface = false;
  begin(robot);
  tick();
  for (const char* topic : {"bumper", "cliff", "mode", "battery_state"}) {
    EXPECT_THAT(kept_.stamps(), Not(Contains(Key(topic))));
  }
}

TEST_F(PublicationsTest, TellsWhatIsSlowOnceASecondAndWhenItChanges) {
  begin();
  ticks(200);  // 3 s
  EXPECT_EQ(kept_.of(kModeTopic).size(), 3u);
  EXPECT_EQ(kept_.of(kBatteryStateTopic).size(), 3u);
  EXPECT_EQ(kept_.of(kDiagnosticsTopic).size(), 3u);
  kept_.forget();
  frame_.mode = oi::OiMode::Safe;
  tick();
  ASSERT_EQ(kept_.of(kModeTopic).size(), 1u);
  EXPECT_EQ(kept_.of(kModeTopic)[0].mode, 2);
}

TEST_F(PublicationsTest, PassesAScanOnWithItsOwnStamp) {
  RobotModel robot;
  robot.open_interface = false;
  robot.lidar.emplace();
  begin(robot);
  const std::vector<float> ranges(360, 1.5F);
  frame_.scan.emplace();
  frame_.scan->stamp = 0.25;
  frame_.scan->ranges = ranges;
  tick();
  frame_.scan.reset();
  tick();
  const auto scans = kept_.of(kScanTopic);
  ASSERT_EQ(scans.size(), 1u);
  EXPECT_EQ(scans[0].header.stamp, (Time{0, 250'000'000}));
  EXPECT_EQ(scans[0].header.frame_id, "base_scan");
  EXPECT_EQ(scans[0].ranges, ranges);
}

TEST_F(PublicationsTest, SendsAMapWholeWhenItGrewAndItsChangesOtherwise) {
  begin();
  mark({0.025, 0.025}, -100);
  mark({1.025, 1.025}, 100);
  tick();
  ASSERT_EQ(kept_.of(kMapTopic).size(), 1u);
  EXPECT_EQ(kept_.of(kMapTopic)[0].data.front(), 0);
  EXPECT_EQ(kept_.of(kMapTopic)[0].data.back(), 100);
  mark({0.525, 0.525}, 100);
  ticks(70);
  EXPECT_EQ(kept_.of(kMapTopic).size(), 1u);
  const auto updates = kept_.of(kMapUpdatesTopic);
  ASSERT_EQ(updates.size(), 1u);
  EXPECT_EQ(updates[0].x, 10);
  EXPECT_EQ(updates[0].y, 10);
  EXPECT_THAT(updates[0].data, ElementsAre(100));
  mark({-2.975, 0.0}, 100);
  ticks(70);
  EXPECT_EQ(kept_.of(kMapTopic).size(), 2u);
  EXPECT_NEAR(kept_.of(kMapTopic).back().info.origin.position.x, -3.0, 1e-9);
}

TEST_F(PublicationsTest, SendsNoWholeMapForCellsThatMayHaveChangedAndHaveNot) {
  begin();
  mark({0.025, 0.025}, -100);
  mark({1.025, 1.025}, 100);
  tick();
  mark({0.525, 0.525}, 100);
  changed_ = cells_of(map_.view().geometry);  // far beyond all that is known
  ticks(70);
  EXPECT_EQ(kept_.of(kMapTopic).size(), 1u);
  const auto updates = kept_.of(kMapUpdatesTopic);
  ASSERT_EQ(updates.size(), 1u);
  EXPECT_EQ(updates[0].data.size(), kept_.of(kMapTopic)[0].data.size());
}

TEST_F(PublicationsTest, SendsNoMapThatDidntChange) {
  begin();
  mark({0.0, 0.0}, 100);
  ticks(1000);
  EXPECT_EQ(kept_.of(kMapTopic).size(), 1u);
  EXPECT_EQ(kept_.of(kMapUpdatesTopic).size(), 0u);
}

TEST_F(PublicationsTest, AMapAndItsUpdatesMakeTheMapThatThereIs) {
  begin();
  Random random(5);
  OccupancyGrid together;
  std::size_t maps = 0;
  std::size_t updates = 0;
  for (int i = 0; i < 40; ++i) {
    const double reach = 0.5 + 0.05 * i;
    for (int j = 0; j < 5; ++j) {
      const double x = random.uniform(-reach, reach);
      mark({x, random.uniform(-reach, reach)}, static_cast<LogOdds>(random.uniform() < 0.5 ? 100 : -100));
    }
    ticks(67);
    if (const auto all = kept_.of(kMapTopic); all.size() > maps) {
      maps = all.size();
      together = all.back();
    }
    if (const auto all = kept_.of(kMapUpdatesTopic); all.size() > updates) {
      updates = all.size();
      const OccupancyGridUpdate& part = all.back();
      for (std::uint32_t y = 0; y < part.height; ++y) {
        for (std::uint32_t x = 0; x < part.width; ++x) {
          const std::size_t at =
              (static_cast<std::size_t>(part.y) + y) * together.info.width + static_cast<std::size_t>(part.x) + x;
          together.data.at(at) = part.data[y * part.width + x];
        }
      }
    }
  }
  EXPECT_GT(updates, 3u);
  EXPECT_GT(maps, 3u);
  publications_->finish(std::as_const(map_).view());
  EXPECT_EQ(together.data, kept_.of(kMapTopic).back().data);
}

TEST_F(PublicationsTest, TellsTheRoomsOfAWholeMapWhereTheyChangedAndNotTooOften) {
  const auto rooms_told = [this] { return kept_.of(kRoomsTopic).size(); };
  begin();
  mark_floor({0.0, 0.0}, {3.0, 2.0});
  tick();
  ASSERT_EQ(rooms_told(), 1u);
  const std::vector<Marker> one = kept_.of(kRoomsTopic)[0].markers;
  ASSERT_EQ(one.size(), 3u);
  EXPECT_EQ(one[0].action, Marker::kDeleteAll);
  EXPECT_EQ(one[1].header.frame_id, "map");
  EXPECT_EQ(one[2].text, "1: 6.0 m2");

  mark_floor({5.0, 0.0}, {7.0, 2.0});
  ticks(600);  // 9 s: the map was whole again, as it grew
  EXPECT_EQ(kept_.of(kMapTopic).size(), 2u);
  EXPECT_EQ(rooms_told(), 1u);
  ticks(100);
  ASSERT_EQ(rooms_told(), 2u);
  EXPECT_EQ(kept_.of(kRoomsTopic)[1].markers.size(), 5u);

  mark({5.0, 2.5}, 100);
  ticks(1000);
  EXPECT_EQ(kept_.of(kMapTopic).size(), 3u);
  EXPECT_EQ(rooms_told(), 2u) << "nothing changed in them";
  publications_->finish(std::as_const(map_).view());
  EXPECT_EQ(rooms_told(), 2u);
}

TEST_F(PublicationsTest, TellsOfRoomsAtTheEndAndTakesAwayThoseThatAreNoMore) {
  begin();
  tick();
  publications_->finish(std::as_const(map_).view());
  EXPECT_EQ(kept_.of(kRoomsTopic).size(), 0u) << "there never were any";
  mark_floor({0.0, 0.0}, {3.0, 2.0});
  publications_->finish(std::as_const(map_).view());
  EXPECT_EQ(kept_.of(kRoomsTopic).size(), 1u);
  mark_floor({0.0, 0.0}, {3.0, 2.0}, 100);
  publications_->finish(std::as_const(map_).view());
  ASSERT_EQ(kept_.of(kRoomsTopic).size(), 2u);
  EXPECT_EQ(kept_.of(kRoomsTopic)[1].markers.size(), 1u);
}

TEST_F(PublicationsTest, TellsWhereItWentAndWhereItMeansToGo) {
  begin();
  plan_ = {{0.0, 0.0}, {1.0, 0.0}};
  leftovers_ = {{{2.0, 1.0}, 0.5, "not yet"}};
  for (int i = 0; i < 100; ++i) {
    estimate_.pose.x += 0.01;
    tick();
  }
  EXPECT_EQ(kept_.of(kPlanTopic).size(), 1u);  // it didn't change
  EXPECT_EQ(kept_.of(kPlanTopic)[0].poses.size(), 2u);
  EXPECT_EQ(kept_.of(kFrontiersTopic).at(0).markers.at(0).points, (std::vector<Point>{{2.0, 1.0, 0.0}}));
  publications_->finish(std::as_const(map_).view());
  EXPECT_NEAR(static_cast<double>(kept_.of(kPathTopic).back().poses.size()), 20.0, 1.0);
}

TEST_F(PublicationsTest, GivesEverySinkTheSameBytes) {
  KeptMessages other;
  publications_.emplace(RobotModel{}, PublicationParams{}, std::vector<MessageSink*>{&kept_, &other});
  ticks(5);
  EXPECT_EQ(kept_.of(kOdomTopic), other.of(kOdomTopic));
  EXPECT_EQ(kept_.stamps(), other.stamps());
}

}  // namespace
}  // namespace scrubjay::ros
