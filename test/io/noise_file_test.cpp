#include <gmock/gmock.h>

#include <scrubjay/error.hpp>
#include <scrubjay/io/robot_file.hpp>

#include "source_tree.hpp"
#include "temporary_folder.hpp"

namespace scrubjay {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class NoiseFileTest : public ::testing::Test {
 protected:
  std::string noise_error(const std::string& yaml, std::string_view profile = "mine") const {
    const auto path = folder_.write("noise.yaml", yaml);
    return message_of([&] { read_noise(path, profile); });
  }

  TemporaryFolder folder_;
};

TEST_F(NoiseFileTest, ReadsEveryProfileOfTheTree) {
  for (const char* name : {"none", "hard-floor", "carpet", "uncalibrated"}) {
    EXPECT_EQ(read_noise(in_tree("urdf/noise.yaml"), name).name, name);
  }
  EXPECT_EQ(read_noise(in_tree("urdf/noise.yaml"), "hard-floor").lidar_noise_share, 0.0167);
  EXPECT_EQ(read_noise(in_tree("urdf/noise.yaml"), "carpet").lidar_noise_share, 0.0167);
  const sim::NoiseProfile none = read_noise(in_tree("urdf/noise.yaml"), "none");
  EXPECT_EQ(none.travel_noise, 0.0);
  EXPECT_EQ(none.push_slip, 0.0);
  EXPECT_EQ(none.lidar_noise, 0.0);
  EXPECT_EQ(none.lidar_noise_share, 0.0);
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
      "  speed_step: 0.18, speed_deadband: 0.19, lidar_noise: 0.2, lidar_noise_share: 0.21}\n");
  const sim::NoiseProfile noise = read_noise(path, "mine");
  const std::array<double, 22> values{noise.wheel_mismatch.low,
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
                                      noise.speed_deadband,
                                      noise.lidar_noise,
                                      noise.lidar_noise_share};
  EXPECT_THAT(values, ::testing::ElementsAre(0.01, 0.02, 0.03, 0.04, 0.05, 0.5, 0.6, 0.7, 0.8, 0.09, 0.1, 0.11, 0.12,
                                             0.13, 0.14, 0.15, 0.16, 0.17, 0.18, 0.19, 0.2, 0.21));
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
  EXPECT_THAT(noise_error("mine:\n  lidar_noise: -0.1\n"), HasSubstr("noise.yaml:2: mine.lidar_noise is -0.1"));
  EXPECT_THAT(noise_error("mine:\n  lidar_noise_share: a\n"), HasSubstr("noise.yaml:2: mine.lidar_noise_share is a"));
  EXPECT_THAT(noise_error("mine: {slip: 1}\n"), HasSubstr("there is no field 'slip' in mine"));
  EXPECT_THAT(noise_error("mine: 3\n"), HasSubstr("noise.yaml:1: mine is 3"));
  EXPECT_THAT(noise_error(""), HasSubstr("noise.yaml:1"));
  EXPECT_THAT(message_of([&] { read_noise(folder_ / "absent.yaml", "none"); }), HasSubstr("absent.yaml"));
}

}  // namespace
}  // namespace scrubjay
