#include <gmock/gmock.h>

#include <regex>
#include <scrubjay/error.hpp>
#include <scrubjay/io/robot_file.hpp>

#include "source_tree.hpp"
#include "temporary_folder.hpp"

namespace scrubjay {
namespace {

using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;

/// The least that a robot is made of.
constexpr const char* kBody = R"(<?xml version="1.0"?>
<robot name="tiny">
  <link name="base_link">
    <inertial><mass value="2"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>
    <collision><geometry><cylinder radius="0.1" length="0.05"/></geometry></collision>
  </link>
  <link name="left_wheel"><visual><geometry><cylinder radius="0.03" length="0.02"/></geometry></visual></link>
  <joint name="left_wheel_joint" type="continuous">
    <parent link="base_link"/><child link="left_wheel"/><origin xyz="0 0.08 0.03"/>
  </joint>
  <link name="right_wheel"><visual><geometry><cylinder radius="0.03" length="0.02"/></geometry></visual></link>
  <joint name="right_wheel_joint" type="continuous">
    <parent link="base_link"/><child link="right_wheel"/><origin xyz="0 -0.08 0.03"/>
  </joint>
</robot>
)";

class RobotFileTest : public ::testing::Test {
 protected:
  std::filesystem::path write_body(const std::string& urdf) const { return folder_.write("robot.urdf", urdf); }
  /// The tiny robot, with something of its text replaced.
  std::filesystem::path write_changed(const std::string& from, const std::string& to) const {
    return write_body(std::regex_replace(std::string(kBody), std::regex(from), to));
  }
  std::string details_error(const std::string& yaml) const {
    const auto urdf = write_body(kBody);
    folder_.write("robot.yaml", yaml);
    return message_of([&] { read_robot(urdf); });
  }

