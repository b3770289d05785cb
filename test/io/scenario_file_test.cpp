#include <gmock/gmock.h>

#include <scrubjay/geometry/random.hpp>
#include <scrubjay/io/scenario_file.hpp>

#include "temporary_folder.hpp"

namespace scrubjay {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string scenario_error(const std::string& text) {
  return message_of([&] { parse_scenario(text, "run.yaml"); });
}

TEST(ScenarioFileTest, ReadsWhatItWrites) {
  Random random(5);
  for (int i = 0; i < 200; ++i) {
    Scenario scenario;
    scenario.world = "worlds/flat.yaml";
    scenario.model = "create-1";
    scenario.strategy = "random-look";
    scenario.noise = "carpet";
    scenario.seed = random.next();
    if (i % 2 == 0) {
      scenario.start = Pose2{random.uniform(-50.0, 50.0), random.uniform(-50.0, 50.0), random.uniform(-kPi, kPi)};
    }
    if (i % 3 == 0) scenario.protocol = oi::Model::Roomba400;
    scenario.mode_one_too_high = i % 5 == 0;
    scenario.resolution = random.uniform(0.005, 1.0);
    scenario.max_time = random.uniform(1.0, 1e6);
    if (i % 3 == 0) {
      const Point2 low{random.uniform(-50.0, 0.0), random.uniform(-50.0, 0.0)};
      scenario.within = Bounds2{low, low + Point2(random.uniform(0.1, 9.0), random.uniform(0.1, 9.0))};
    }
    scenario.return_home = i % 5 == 0;
    scenario.motion_distortion = i % 7 == 0;
    if (i % 4 == 0) scenario.forward_cone = random.uniform(0.01, kPi);
    if (i % 6 == 0) scenario.robot_radius = random.uniform(0.0, 1.0);
    if (i % 8 == 0) scenario.localizer = "odometry";
    if (i % 9 == 0)
      scenario.calibration = {random.uniform(0.5, 2.0), random.uniform(0.5, 2.0), random.uniform(0.5, 2.0)};
    EXPECT_EQ(parse_scenario(scenario_text(scenario), "run.yaml"), scenario) << scenario_text(scenario);
  }
}

TEST(ScenarioFileTest, PathsMayHoldAnything) {
  for (const char* path : {"my house.yaml", "it's.yaml", "a \"b\".yaml", "back\\slash", "a: b # c", "{}", "- x", "true",
                           "\xC3\xA9t\xC3\xA9.json", "12", "tab\there", "two\nlines", " both ends "}) {
    Scenario scenario;
    scenario.world = scenario.model = path;
    EXPECT_EQ(parse_scenario(scenario_text(scenario), "run.yaml"), scenario) << path;
  }
}

TEST(ScenarioFileTest, WhatIsNotGivenIsAsByDefault) {
  Scenario expected;
  expected.world = "room.yaml";
  EXPECT_EQ(parse_scenario("world: room.yaml\n", "run.yaml"), expected);
}

TEST(ScenarioFileTest, ReadsAFile) {
  const TemporaryFolder folder;
  Scenario expected;
  expected.world = "room.yaml";
  expected.seed = 18446744073709551615ull;
  EXPECT_EQ(read_scenario(folder.write("run.yaml", scenario_text(expected))), expected);
  EXPECT_THAT(message_of([&] { read_scenario(folder / "absent.yaml"); }), HasSubstr("absent.yaml"));
}

TEST(ScenarioFileTest, WrapsTheHeading) {
  EXPECT_NEAR(parse_scenario("start: [1, 2, 7]\n", "run.yaml").start->yaw, 7.0 - 2.0 * kPi, 1e-12);
}

TEST(ScenarioFileTest, SaysWhichFieldIsWrong) {
  EXPECT_THAT(scenario_error("world: a\nseed: -1\n"),
              HasSubstr("run.yaml:2: seed is -1; want a whole number of 0 or more"));
  EXPECT_THAT(scenario_error("seed: 18446744073709551616\n"), HasSubstr("seed"));
  EXPECT_THAT(scenario_error("seed: 1.5\n"), HasSubstr("seed"));
  EXPECT_THAT(scenario_error("resolution: 0\n"), HasSubstr("want a cell size from 0.005 to 1 m"));
  EXPECT_THAT(scenario_error("resolution: 2\n"), HasSubstr("want a cell size from 0.005 to 1 m"));
  EXPECT_THAT(scenario_error("max_time: 0\n"), HasSubstr("want a positive number of seconds"));
  EXPECT_THAT(scenario_error("max_time: inf\n"), HasSubstr("max_time"));
  EXPECT_THAT(scenario_error("start: [1, 2]\n"), HasSubstr("want [x, y, theta]"));
  EXPECT_THAT(scenario_error("start: [1, 2, east]\n"), HasSubstr("start[2] is east"));
  EXPECT_THAT(scenario_error("within: [1, 2, 3]\n"), HasSubstr("within"));
  EXPECT_THAT(scenario_error("within: [1, 2, 0, 3]\n"), HasSubstr("the lower left corner first"));
  EXPECT_THAT(scenario_error("return_home: perhaps\n"), HasSubstr("return_home"));
  EXPECT_THAT(scenario_error("forward_cone: 4\n"), HasSubstr("an angle in radians, up to pi"));
  EXPECT_THAT(scenario_error("robot_radius: -1\n"), HasSubstr("a radius from 0 to 1 m"));
  EXPECT_THAT(scenario_error("calibration: {left: 1, right: 3, axle: 1}\n"), HasSubstr("calibration.right is 3"));
  EXPECT_THAT(scenario_error("calibration: {left: 1, right: 1}\n"), HasSubstr("calibration.axle is missing"));
  EXPECT_THAT(scenario_error("strategi: reactive\n"),
              AllOf(HasSubstr("run.yaml:1: there is no field 'strategi'"), HasSubstr("did you mean 'strategy'?")));
  EXPECT_THAT(scenario_error("world: [a]\n"), HasSubstr("world is a list of 1; want text"));
  EXPECT_THAT(scenario_error("just text\n"), HasSubstr("run.yaml:1"));
  EXPECT_THAT(scenario_error("world: {\n"), HasSubstr("run.yaml:"));
}

}  // namespace
}  // namespace scrubjay
