#include <gmock/gmock.h>

#include <iterator>
#include <scrubjay/ros2/node_name.hpp>
#include <sstream>

#include "io/temporary_folder.hpp"

namespace scrubjay::ros {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(NodeNameTest, ANodeIsInItsNamespace) {
  EXPECT_EQ(NodeNames("jay").full_name(), "/jay");
  EXPECT_EQ(NodeNames("jay", "/robot1").full_name(), "/robot1/jay");
  EXPECT_EQ(NodeNames("jay", "fleet/robot1").space(), "/fleet/robot1");
  EXPECT_EQ(NodeNames("jay", "").space(), "/");
}

TEST(NodeNameTest, ATopicIsRelativePrivateOrAbsolute) {
  const NodeNames names("jay", "/robot1");
  EXPECT_EQ(names.topic("scan"), "/robot1/scan");
  EXPECT_EQ(names.topic("battery/voltage"), "/robot1/battery/voltage");
  EXPECT_EQ(names.topic("~/plan"), "/robot1/jay/plan");
  EXPECT_EQ(names.topic("~"), "/robot1/jay");
  EXPECT_EQ(names.topic("/scan"), "/scan");
  EXPECT_EQ(NodeNames("jay").topic("scan"), "/scan");
  EXPECT_EQ(NodeNames("jay").topic("~/plan"), "/jay/plan");
}

TEST(NodeNameTest, WordsInBracesStandForTheNode) {
  const NodeNames names("jay", "/robot1");
  EXPECT_EQ(names.topic("of_{node}"), "/robot1/of_jay");
  EXPECT_EQ(names.topic("{ns}/scan"), "/robot1/scan");
  EXPECT_EQ(names.topic("{namespace}/scan"), "/robot1/scan");
  EXPECT_EQ(NodeNames("jay").topic("{ns}/scan"), "/scan");
}

TEST(NodeNameTest, BadNamesOfTopicsAreSaidToBeSo) {
  const NodeNames names("jay");
  for (const char* bad :
       {"", "/", "scan/", "a//b", "1scan", "a/2b", "scan-front", "a b", "a~b", "~b", "a/~/b", "{who}", "\xc3\xa4"}) {
    EXPECT_THAT(message_of([&] { names.topic(bad); }), HasSubstr("the topic '" + std::string(bad) + "'")) << bad;
  }
  EXPECT_EQ(names.topic(std::string(246, 'a')).size(), 247U);
  EXPECT_THAT(message_of([&] { names.topic(std::string(247, 'a')); }), HasSubstr("longer than 247"));
}

TEST(NodeNameTest, BadNamesOfNodesAreSaidToBeSo) {
  for (const char* bad : {"", "a/b", "1a", "a-b", "~"}) {
    EXPECT_THAT(message_of([&] { NodeNames names(bad); }), HasSubstr("the node's name '" + std::string(bad) + "'"));
  }
  for (const char* bad : {"/a/", "//a", "/1a", "/a b"}) {
    EXPECT_THAT(message_of([&] { NodeNames names("jay", bad); }), HasSubstr("the namespace " + std::string(bad)));
  }
}

TEST(NodeNameTest, NodeAndNamespaceAreRemapped) {
  const NodeNames names("jay", "/", {{"__node", "raven"}, {"__ns", "/robot1"}, {"__ns", "/robot2"}});
  EXPECT_EQ(names.full_name(), "/robot1/raven");
  EXPECT_EQ(names.topic("~/plan"), "/robot1/raven/plan");
}

TEST(NodeNameTest, TopicsAreRemappedByTheirFullNames) {
  const NodeNames names("jay", "/robot1", {{"scan", "laser"}, {"/tf", "tf"}, {"~/plan", "/plan"}, {"map", "~/map"}});
  EXPECT_EQ(names.topic("scan"), "/robot1/laser");
  EXPECT_EQ(names.topic("/robot1/scan"), "/robot1/laser");
  EXPECT_EQ(names.topic("/scan"), "/scan");
  EXPECT_EQ(names.topic("/tf"), "/robot1/tf");
  EXPECT_EQ(names.topic("/robot1/jay/plan"), "/plan");
  EXPECT_EQ(names.topic("map"), "/robot1/jay/map");
}

TEST(NodeNameTest, TheFirstRuleHoldsAndWhatItGivesIsNotRemappedAgain) {
  const NodeNames names("jay", "/", {{"a", "b"}, {"b", "c"}, {"a", "d"}});
  EXPECT_EQ(names.topic("a"), "/b");
  EXPECT_EQ(names.topic("b"), "/c");
}

TEST(NodeNameTest, RulesOfOtherNodesAreNotForUs) {
  const NodeNames names("jay", "/", {{"scan", "laser", "raven"}, {"map", "floor", "jay"}, {"__node", "crow", "raven"}});
  EXPECT_EQ(names.name(), "jay");
  EXPECT_EQ(names.topic("scan"), "/scan");
  EXPECT_EQ(names.topic("map"), "/floor");
}

TEST(NodeNameTest, TopicsOfDdsHaveAPrefix) {
  EXPECT_EQ(dds_topic("/robot1/map"), "rt/robot1/map");
  EXPECT_EQ(topic_of_dds("rt/robot1/map"), "/robot1/map");
  EXPECT_EQ(topic_of_dds("rq/robot1/set_parametersRequest"), std::nullopt);
  EXPECT_EQ(topic_of_dds("ros_discovery_info"), std::nullopt);
}

std::vector<std::string> words(const std::string& line) {
  std::istringstream stream(line);
  return {std::istream_iterator<std::string>(stream), {}};
}

TEST(RosArgumentsTest, AreTakenOutFromBetweenTheOthers) {
  std::vector<std::string> all = words("explore a.yaml --ros-args -r __node:=x --remap scan:=laser -- --seed 7");
  const RosArguments arguments = take_ros_arguments(all);
  EXPECT_EQ(all, words("explore a.yaml --seed 7"));
  EXPECT_THAT(arguments.remappings, ElementsAre(Remapping{"__node", "x"}, Remapping{"scan", "laser"}));
  EXPECT_EQ(arguments.enclave, "/");
}

TEST(RosArgumentsTest, MayStandInSeveralPlaces) {
  std::vector<std::string> all = words("--ros-args -r a:=b -- explore --ros-args -e /robot1 -r c:=d");
  const RosArguments arguments = take_ros_arguments(all);
  EXPECT_EQ(all, words("explore"));
  EXPECT_THAT(arguments.remappings, ElementsAre(Remapping{"a", "b"}, Remapping{"c", "d"}));
  EXPECT_EQ(arguments.enclave, "/robot1");
}

TEST(RosArgumentsTest, WithoutThemNothingIsTaken) {
  std::vector<std::string> all = words("explore -r a:=b --");
  EXPECT_THAT(take_ros_arguments(all).remappings, IsEmpty());
  EXPECT_EQ(all, words("explore -r a:=b --"));
}

TEST(RosArgumentsTest, ARuleMayBeForOneNode) {
  std::vector<std::string> all =
      words("--ros-args -r jay:__ns:=/robot1 -r raven:scan:=laser -r rostopic://scan:=laser");
  EXPECT_THAT(take_ros_arguments(all).remappings,
              ElementsAre(Remapping{"__ns", "/robot1", "jay"}, Remapping{"scan", "laser", "raven"},
                          Remapping{"rostopic://scan", "laser"}));
}

TEST(RosArgumentsTest, WhatOnlyRclKnowsIsSaidToDoNothing) {
  std::vector<std::string> all =
      words("--ros-args -p use_sim_time:=true --params-file p.yaml --log-level debug --disable-rosout-logs");
  EXPECT_THAT(take_ros_arguments(all).warnings,
              ElementsAre(HasSubstr("-p use_sim_time:=true"), HasSubstr("--params-file p.yaml"),
                          HasSubstr("--log-level debug"), HasSubstr("--disable-rosout-logs")));
}

TEST(RosArgumentsTest, WhatIsNoneIsAnError) {
  for (const char* line : {"--ros-args -r", "--ros-args -r a=b", "--ros-args -r :=b",
                           "--ros-args -r a:=", "--ros-args -r :a:=b", "--ros-args explore", "--ros-args -e"}) {
    std::vector<std::string> all = words(line);
    EXPECT_NE(message_of([&] { take_ros_arguments(all); }), "") << line;
  }
}

}  // namespace
}  // namespace scrubjay::ros
