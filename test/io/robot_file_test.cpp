#include <gmock/gmock.h>

#include <regex>
#include <scrubjay/error.hpp>
#include <scrubjay/io/robot_file.hpp>

#include "temporary_folder.hpp"

namespace scrubjay {
namespace {

using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;

std::filesystem::path in_tree(const std::string& path) {
  return std::filesystem::path(SCRUBJAY_SOURCE_DIR) / path;
}

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
  EXPECT_THAT(details_error("protocol: create-3\n"), HasSubstr("want create-2, create-1 or roomba-400"));
  EXPECT_THAT(
      details_error("\n\nbraking_force: 1\n"),
      AllOf(HasSubstr("robot.yaml:3: there is no field 'braking_force'"), HasSubstr("did you mean 'braking'?")));
  EXPECT_THAT(details_error("light: [1, 2]\n"), HasSubstr("robot.yaml:1: light is a list"));
  EXPECT_THAT(details_error("light: {gain: [\n"), HasSubstr("robot.yaml:"));
}

class NoiseFileTest : public RobotFileTest {
 protected:
  std::string noise_error(const std::string& yaml, std::string_view profile = "mine") const {
    const auto path = folder_.write("noise.yaml", yaml);
    return message_of([&] { read_noise(path, profile); });
  }
};

TEST_F(NoiseFileTest, ReadsEveryProfileOfTheTree) {
  for (const char* name : {"none", "hard-floor", "carpet", "uncalibrated"}) {
    EXPECT_EQ(read_noise(in_tree("urdf/noise.yaml"), name).name, name);
  }
  const sim::NoiseProfile none = read_noise(in_tree("urdf/noise.yaml"), "none");
  EXPECT_EQ(none.travel_noise, 0.0);
  EXPECT_EQ(none.push_slip, 0.0);
  EXPECT_EQ(none.grip.low, 1.0);
  const sim::NoiseProfile carpet = read_noise(in_tree("urdf/noise.yaml"), "carpet");
  EXPECT_EQ(carpet.travel_noise, 0.0033);
  EXPECT_EQ(carpet.turn_noise, 0.02);
  EXPECT_EQ(carpet.grip.low, 0.92);
  EXPECT_EQ(carpet.grip.high, 0.98);
  EXPECT_EQ(carpet.carpet_slip, 1.0);
  EXPECT_EQ(read_noise(in_tree("urdf/noise.yaml"), "uncalibrated").separation_error.high, 0.17);
}

TEST_F(NoiseFileTest, ReadsEveryField) {
  const auto path = folder_.write(
      "noise.yaml",
      "mine: {wheel_mismatch: [0.01, 0.02], separation_error: [0.03, 0.04], distance_error: 0.05, grip: [0.5, 0.6],\n"
      "  albedo: [0.7, 0.8], mount_error: 0.09, travel_noise: 0.1, turn_noise: 0.11, bump_kick: 0.12,\n"
      "  light_noise: 0.13, light_floor_noise: 0.14, carpet_slip: 0.15, push_slip: 0.16, wall_friction: 0.17,\n"
      "  speed_step: 0.18, speed_deadband: 0.19}\n");
  const sim::NoiseProfile noise = read_noise(path, "mine");
  const std::array<double, 20> values{noise.wheel_mismatch.low,
                                      noise.wheel_mismatch.high,
                                      noise.separation_error.low,
                                      noise.separation_error.high,
                                      noise.distance_error,
                                      noise.grip.low,
                                      noise.grip.high,
                                      noise.albedo.low,
                                      noise.albedo.high,
                                      noise.mount_error,
                                      noise.travel_noise,
                                      noise.turn_noise,
                                      noise.bump_kick,
                                      noise.light_noise,
                                      noise.light_floor_noise,
                                      noise.carpet_slip,
                                      noise.push_slip,
                                      noise.wall_friction,
                                      noise.speed_step,
                                      noise.speed_deadband};
  EXPECT_THAT(values, ::testing::ElementsAre(0.01, 0.02, 0.03, 0.04, 0.05, 0.5, 0.6, 0.7, 0.8, 0.09, 0.1, 0.11, 0.12,
                                             0.13, 0.14, 0.15, 0.16, 0.17, 0.18, 0.19));
}

TEST_F(NoiseFileTest, NamesTheProfilesThatThereAre) {
  const std::string message = message_of([&] { read_noise(in_tree("urdf/noise.yaml"), "hardfloor"); });
  EXPECT_THAT(message, AllOf(HasSubstr("there is no noise profile 'hardfloor'; did you mean 'hard-floor'?"),
                             HasSubstr("known: none, hard-floor, carpet, uncalibrated")));
}

TEST_F(NoiseFileTest, SaysWhichFieldIsWrong) {
  EXPECT_THAT(noise_error("mine: {travel_noise: -1}\n"), HasSubstr("noise.yaml:1: mine.travel_noise is -1"));
  EXPECT_THAT(noise_error("mine:\n  grip: [1.0, 0.9]\n"), HasSubstr("noise.yaml:2: mine.grip"));
  EXPECT_THAT(noise_error("mine:\n  albedo: 1\n"), HasSubstr("want [low, high]"));
  EXPECT_THAT(noise_error("mine: {slip: 1}\n"), HasSubstr("there is no field 'slip' in mine"));
  EXPECT_THAT(noise_error("mine: 3\n"), HasSubstr("noise.yaml:1: mine is 3"));
  EXPECT_THAT(noise_error(""), HasSubstr("noise.yaml:1"));
  EXPECT_THAT(message_of([&] { read_noise(folder_ / "absent.yaml", "none"); }), HasSubstr("absent.yaml"));
}

}  // namespace
}  // namespace scrubjay
