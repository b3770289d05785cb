#include <gmock/gmock.h>

#include <scrubjay/ros2/bridge.hpp>
#include <scrubjay/ros2/survey.hpp>

namespace scrubjay::ros {
namespace {

using ::testing::AllOf;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

constexpr Qos kWeak{Reliability::BestEffort, Durability::Volatile, 0};
constexpr Qos kStrong{Reliability::Reliable, Durability::TransientLocal, 0};

template <Message M>
Endpoint endpoint(bool writes, const std::string& topic, const Qos& qos = {}) {
  return {writes, topic, std::string(M::kType), std::string(M::kHash), qos, "/other"};
}

Peer peer(std::vector<Endpoint> endpoints) {
  return {.name = "/",
          .enclave = "/",
          .vendor = "Cyclone DDS",
          .address = "10.0.0.7",
          .nodes = {"/other"},
          .endpoints = std::move(endpoints)};
}

class SurveyTest : public testing::Test {
 protected:
  /// What is said of these peers, where nothing else is wrong.
  std::vector<Finding> findings(std::vector<Peer> peers, std::uint64_t strange_infos = 0) const {
    return diagnose(survey(settings_, std::move(peers), planned_, strange_infos));
  }
  Judgement judged(const Endpoint& theirs) const { return judge(planned_, theirs); }

  ParticipantOptions settings_{};
  std::vector<Endpoint> planned_ = bridge_endpoints(settings_.names, kTopics);
};

TEST_F(SurveyTest, ABridgeWritesAllTopicsAndHearsTwoKindsOfVelocity) {
  const NodeNames names("jay", "/robot1", {{"scan", "laser"}});
  const std::vector<Endpoint> endpoints = bridge_endpoints(names, kTopics);
  EXPECT_THAT(endpoints, testing::Contains(Endpoint{true, "/robot1/laser", "sensor_msgs/msg/LaserScan",
                                                    std::string(LaserScan::kHash), kSensorData, "/robot1/jay"}));
  const auto is_velocity = [](const Endpoint& e) { return !e.writes && e.topic == "/robot1/cmd_vel"; };
  EXPECT_EQ(std::ranges::count_if(endpoints, is_velocity), 2);
  EXPECT_EQ(std::ranges::count_if(endpoints, &Endpoint::writes), static_cast<std::ptrdiff_t>(kTopics.size()));
}

TEST_F(SurveyTest, JudgesByTheOtherEndOfTheTopic) {
  EXPECT_EQ(judged(endpoint<OccupancyGrid>(false, "/map", kStrong)), (Judgement{HashState::Same, Fit::Matched, ""}));
  EXPECT_EQ(
      judged(endpoint<Odometry>(false, "/odom", kStrong)),
      (Judgement{HashState::Same, Fit::Refused, "durability: transient_local is asked for, volatile is offered"}));
  EXPECT_EQ(judged(endpoint<Twist>(true, "/cmd_vel", kWeak)).fit, Fit::Matched);
  EXPECT_EQ(judged(endpoint<TwistStamped>(true, "/cmd_vel", kWeak)).fit, Fit::Matched);
  EXPECT_EQ(judged(endpoint<String>(true, "/cmd_vel")).fit, Fit::Refused);
  EXPECT_EQ(judged(endpoint<OccupancyGrid>(true, "/map", kStrong)).fit, Fit::SameSide);
  EXPECT_EQ(judged(endpoint<String>(true, "/chatter")).fit, Fit::NotOurs);
}

TEST_F(SurveyTest, HashesAreComparedByTypeWhateverTheTopic) {
  Endpoint path = endpoint<Path>(true, "/somewhere/else");
  EXPECT_EQ(judged(path).hash, HashState::Same);
  path.hash = "RIHS01_00";
  EXPECT_EQ(judged(path).hash, HashState::Other);
  path.hash.clear();
  EXPECT_EQ(judged(path).hash, HashState::NotTold);
  path.type = "my_msgs/msg/Own";
  EXPECT_EQ(judged(path).hash, HashState::Unknown);
}

TEST_F(SurveyTest, IsWellWhereAllThatMeetsFits) {
  EXPECT_THAT(findings({peer({endpoint<OccupancyGrid>(false, "/map", kStrong), endpoint<Twist>(true, "/cmd_vel"),
                              endpoint<Log>(true, "/rosout"), endpoint<TFMessage>(true, "/tf")})}),
              IsEmpty());
}

TEST_F(SurveyTest, NamesWhoDoesntHearAndWhatToChange) {
  EXPECT_THAT(
      findings({peer({endpoint<Odometry>(false, "/odom", kStrong)})}),
      ElementsAre(Finding{Finding::Kind::Problem,
                          "/odom: /other doesn't hear us: durability: transient_local is asked for, volatile is "
                          "offered",
                          "have it ask for what we offer: reliable, volatile"}));
  EXPECT_THAT(findings({peer({endpoint<PoseStamped>(true, "/goal_pose", kWeak)})}),
              ElementsAre(Finding{Finding::Kind::Problem,
                                  "/goal_pose: /other isn't heard: reliability: reliable is asked for, best_effort is "
                                  "offered",
                                  "have it offer what we ask for: reliable, volatile"}));
}

TEST_F(SurveyTest, ATopicOfAnotherTypeIsToBeRemapped) {
  const std::vector<Finding> found = findings({peer({endpoint<String>(false, "/odom")})});
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].what,
            "/odom: /other doesn't hear us: written as nav_msgs/msg/Odometry, read as std_msgs/msg/String");
  EXPECT_THAT(found[0].advice, HasSubstr("--ros-args -r /odom:=another"));
}