  TemporaryFolder folder_;
};

TEST_F(RobotFileTest, ReadsTheRoomba600AsTheCoreKnowsIt) {
  const sim::RobotSpec spec = read_robot(in_tree("urdf/roomba_600.urdf"));
  const sim::RobotSpec known;
  EXPECT_EQ(spec.name, "roomba_600");
  EXPECT_EQ(spec.model.protocol, oi::Model::Create2);
  EXPECT_NEAR(spec.model.radius, known.model.radius, 1e-9);
  EXPECT_NEAR(spec.model.drive.wheel_separation, known.model.drive.wheel_separation, 1e-9);
  EXPECT_NEAR(spec.model.drive.wheel_radius, known.model.drive.wheel_radius, 1e-9);
  EXPECT_NEAR(spec.model.drive.counts_per_turn, known.model.drive.counts_per_turn, 1e-9);
  EXPECT_NEAR(spec.mass, known.mass, 1e-9);
  ASSERT_TRUE(spec.model.has_light_sensors);
  for (std::size_t i = 0; i < kLightSensorCount; ++i) {
    EXPECT_NEAR(spec.model.light.mount[i].x, known.model.light.mount[i].x, 1e-5) << i;
    EXPECT_NEAR(spec.model.light.mount[i].y, known.model.light.mount[i].y, 1e-5) << i;
    EXPECT_NEAR(spec.model.light.mount[i].yaw, known.model.light.mount[i].yaw, 1e-5) << i;
  }
  EXPECT_NEAR(spec.model.light.attenuation, known.model.light.attenuation, 1e-9);
  EXPECT_NEAR(spec.model.bumper.half_from, known.model.bumper.half_from, 1e-5);
  for (std::size_t i = 0; i < kCliffSensorCount; ++i) {
    EXPECT_NEAR((spec.model.cliff_sensors[i] - known.model.cliff_sensors[i]).norm(), 0.0, 1e-5) << i;
  }
  EXPECT_NEAR(spec.wall.mount.yaw, known.wall.mount.yaw, 1e-4);
  EXPECT_NEAR(spec.wall.max_range, known.wall.max_range, 1e-9);
  EXPECT_NEAR(spec.infrared.receiver.x(), known.infrared.receiver.x(), 1e-5);
  EXPECT_NEAR(spec.battery.capacity, known.battery.capacity, 1e-9);
}

TEST_F(RobotFileTest, ReadsTheCreate1) {
  const sim::RobotSpec spec = read_robot(in_tree("urdf/create_1.urdf"));
  EXPECT_EQ(spec.model.protocol, oi::Model::Create1);
  EXPECT_FALSE(spec.model.has_light_sensors);
  EXPECT_EQ(spec.wall.max_signal, 4095.0);
}

TEST_F(RobotFileTest, ReadsTheTurtlebot3Burger) {
  const sim::RobotSpec spec = read_robot(in_tree("urdf/turtlebot3_burger.urdf"));
  EXPECT_EQ(spec.name, "turtlebot3_burger");
  EXPECT_FALSE(spec.model.open_interface);
  EXPECT_FALSE(spec.model.has_light_sensors);
  EXPECT_EQ(spec.model.radius, 0.105);
  EXPECT_NEAR(spec.model.drive.wheel_separation, 0.160, 1e-12);
  EXPECT_EQ(spec.model.drive.wheel_radius, 0.033);
  EXPECT_EQ(spec.model.drive.counts_per_turn, 4096.0);
  EXPECT_EQ(spec.model.max_linear_speed, 0.22);
  EXPECT_EQ(spec.model.max_angular_speed, 2.84);
  EXPECT_GE(spec.model.max_wheel_speed, 0.5 * 2.84 * 0.160 - 1e-12) << "or it couldn't turn as fast";
  EXPECT_EQ(spec.mass, 1.0);
  ASSERT_TRUE(spec.model.lidar);
  const LidarModel& lidar = *spec.model.lidar;
  const LidarModel known;
  EXPECT_EQ(lidar.mount, known.mount);
  EXPECT_EQ(lidar.beams, known.beams);
  EXPECT_EQ(lidar.angle_min, known.angle_min);
  EXPECT_NEAR(lidar.angle_increment, known.angle_increment, 1e-15);
  EXPECT_EQ(lidar.scan_time, known.scan_time);
  EXPECT_EQ(lidar.min_range, known.min_range);
  EXPECT_EQ(lidar.max_range, known.max_range);
  EXPECT_EQ(lidar.clear_range, known.clear_range);
}

TEST_F(RobotFileTest, TakesTheBodyFromTheUrdf) {
  const sim::RobotSpec spec = read_robot(write_body(kBody));
  EXPECT_EQ(spec.name, "tiny");
  EXPECT_EQ(spec.model.radius, 0.1);
  EXPECT_EQ(spec.model.drive.wheel_radius, 0.03);
  EXPECT_NEAR(spec.model.drive.wheel_separation, 0.16, 1e-12);
  EXPECT_NEAR(spec.wheel_drop_offset, 0.08, 1e-12);
  EXPECT_EQ(spec.mass, 2.0);
  EXPECT_FALSE(spec.model.has_light_sensors);
  EXPECT_EQ(spec.model.drive.counts_per_turn, 508.8) << "what no file says is as on a Roomba 600";
}

TEST_F(RobotFileTest, TakesTheRestFromTheYamlBesideIt) {
  const auto urdf = write_body(kBody);
  folder_.write("robot.yaml",
                "protocol: roomba-400\ncounts_per_turn: 100\nlight: {gain: 2000, ambient: 0}\n"
                "bumper: {half_from: -0.1}\nwall: {max_range: 0.1}\ninfrared: {force_field: 0.3}\n"
                "battery: {capacity: 3}\n");
  const sim::RobotSpec spec = read_robot(urdf);
  EXPECT_EQ(spec.model.protocol, oi::Model::Roomba400);
  EXPECT_EQ(spec.model.drive.counts_per_turn, 100.0);
  EXPECT_EQ(spec.model.light.gain, 2000.0);
  EXPECT_EQ(spec.model.light.ambient, 0.0);
  EXPECT_EQ(spec.model.light.attenuation, 26.83);
  EXPECT_EQ(spec.model.bumper.half_from, -0.1);
  EXPECT_EQ(spec.wall.max_range, 0.1);
  EXPECT_EQ(spec.infrared.force_field, 0.3);
  EXPECT_EQ(spec.battery.capacity, 3.0);
}

TEST_F(RobotFileTest, PlacesLinksThroughTheirParents) {
  const std::string chain = R"(  <link name="bumper"/>
  <joint name="bumper_joint" type="fixed">
    <parent link="base_link"/><child link="bumper"/><origin xyz="0.05 0.01 0" rpy="0 0 1.5707963267948966"/>
  </joint>
  <link name="infrared_receiver"/>
  <joint name="infrared_receiver_joint" type="fixed">
    <parent link="bumper"/><child link="infrared_receiver"/><origin xyz="0.02 0 0.1"/>
  </joint>
</robot>)";
  const sim::RobotSpec spec = read_robot(write_changed("</robot>", chain));
  EXPECT_NEAR(spec.infrared.receiver.x(), 0.05, 1e-9);
  EXPECT_NEAR(spec.infrared.receiver.y(), 0.03, 1e-9);
}

