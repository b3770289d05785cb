#include <gmock/gmock.h>

#include <scrubjay/io/bag_robot.hpp>

#include "bag_maker.hpp"
#include "temporary_folder.hpp"

namespace scrubjay::test {
namespace {

using testing::HasSubstr;

class BagSensesTest : public testing::Test {
 protected:
  BagMaker make() const { return BagMaker(bag_); }
  std::string error(std::string_view robot_namespace = "") const {
    return message_of([&] { find_senses(bag_, robot_namespace); });
  }

  const TemporaryFolder folder_;
  const std::filesystem::path bag_ = folder_ / "run.mcap";
};

TEST_F(BagSensesTest, MountTheLidarWhereTheTransformsHaveIt) {
  {
    BagMaker bag = make();
    bag.add("/odom", 1.0, odometry_at(1.0, {}));
    bag.add("/scan", 1.0, scan_at(1.0));
    bag.add("/tf_static", 1.1,
            ros::TFMessage{{transform_at(0.0, "base_footprint", "base_link", {0.5, 0.0, 0.5 * kPi}),
                            transform_at(0.0, "base_link", "base_scan", {0.25, 0.0, 0.5 * kPi})}});
  }
  const BagSenses senses = find_senses(bag_);
  ASSERT_TRUE(senses.lidar && senses.mount_known);
  EXPECT_NEAR(senses.lidar->mount.x, 0.5, 1e-12);
  EXPECT_NEAR(senses.lidar->mount.y, 0.25, 1e-12);
  EXPECT_NEAR(std::abs(senses.lidar->mount.yaw), kPi, 1e-12);
  EXPECT_EQ(senses.lidar->beams, 4);
  EXPECT_EQ(senses.lidar->max_range, 3.5);
  EXPECT_EQ(senses.lidar->clear_range, 0.0) << "what doesn't come back says nothing";
}

TEST_F(BagSensesTest, MountItOnTheBaseThatThereIsIfTheOdometryHasAnother) {
  {
    BagMaker bag = make();
    bag.add("/odom", 1.0, odometry_at(1.0, {}));
    bag.add("/tf_static", 1.0, ros::TFMessage{{transform_at(0.0, "base_link", "base_scan", {0.25, 0.0, 0.0})}});
    bag.add("/scan", 1.0, scan_at(1.0));
  }
  EXPECT_EQ(find_senses(bag_).lidar->mount, (Pose2{0.25, 0.0, 0.0}));
}

TEST_F(BagSensesTest, TakeALidarThatNothingTellsOfToBeInTheMiddle) {
  {
    BagMaker bag = make();
    bag.add("/odom", 1.0, odometry_at(1.0, {}));
    // In a circle.
    bag.add("/tf_static", 1.0,
            ros::TFMessage{{transform_at(0.0, "base_scan", "a", {}), transform_at(0.0, "a", "base_scan", {})}});
    bag.add("/scan", 1.0, scan_at(1.0));
  }
  const BagSenses senses = find_senses(bag_);
  EXPECT_FALSE(senses.mount_known);
  EXPECT_EQ(senses.lidar->mount, Pose2{});
}

TEST_F(BagSensesTest, RefuseALidarThatLooksAslant) {
  {
    BagMaker bag = make();
    bag.add("/odom", 1.0, odometry_at(1.0, {}));
    ros::TransformStamped aslant = transform_at(0.0, "base_footprint", "base_scan", {});
    aslant.transform.rotation = {0.0, 0.5, 0.0, 0.5};  // a quarter turn about y, not normalized
    bag.add("/tf_static", 1.0, ros::TFMessage{{aslant}});
    bag.add("/scan", 1.0, scan_at(1.0));
  }
  EXPECT_EQ(error(), bag_.string() + ": /scan is no scan of the plane: its lidar is mounted aslant on base_footprint");
}

TEST_F(BagSensesTest, FindTopicsByTypeWhateverTheirNames) {
  {
    BagMaker bag = make();
    bag.add("/front/lidar", 1.0, scan_at(1.0));
    bag.add("/wheels", 1.0, odometry_at(1.0, {}));
    bag.add("/robot_description", 1.0, ros::String{"<robot name=\"a\"/>"});
  }
  const BagSenses senses = find_senses(bag_);
  EXPECT_EQ(senses.scan, "/front/lidar");
  EXPECT_EQ(senses.odometry, "/wheels");
  EXPECT_EQ(senses.description, "<robot name=\"a\"/>");
  EXPECT_EQ(senses.bumper, "");
}

TEST_F(BagSensesTest, PreferTheTopicsThatAreCalledAsUsual) {
  {
    BagMaker bag = make();
    for (const std::string topic : {"/scan_filtered", "/scan"}) bag.add(topic, 1.0, scan_at(1.0));
    for (const std::string topic : {"/odometry/filtered", "/odom"}) bag.add(topic, 1.0, odometry_at(1.0, {}));
  }
  EXPECT_EQ(find_senses(bag_).scan, "/scan");
  EXPECT_EQ(find_senses(bag_).odometry, "/odom");
}

TEST_F(BagSensesTest, TakeOneRobotOfSeveral) {
  {
    BagMaker bag = make();
    for (const std::string robot : {"/robot1", "/robot2"}) {
      bag.add(robot + "/scan", 1.0, scan_at(1.0));
      bag.add(robot + "/odom", 1.0, odometry_at(1.0, {}));
      bag.add(robot + "/tf_static", 1.0, ros::TFMessage{});
    }
  }
  for (const std::string name : {"/robot2", "robot2", "/robot2/"}) {
    EXPECT_EQ(find_senses(bag_, name).scan, "/robot2/scan");
    EXPECT_EQ(find_senses(bag_, name).odometry, "/robot2/odom");
  }
  EXPECT_EQ(error(), bag_.string() +
                         ": has several topics of type sensor_msgs/msg/LaserScan: /robot1/scan, /robot2/scan; want "
                         "the namespace of one of them");
  EXPECT_THAT(error("/robot"), HasSubstr("has no topic of type sensor_msgs/msg/LaserScan or create_msgs/msg/Bumper "
                                         "within /robot; it has: /robot1/scan (sensor_msgs/msg/LaserScan), "));
}

TEST_F(BagSensesTest, SayWhatIsMissing) {
  make().add("/chatter", 1.0, ros::String{"hello"});
  EXPECT_EQ(error(), bag_.string() +
                         ": has no topic of type sensor_msgs/msg/LaserScan or create_msgs/msg/Bumper; it has: "
                         "/chatter (std_msgs/msg/String)");
  make().add("/scan", 1.0, scan_at(1.0));
  EXPECT_EQ(error(), bag_.string() +
                         ": has no topic of type nav_msgs/msg/Odometry or tf2_msgs/msg/TFMessage; it has: /scan "
                         "(sensor_msgs/msg/LaserScan)");
  {
    BagMaker bag = make();
    bag.add("/scan", 1.0, scan_at(1.0));
    bag.add("/tf", 1.0, ros::TFMessage{{transform_at(1.0, "map", "base_link", {})}});
  }
  EXPECT_EQ(error(), bag_.string() + ": /tf tells no odometry; want transforms from a frame odom");
  {
    BagMaker bag = make();
    bag.add("/scan", 1.0, scan_at(1.0, {1.0F}));
    bag.add("/odom", 1.0, odometry_at(1.0, {}));
  }
  EXPECT_EQ(error(), bag_.string() + ": /scan has no message that is a scan");
}

TEST_F(BagSensesTest, MakeABodyWithTheLidarOfTheBag) {
  {
    BagMaker bag = make();
    bag.add("/scan", 1.0, scan_at(1.0));
    bag.add("/odom", 1.0, odometry_at(1.0, {}));
  }
  const BagSenses senses = find_senses(bag_);
  RobotModel body;
  body.radius = 0.3;
  const RobotModel plain = robot_of(senses, body);
  EXPECT_EQ(plain.radius, 0.3);
  EXPECT_FALSE(plain.open_interface || plain.has_light_sensors) << "there is no bumper";
  EXPECT_EQ(plain.lidar->clear_range, 0.0);
  body.lidar = LidarModel{};
  const RobotModel known = robot_of(senses, body);
  EXPECT_EQ(known.lidar->beams, 4);
  EXPECT_EQ(known.lidar->clear_range, 3.5);
  EXPECT_EQ(known.lidar->mount.x, -0.032) << "the bag doesn't tell better";
}

TEST_F(BagSensesTest, KeepTheBumperAndNoLidarWithoutScans) {
  {
    BagMaker bag = make();
    bag.add("/bumper", 1.0, ros::Bumper{});
    bag.add("/odom", 1.0, odometry_at(1.0, {}));
  }
  RobotModel body;
  body.lidar = LidarModel{};
  const RobotModel model = robot_of(find_senses(bag_), body);
  EXPECT_TRUE(model.open_interface && model.has_light_sensors);
  EXPECT_FALSE(model.lidar);
}

}  // namespace
}  // namespace scrubjay::test