TEST_F(SurveyTest, AMatchWithAnotherDefinitionIsAProblem) {
  Endpoint reader = endpoint<OccupancyGrid>(false, "/map", kStrong);
  reader.hash = "RIHS01_00";
  const std::vector<Finding> found = findings({peer({reader})});
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].kind, Finding::Kind::Problem);
  EXPECT_THAT(found[0].what, AllOf(HasSubstr("/map: /other"), HasSubstr("nav_msgs/msg/OccupancyGrid")));
}

TEST_F(SurveyTest, NobodyIsAProblemWithTheReasonsThatTheSettingsAllow) {
  settings_.domain = 3;
  settings_.discovery.range = DiscoveryRange::Subnet;
  std::vector<Finding> found = findings({});
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0],
            (Finding{Finding::Kind::Problem, "Nobody else is in the domain", "ROS_DOMAIN_ID=3 for the others, too"}));
  EXPECT_THAT(found, testing::Contains(Field(&Finding::what, HasSubstr("UDP, from port 8150"))));
  EXPECT_THAT(found, testing::Contains(Field(&Finding::what, HasSubstr("Security is off"))));
  settings_.discovery.range = DiscoveryRange::Localhost;
  settings_.security.emplace();
  found = findings({});
  EXPECT_THAT(found, Each(Field(&Finding::what, Not(HasSubstr("multicast")))));
  EXPECT_THAT(found, testing::Contains(Field(&Finding::advice, HasSubstr("RANGE=LOCALHOST"))));
  EXPECT_THAT(found, testing::Contains(Field(&Finding::what, HasSubstr("Security is on"))));
  settings_.discovery.range = DiscoveryRange::Off;
  EXPECT_THAT(findings({}), SizeIs(2));
}

TEST_F(SurveyTest, ARunOfOursIsNobodyElseAndIsWhatOthersAreComparedWith) {
  Peer run = peer({endpoint<Odometry>(true, "/odom")});
  run.nodes = {"/scrubjay"};
  Peer helper = peer({endpoint<TwistStamped>(false, "/cmd_vel", kWeak)});
  helper.nodes = {"/_scrubjay_2"};
  EXPECT_THAT(findings({run, helper}),
              testing::Contains(Field(&Finding::what, "Nobody but a run of ours is in the domain")));
  const Peer other = peer({endpoint<OccupancyGrid>(false, "/map"), endpoint<TwistStamped>(true, "/cmd_vel")});
  const Survey seen = survey(settings_, {run, other, helper}, planned_, 0);
  EXPECT_THAT(seen.runs, ElementsAre(run, helper));
  EXPECT_THAT(seen.others, ElementsAre(other));
  EXPECT_THAT(seen.ours, SizeIs(2));
  EXPECT_EQ(judge(seen.ours, other.endpoints[0]).fit, Fit::NotOurs) << "that run has no map";
  EXPECT_EQ(judge(seen.ours, other.endpoints[1]).fit, Fit::Matched);
  EXPECT_THAT(diagnose(seen), IsEmpty());
}

TEST_F(SurveyTest, IdentifiersOfAnotherSizeAreAProblemWithAWayOut) {
  const Peer other = peer({});
  std::vector<Finding> found = findings({other}, 1);
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].kind, Finding::Kind::Problem);
  EXPECT_THAT(found[0].advice, HasSubstr("--ros-distro: humble"));
  settings_.distribution = Distribution::Humble;
  EXPECT_THAT(findings({other}, 1)[0].advice, HasSubstr("after Humble"));
}

TEST_F(SurveyTest, TwoThatWriteOneTopicAreToBeKeptApart) {
  const std::vector<Finding> found =
      findings({peer({endpoint<Odometry>(true, "/odom"), endpoint<OccupancyGrid>(true, "/map", kStrong),
                      endpoint<Clock>(true, "/clock"), endpoint<TFMessage>(true, "/tf")})});
  ASSERT_THAT(found, SizeIs(2));
  EXPECT_THAT(found, Each(Field(&Finding::kind, Finding::Kind::Remark)));
  EXPECT_THAT(found[0].what, HasSubstr("/clock is written by /other"));
  EXPECT_THAT(found[1].what, HasSubstr("Both we and /other write /odom, /map:"));
  EXPECT_THAT(found[1].advice, HasSubstr("__ns:=/robot1"));
}

TEST_F(SurveyTest, AParticipantWithoutNodesIsRemarked) {
  Peer nameless = peer({});
  nameless.nodes.clear();
  EXPECT_THAT(findings({nameless}),
              ElementsAre(AllOf(Field(&Finding::kind, Finding::Kind::Remark),
                                Field(&Finding::what, HasSubstr("Cyclone DDS at 10.0.0.7 told of no node")))));
  nameless.enclave.clear();
  nameless.address.clear();
  EXPECT_THAT(findings({nameless}),
              ElementsAre(Field(&Finding::what, HasSubstr("A participant of Cyclone DDS is no node of ROS 2"))));
}

TEST_F(SurveyTest, TopicsOfServicesAreToldFromOthers) {
  EXPECT_TRUE(is_of_service({.topic = "rq/get_parametersRequest"}));
  EXPECT_TRUE(is_of_service({.topic = "rr/get_parametersReply"}));
  EXPECT_FALSE(is_of_service({.topic = "/rq/map"}));
}

}  // namespace
}  // namespace scrubjay::ros
