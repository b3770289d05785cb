#include <gmock/gmock.h>

#include <scrubjay/ros2/peers.hpp>
#include <scrubjay/ros2/socket_buffers.hpp>

#include "io/temporary_folder.hpp"
#include "ros2/graph.hpp"
#include "ros2/sink.hpp"
#include "ros2/user_data.hpp"
#include "ros2/vendor.hpp"

namespace scrubjay::ros {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

Endpoint writer(Reliability reliability, Durability durability) {
  return {.writes = true, .topic = "/map", .type = "nav_msgs/msg/OccupancyGrid", .qos = {reliability, durability, 1}};
}

Endpoint reader(Reliability reliability, Durability durability) {
  Endpoint endpoint = writer(reliability, durability);
  endpoint.writes = false;
  return endpoint;
}

TEST(MismatchTest, WhatIsOfferedMustBeAsMuchAsWhatIsAskedFor) {
  using R = Reliability;
  using D = Durability;
  for (const R offered : {R::BestEffort, R::Reliable}) {
    for (const R asked : {R::BestEffort, R::Reliable}) {
      for (const D kept : {D::Volatile, D::TransientLocal}) {
        for (const D wanted : {D::Volatile, D::TransientLocal}) {
          const bool reliability = offered == R::BestEffort && asked == R::Reliable;
          const bool durability = kept == D::Volatile && wanted == D::TransientLocal;
          const std::string one = mismatch(writer(offered, kept), reader(asked, wanted));
          EXPECT_EQ(one, mismatch(reader(asked, wanted), writer(offered, kept)));
          EXPECT_EQ(one, reliability  ? "reliability: reliable is asked for, best_effort is offered"
                         : durability ? "durability: transient_local is asked for, volatile is offered"
                                      : "");
        }
      }
    }
  }
}

TEST(MismatchTest, ATypeIsTheSameOrNotAndItsHashIsNoReason) {
  const Endpoint ours = writer(Reliability::Reliable, Durability::TransientLocal);
  Endpoint theirs = reader(Reliability::Reliable, Durability::TransientLocal);
  theirs.hash = "RIHS01_00";
  EXPECT_EQ(mismatch(ours, theirs), "");
  theirs.type = "std_msgs/msg/String";
  EXPECT_EQ(mismatch(ours, theirs), "written as nav_msgs/msg/OccupancyGrid, read as std_msgs/msg/String");
}

TEST(MismatchTest, ThoseOfOneKindOrOfOtherTopicsHaveNothingToDoWithEachOther) {
  const Endpoint weak = writer(Reliability::BestEffort, Durability::Volatile);
  Endpoint other = reader(Reliability::Reliable, Durability::TransientLocal);
  EXPECT_NE(mismatch(weak, other), "");
  other.topic = "/scan";
  EXPECT_EQ(mismatch(weak, other), "");
  EXPECT_EQ(mismatch(weak, writer(Reliability::Reliable, Durability::TransientLocal)), "");
}

TEST(MismatchTest, OneOfOursThatMatchesIsEnough) {
  std::vector<Endpoint> ours{reader(Reliability::BestEffort, Durability::Volatile)};
  Endpoint theirs = writer(Reliability::BestEffort, Durability::Volatile);
  theirs.type = "geometry_msgs/msg/TwistStamped";
  EXPECT_NE(mismatch(ours, theirs), "");
  ours.push_back(ours.front());
  ours.back().type = theirs.type;
  EXPECT_EQ(mismatch(ours, theirs), "");
  ours.push_back(ours.front());
  EXPECT_EQ(mismatch(ours, theirs), "");
}

/// The entity `entity` of participant `participant`.
Guid guid(std::uint8_t participant, std::uint8_t entity) {
  Guid guid{};
  guid[0] = participant;
  guid[15] = entity;
  return guid;
}

Guid whole(std::uint8_t participant) {
  return participant_of(guid(participant, 0));
}

TEST(GraphTest, AParticipantHasItsEndpointsAndNodesInWhateverOrderTheyCame) {
  Graph graph;
  graph.set_endpoint(guid(2, 4), {.writes = true, .topic = "/map"});
  graph.set_nodes({whole(2), {{"/robot1", "jay", {}, {guid(2, 4)}}, {"/", "raven", {guid(2, 7)}, {}}}});
  graph.set_participant(whole(2), {.name = "second"});
  graph.set_participant(whole(1), {.name = "first"});
  graph.set_endpoint(guid(2, 7), {.writes = false, .topic = "/scan"});
  graph.set_endpoint(guid(1, 4), {.writes = true, .topic = "/rosout"});
  EXPECT_THAT(graph.peers({}), ElementsAre(Peer{.name = "second",
                                                .nodes = {"/robot1/jay", "/raven"},
                                                .endpoints = {{.writes = true, .topic = "/map", .node = "/robot1/jay"},
                                                              {.writes = false, .topic = "/scan", .node = "/raven"}}},
                                           Peer{.name = "first", .endpoints = {{.writes = true, .topic = "/rosout"}}}));
}

TEST(GraphTest, OneThatLeavesTakesAllThatItHadWithIt) {
  Graph graph;
  graph.set_participant(whole(1), {.name = "stays"});
  graph.set_participant(whole(2), {.name = "leaves"});
  graph.set_endpoint(guid(2, 4), {.writes = true, .topic = "/map"});
  graph.remove_participant(whole(2));
  EXPECT_THAT(graph.peers({}), ElementsAre(Peer{.name = "stays"}));
  graph.set_participant(whole(2), {.name = "is back"});
  EXPECT_THAT(graph.peers({}), ElementsAre(Peer{.name = "stays"}, Peer{.name = "is back"}));
}

TEST(GraphTest, AnEndpointThatLeavesIsGone) {
  Graph graph;
  graph.set_participant(whole(1), {});
  graph.set_endpoint(guid(1, 4), {.writes = true, .topic = "/map"});
  graph.remove_endpoint(guid(1, 4));
  EXPECT_THAT(graph.peers({})[0].endpoints, IsEmpty());
}

TEST(GraphTest, OurOwnParticipantsAreNoPeers) {
  Graph graph;
  graph.set_participant(whole(1), {});
  graph.set_participant(whole(2), {});
  EXPECT_THAT(graph.peers({whole(1)}), SizeIs(1));
}

TEST(UserDataTest, IsWordsThatEndInSemicolons) {
  EXPECT_EQ(user_data("enclave", "/robot1"), "enclave=/robot1;");
  EXPECT_EQ(value_in("enclave=/robot1;", "enclave"), "/robot1");
  EXPECT_EQ(value_in("a=1;typehash=RIHS01_00;b=2;", "typehash"), "RIHS01_00");
  EXPECT_EQ(value_in("typehash=RIHS01_00", "typehash"), "RIHS01_00");
  EXPECT_EQ(value_in("typehashes=1;", "typehash"), "");
  EXPECT_EQ(value_in("", "typehash"), "");
  EXPECT_EQ(value_in(";;=;", "typehash"), "");
  EXPECT_EQ(value_in(std::string("enclave=/;\0", 11), "enclave"), "/");
}

TEST(UserDataTest, TypesOfRosHaveTheirNamesBack) {
  EXPECT_EQ(ros_type_name("nav_msgs::msg::dds_::Path_"), "nav_msgs/msg/Path");
  EXPECT_EQ(ros_type_name("HelloWorld"), "HelloWorld");
  EXPECT_EQ(ros_type_name("a::msg::dds_::B"), "a::msg::dds_::B");
}

TEST(VendorTest, HasANameOrItsNumbers) {
  EXPECT_EQ(vendor_name(1, 0x10), "Cyclone DDS");
  EXPECT_EQ(vendor_name(1, 0x0f), "Fast DDS");
  EXPECT_EQ(vendor_name(7, 9), "vendor 7.9");
}

TEST(SinkTest, TellsALineOnce) {
  std::vector<std::string> told;
  Sink sink([&](const std::string& line) { told.push_back(line); });
  for (const char* line : {"a", "b", "a", "", "b", "c"}) sink.tell(line);
  EXPECT_THAT(told, ElementsAre("a", "b", "c"));
}

TEST(SocketBuffersTest, LimitsThatAreTooLowAreSaidWithTheWayOut) {
  TemporaryFolder system;
  system.write("rmem_max", "4194304\n");
  system.write("wmem_max", "8388608\n");
  EXPECT_EQ(clamped_buffers(system.path()), std::nullopt);
  system.write("rmem_max", "212992\n");
  const std::optional<Finding> clamped = clamped_buffers(system.path());
  ASSERT_TRUE(clamped);
  EXPECT_EQ(clamped->kind, Finding::Kind::Remark);
  EXPECT_THAT(clamped->what, AllOf(HasSubstr("net.core.rmem_max=212992 "), Not(HasSubstr("wmem_max"))));
  EXPECT_EQ(clamped->advice, "sudo sysctl -w net.core.rmem_max=4194304 net.core.wmem_max=4194304");
  system.write("wmem_max", "1000\n");
  EXPECT_THAT(clamped_buffers(system.path()).value().what,
              HasSubstr("net.core.rmem_max=212992, net.core.wmem_max=1000 "));
}

TEST(SocketBuffersTest, ASystemThatDoesNotSayIsNotJudged) {
  EXPECT_EQ(clamped_buffers("/no/such/folder"), std::nullopt);
}

}  // namespace
}  // namespace scrubjay::ros