/// The tiny robot with a lidar on its back.
constexpr const char* kLidar = R"(  <link name="base_scan"/>
  <joint name="base_scan_joint" type="fixed">
    <parent link="base_link"/><child link="base_scan"/><origin xyz="0.01 -0.02 0.2" rpy="0 0 0.5"/>
  </joint>
</robot>)";

TEST_F(RobotFileTest, HasALidarWhereTheUrdfHasALinkForIt) {
  EXPECT_FALSE(read_robot(write_body(kBody)).model.lidar);
  const auto urdf = write_changed("</robot>", kLidar);
  const sim::RobotSpec plain = read_robot(urdf);
  ASSERT_TRUE(plain.model.lidar);
  EXPECT_NEAR(plain.model.lidar->mount.x, 0.01, 1e-12);
  EXPECT_NEAR(plain.model.lidar->mount.y, -0.02, 1e-12);
  EXPECT_NEAR(plain.model.lidar->mount.yaw, 0.5, 1e-12);
  EXPECT_EQ(plain.model.lidar->beams, 360) << "an LDS-01, as long as nothing else is said";

  folder_.write("robot.yaml",
                "lidar: {beams: 541, angle_min: -2.356, angle_increment: 0.0087, scan_time: 0.1, min_range: 0.05,\n"
                "  max_range: 12, clear_range: 8}\n");
  const LidarModel lidar = *read_robot(urdf).model.lidar;
  EXPECT_NEAR(lidar.mount.x, 0.01, 1e-12);
  EXPECT_EQ(lidar.beams, 541);
  EXPECT_EQ(lidar.angle_min, -2.356);
  EXPECT_EQ(lidar.angle_increment, 0.0087);
  EXPECT_EQ(lidar.scan_time, 0.1);
  EXPECT_EQ(lidar.min_range, 0.05);
  EXPECT_EQ(lidar.max_range, 12.0);
  EXPECT_EQ(lidar.clear_range, 8.0);
}

TEST_F(RobotFileTest, LidarsLookAllAroundAndTrustTheirRangeUnlessTold) {
  const auto urdf = write_changed("</robot>", kLidar);
  folder_.write("robot.yaml", "lidar: {beams: 720, max_range: 6}\n");
  const LidarModel lidar = *read_robot(urdf).model.lidar;
  EXPECT_NEAR(lidar.angle_increment, radians(0.5), 1e-15);
  EXPECT_EQ(lidar.clear_range, 6.0);
  folder_.write("robot.yaml", "lidar: {clear_range: 0}\n");
  EXPECT_EQ(read_robot(urdf).model.lidar->clear_range, 0.0) << "no return says nothing";
}

TEST_F(RobotFileTest, SaysWhatIsWrongWithALidar) {
  const auto error = [&](const std::string& yaml) {
    const auto urdf = write_changed("</robot>", kLidar);
    folder_.write("robot.yaml", "protocol: none\nlidar:\n  " + yaml + "\n");
    return message_of([&] { read_robot(urdf); });
  };
  for (const char* beams : {"0", "-1", "359.5", "1e9", "many"}) {
    EXPECT_THAT(error(std::string("beams: ") + beams),
                AllOf(HasSubstr(std::string("robot.yaml:3: lidar.beams is ") + beams),
                      EndsWith("want a whole number, 1 to 100000")));
  }
  EXPECT_THAT(error("angle_min: 4"), HasSubstr("robot.yaml:3: lidar.angle_min is 4"));
  EXPECT_THAT(error("angle_increment: -0.01"), HasSubstr("lidar.angle_increment is -0.01; want a positive number"));
  EXPECT_THAT(error("angle_increment: 0.02"),
              AllOf(HasSubstr("lidar.angle_increment is 0.02"), EndsWith("go around more than once")));
  EXPECT_THAT(error("scan_time: 0"), HasSubstr("lidar.scan_time is 0; want a positive number"));
  EXPECT_THAT(error("min_range: -0.1"), HasSubstr("lidar.min_range is -0.1; want a number of 0 or more"));
  EXPECT_THAT(error("max_range: 0"), HasSubstr("lidar.max_range is 0; want a positive number"));
  EXPECT_THAT(error("max_range: 0.1"), EndsWith("want a min_range below its max_range"));
  EXPECT_THAT(error("clear_range: 4"), AllOf(HasSubstr("lidar.clear_range is 4"), EndsWith("max_range or less")));
  EXPECT_THAT(error("range: 4"), HasSubstr("there is no field 'range' in lidar"));
  EXPECT_THAT(details_error("lidar: {beams: 360}\n"),
              AllOf(HasSubstr("robot.yaml:1: lidar is a map"), HasSubstr("base_scan")));
}

