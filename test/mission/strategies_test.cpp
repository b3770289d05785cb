#include <gmock/gmock.h>

#include <array>
#include <scrubjay/error.hpp>
#include <scrubjay/mission/strategies.hpp>
#include <string>

namespace scrubjay::test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string error_of(std::string_view name) {
  try {
    make_strategy(name, {});
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::Input);
    return error.what();
  }
  return {};
}

RobotModel burger() {
  RobotModel robot;
  robot.open_interface = false;
  robot.has_light_sensors = false;
  robot.lidar.emplace();
  return robot;
}

TEST(StrategiesTest, AreThoseThatTheSensesAllow) {
  EXPECT_THAT(strategy_names(RobotModel{}), ElementsAre("random-2", "random-3", "random-look", "random-aware",
                                                        "reactive", "wander", "edge-follow", "contact-frontier"));
  EXPECT_THAT(strategy_names(burger()), ElementsAre("wander", "tiles", "frontiers"));
  EXPECT_EQ(default_strategy(RobotModel{}), "contact-frontier");
  EXPECT_EQ(default_strategy(burger()), "frontiers");
}

TEST(StrategiesTest, EachCanBeMadeAndDecides) {
  const std::array<LogOdds, 1> cell{};
  for (const RobotModel& robot : {RobotModel{}, burger()}) {
    for (const std::string_view name : strategy_names(robot)) {
      const std::unique_ptr<Behavior> behavior = make_strategy(name, {.robot = robot});
      ASSERT_NE(behavior, nullptr) << name;
      const Decision decision =
          behavior->decide({Frame{}, PoseEstimate{}, {{0.05, {0.0, 0.0}, 1, 1}, cell.data()}, {{0, 0}, {1, 1}}});
      EXPECT_NE(std::string_view(decision.doing), "") << name;
    }
  }
}

TEST(StrategiesTest, SensesThatAreMissingAreNamed) {
  const auto error_for = [](std::string_view name, const RobotModel& robot) -> std::string {
    try {
      make_strategy(name, {.robot = robot});
    } catch (const Error& error) {
      return error.what();
    }
    return {};
  };
  EXPECT_THAT(error_for("frontiers", RobotModel{}), AllOf(HasSubstr("wants a lidar"), HasSubstr("contact-frontier")));
  EXPECT_THAT(error_for("edge-follow", burger()), AllOf(HasSubstr("wants a bumper"), HasSubstr("wander")));
}

TEST(StrategiesTest, WhatCannotKeepToBoundsOrReturnIsNotToldTo) {
  const auto error_for = [](std::string_view name, const StrategySetting& setting) -> std::string {
    try {
      make_strategy(name, setting);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), Error::Kind::Input);
      return error.what();
    }
    return "none";
  };
  const StrategySetting bounded{.within = Bounds2{{-1.0, -1.0}, {1.0, 1.0}}};
  const StrategySetting returning{.return_home = true};
  for (const char* name : {"random-2", "random-3", "random-look", "random-aware", "reactive", "wander"}) {
    EXPECT_THAT(error_for(name, bounded), HasSubstr("stay within bounds (those that can: contact-frontier)")) << name;
    EXPECT_THAT(error_for(name, returning), HasSubstr("return home (those that can: edge-follow, contact-frontier)"));
  }
  EXPECT_THAT(error_for("edge-follow", bounded), HasSubstr("stay within bounds"));
  EXPECT_EQ(error_for("edge-follow", returning), "none");
  EXPECT_EQ(error_for("contact-frontier", bounded), "none");
  EXPECT_EQ(error_for("contact-frontier", returning), "none");
  EXPECT_THAT(error_for("wander", {.robot = burger(), .return_home = true}), HasSubstr("that can: tiles, frontiers)"));
  EXPECT_EQ(error_for("tiles", {.robot = burger(), .within = bounded.within, .return_home = true}), "none");
}

TEST(StrategiesTest, AnUnknownNameGetsTheKnownOnesAndTheNearest) {
  EXPECT_THAT(error_of("edge-folow"), AllOf(HasSubstr("'edge-folow'"), HasSubstr("did you mean 'edge-follow'?"),
                                            HasSubstr("random-2, random-3, random-look, random-aware, reactive")));
  EXPECT_THAT(error_of("random"), HasSubstr("did you mean 'random-2'?"));
  EXPECT_EQ(error_of("radnom-aware").find('\n'), std::string::npos);
  EXPECT_THAT(error_of("").c_str(), HasSubstr("there is no strategy ''"));
}

}  // namespace
}  // namespace scrubjay::test