TEST_F(RobotFileTest, TheBaseIsAsFastAsItsWheelsUnlessTold) {
  const auto urdf = write_body(kBody);
  EXPECT_EQ(read_robot(urdf).model.max_linear_speed, 0.5);
  folder_.write("robot.yaml", "max_wheel_speed: 0.4\n");
  EXPECT_EQ(read_robot(urdf).model.max_linear_speed, 0.4);
  EXPECT_NEAR(read_robot(urdf).model.max_angular_speed, 5.0, 1e-12);
  folder_.write("robot.yaml", "max_wheel_speed: 0.4\nmax_linear_speed: 0.3\nmax_angular_speed: 2\n");
  EXPECT_EQ(read_robot(urdf).model.max_linear_speed, 0.3);
  EXPECT_EQ(read_robot(urdf).model.max_angular_speed, 2.0);
  EXPECT_THAT(details_error("max_linear_speed: 0\n"), HasSubstr("max_linear_speed is 0; want a positive number"));
  EXPECT_THAT(details_error("max_angular_speed: -1\n"), HasSubstr("max_angular_speed is -1; want a positive number"));
  const sim::RobotSpec roomba = read_robot(in_tree("urdf/roomba_600.urdf"));
  EXPECT_NEAR(roomba.model.max_linear_speed, sim::RobotSpec().model.max_linear_speed, 1e-12);
  EXPECT_NEAR(roomba.model.max_angular_speed, sim::RobotSpec().model.max_angular_speed, 1e-3);
}

TEST_F(RobotFileTest, RefusesWhatIsNoRobot) {
  EXPECT_THAT(message_of([&] { read_robot(folder_ / "nothing.urdf"); }), HasSubstr("nothing.urdf"));
  for (const char* text : {"", "no XML", "<robot", "<robot name='a'/>", "<world/>"}) {
    const std::string message = message_of([&] { read_robot(write_body(text)); });
    EXPECT_THAT(message, HasSubstr("robot.urdf: ")) << text;
    EXPECT_EQ(message.find('\n'), std::string::npos) << text;
  }
}

TEST_F(RobotFileTest, SaysWhichLinkIsWrong) {
  EXPECT_THAT(message_of([&] { read_robot(write_changed("left_wheel\"", "port_wheel\"")); }),
              HasSubstr("there is no link 'left_wheel'"));
  EXPECT_THAT(message_of([&] {
                read_robot(write_changed("<cylinder radius=\"0.1\" length=\"0.05\"/>", "<sphere radius=\"1\"/>"));
              }),
              HasSubstr("link 'base_link' has no cylinder"));
  EXPECT_THAT(message_of([&] { read_robot(write_changed("radius=\"0.03\"", "radius=\"-0.03\"")); }),
              HasSubstr("link 'left_wheel'"));
  EXPECT_THAT(message_of([&] { read_robot(write_changed("0 0.08 0.03", "0 -0.09 0.03")); }),
              HasSubstr("want the left one left"));
  const std::string one_cliff = R"(<link name="cliff_left"/><joint name="c" type="fixed"><parent link="base_link"/>
    <child link="cliff_left"/></joint></robot>)";
  EXPECT_THAT(message_of([&] { read_robot(write_changed("</robot>", one_cliff)); }),
              HasSubstr("has 1 of the 4 links from cliff_left to cliff_right; want all or none"));
}

TEST_F(RobotFileTest, SaysWhichDetailIsWrong) {
  EXPECT_THAT(details_error("protocol: create-2\nwall: {max_range: -1}\n"),
              AllOf(HasSubstr("robot.yaml:2: wall.max_range is -1"), EndsWith("want a positive number")));
  EXPECT_THAT(details_error("acceleration: nan\n"), HasSubstr("robot.yaml:1: acceleration is nan"));
  EXPECT_THAT(details_error("protocol: create-3\n"),
              HasSubstr("want create-2, create-1 or roomba-400, or none for a robot without"));
  EXPECT_THAT(
      details_error("\n\nbraking_force: 1\n"),
      AllOf(HasSubstr("robot.yaml:3: there is no field 'braking_force'"), HasSubstr("did you mean 'braking'?")));
  EXPECT_THAT(details_error("light: [1, 2]\n"), HasSubstr("robot.yaml:1: light is a list"));
  EXPECT_THAT(details_error("light: {gain: [\n"), HasSubstr("robot.yaml:"));
}

}  // namespace
}  // namespace scrubjay
