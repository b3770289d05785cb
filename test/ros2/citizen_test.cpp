/// \file
/// What participants see and tell of one another.
#include <gmock/gmock.h>

#include <scrubjay/messages/geometry_msgs.hpp>
#include <scrubjay/messages/nav_msgs.hpp>

#include "io/temporary_folder.hpp"
#include "ros2/wire_fixture.hpp"

namespace scrubjay::ros {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using ::testing::UnorderedElementsAre;

using CitizenTest = WireTest;

TEST_F(CitizenTest, OneTopicMayHaveTwoTypes) {
  Participant robot(options(NodeNames("jay")));
  Inbox plain;
  Inbox stamped;
  Reader& plain_reader = robot.read("cmd_vel", kTypeOf<Twist>, kBestEffort, plain.receive());
  Reader& stamped_reader = robot.read("cmd_vel", kTypeOf<TwistStamped>, kBestEffort, stamped.receive());
  robot.read("odom", kTypeOf<Twist>, kBestEffort, plain.receive());
  Participant old_nav(options(NodeNames("old")));
  Participant new_nav(options(NodeNames("new")));
  Writer& twist = old_nav.write("cmd_vel", kTypeOf<Twist>);
  Writer& twist_stamped = new_nav.write("cmd_vel", kTypeOf<TwistStamped>);
  ASSERT_TRUE(eventually([&] { return twist.readers() == 1 && plain_reader.writers() == 1; }));
  ASSERT_TRUE(eventually([&] { return twist_stamped.readers() == 1 && stamped_reader.writers() == 1; }));
  twist.publish(encode(Twist{.linear = {0.25, 0.0, 0.0}, .angular = {}}));
  twist_stamped.publish(encode(TwistStamped{.header = {}, .twist = {{0.5, 0.0, 0.0}, {}}}));
  ASSERT_TRUE(eventually([&] { return plain.size() == 1 && stamped.size() == 1; }));
  EXPECT_EQ(decode<Twist>(plain.all()[0])->linear.x, 0.25);
  EXPECT_EQ(decode<TwistStamped>(stamped.all()[0])->twist.linear.x, 0.5);
  // The node has one name, and one more that `ros2 node list` hides.
  std::vector<std::string> nodes;
  ASSERT_TRUE(eventually([&] {
    nodes.clear();
    for (const Peer& peer : new_nav.peers()) nodes.insert(nodes.end(), peer.nodes.begin(), peer.nodes.end());
    return nodes.size() == 3;
  }));
  EXPECT_THAT(nodes, UnorderedElementsAre("/jay", "/_jay_2", "/old"));
}

TEST_F(CitizenTest, QualitiesThatDoNotFitAreToldAtBothEnds) {
  Participant robot(options());
  Participant listener(options());
  robot.write("chatter", kTypeOf<String>, kBestEffort);
  listener.read("chatter", kTypeOf<String>, {}, [](auto) {});
  robot.write("map", kTypeOf<String>);
  listener.read("map", kTypeOf<String>, kLatched, [](auto) {});
  ASSERT_TRUE(eventually([&] { return told_.size() == 4; }));
  EXPECT_THAT(
      told_.all(),
      UnorderedElementsAre(
          "/chatter: a reader doesn't hear us, as it asks for another reliability; we offer best_effort, volatile",
          "/chatter: we don't hear a writer, as it offers another reliability; we ask for reliable, volatile",
          "/map: a reader doesn't hear us, as it asks for another durability; we offer reliable, volatile",
          "/map: we don't hear a writer, as it offers another durability; we ask for reliable, transient_local"));
}

TEST_F(CitizenTest, TopicsThatNobodyListensToAreKnown) {
  Participant robot(options(NodeNames("jay", "/robot1")));
  Participant listener(options());
  Writer& heard = robot.write("odom", kTypeOf<String>);
  robot.write("map", kTypeOf<String>);
  robot.write("/tf", kTypeOf<String>);
  listener.read("/robot1/odom", kTypeOf<String>, {}, [](auto) {});
  ASSERT_TRUE(eventually([&] { return heard.readers() == 1; }));
  EXPECT_THAT(robot.unheard(), ElementsAre("/robot1/map", "/tf"));
}

TEST_F(CitizenTest, PeersAreSeenWithAllThatTheyTell) {
  Participant robot(options(NodeNames("jay", "/robot1")));
  robot.write("map", kTypeOf<OccupancyGrid>, kLatched);
  robot.read("cmd_vel", kTypeOf<Twist>, kBestEffort, [](auto) {});
  ParticipantOptions other = options(NodeNames("doctor"));
  other.enclave = "/clinic";
  Participant doctor(other);
  std::vector<Peer> peers;
  ASSERT_TRUE(eventually([&] {
    peers = doctor.peers();
    // Its own three, and ros_discovery_info both ways.
    return peers.size() == 1 && peers[0].endpoints.size() == 4 && !peers[0].nodes.empty();
  }));
  EXPECT_EQ(peers[0].enclave, "/");
  EXPECT_EQ(peers[0].vendor, "Fast DDS");
  EXPECT_EQ(peers[0].address, "127.0.0.1");
  EXPECT_THAT(peers[0].nodes, ElementsAre("/robot1/jay"));
  EXPECT_THAT(peers[0].endpoints, Contains(Endpoint{.writes = true,
                                                    .topic = "/robot1/map",
                                                    .type = "nav_msgs/msg/OccupancyGrid",
                                                    .hash = std::string(OccupancyGrid::kHash),
                                                    .qos = {Reliability::Reliable, Durability::TransientLocal, 0},
                                                    .node = "/robot1/jay"}));
  EXPECT_THAT(peers[0].endpoints, Contains(Endpoint{.writes = false,
                                                    .topic = "/robot1/cmd_vel",
                                                    .type = "geometry_msgs/msg/Twist",
                                                    .hash = std::string(Twist::kHash),
                                                    .qos = {Reliability::BestEffort, Durability::Volatile, 0},
                                                    .node = "/robot1/jay"}));
  ASSERT_TRUE(eventually([&] { return robot.peers().size() == 1 && !robot.peers()[0].nodes.empty(); }));
  EXPECT_EQ(robot.peers()[0].enclave, "/clinic");
  EXPECT_THAT(robot.peers()[0].nodes, ElementsAre("/doctor"));
  EXPECT_THAT(robot.endpoints(), SizeIs(2));
  EXPECT_EQ(robot.endpoints()[0].node, "/robot1/jay");
}

TEST_F(CitizenTest, WhoLeavesIsNoPeerAnyMore) {
  Participant stays(options());
  {
    Participant leaves(options(NodeNames("raven")));
    ASSERT_TRUE(eventually([&] { return stays.peers().size() == 1; }));
  }
  EXPECT_TRUE(eventually([&] { return stays.peers().empty(); }));
}

TEST_F(CitizenTest, IdentifiersOfAnotherSizeAreCountedAndTold) {
  ParticipantOptions old = options(NodeNames("old"));
  old.distribution = Distribution::Humble;
  Participant robot(options());
  Participant humble(old);
  ASSERT_TRUE(eventually([&] { return robot.strange_discovery_infos() > 0 && humble.strange_discovery_infos() > 0; }));
  EXPECT_THAT(told_.all(), Contains(HasSubstr("identifiers of 24 bytes, ours has 16")));
  EXPECT_THAT(told_.all(), Contains(HasSubstr("identifiers of 16 bytes, ours has 24")));
  // We understand both.
  ASSERT_TRUE(eventually([&] { return robot.peers().size() == 1 && !robot.peers()[0].nodes.empty(); }));
  EXPECT_THAT(robot.peers()[0].nodes, ElementsAre("/old"));
}

TEST_F(CitizenTest, ParticipantsOfHumbleUnderstandOneAnother) {
  ParticipantOptions one = options(NodeNames("one"));
  ParticipantOptions other = options(NodeNames("other"));
  one.distribution = other.distribution = Distribution::Humble;
  Participant robot(one);
  Participant listener(other);
  ASSERT_TRUE(eventually([&] { return robot.peers().size() == 1 && !robot.peers()[0].nodes.empty(); }));
  EXPECT_THAT(robot.peers()[0].nodes, ElementsAre("/other"));
  EXPECT_EQ(robot.strange_discovery_infos(), 0U);
}

TEST_F(CitizenTest, ANodeNeedNotTellOfItself) {
  ParticipantOptions quiet = options();
  quiet.presence = Presence::Unseen;
  Participant robot(quiet);
  Participant listener(options());
  Writer& writer = robot.write("chatter", kTypeOf<String>);
  Reader& reader = listener.read("chatter", kTypeOf<String>, {}, [](auto) {});
  ASSERT_TRUE(eventually([&] { return writer.readers() == 1 && reader.writers() == 1; }));
  EXPECT_THAT(listener.peers()[0].endpoints, SizeIs(1));
}

TEST_F(CitizenTest, AnOnlookerHearsOfNodesAndTellsOfNone) {
  ParticipantOptions hidden = options();
  hidden.presence = Presence::Onlooker;
  Participant robot(options(NodeNames("jay")));
  Participant onlooker(hidden);
  ASSERT_TRUE(eventually([&] { return onlooker.peers().size() == 1 && !onlooker.peers()[0].nodes.empty(); }));
  EXPECT_THAT(onlooker.peers()[0].nodes, ElementsAre("/jay"));
  // It has one endpoint, which reads ros_discovery_info.
  ASSERT_TRUE(eventually([&] { return robot.peers().size() == 1 && robot.peers()[0].endpoints.size() == 1; }));
  EXPECT_FALSE(robot.peers()[0].endpoints[0].writes);
  EXPECT_THAT(robot.peers()[0].nodes, IsEmpty());
}

TEST_F(CitizenTest, ThoseOfOtherDomainsAreNotHeard) {
  const FreshDomain elsewhere;
  Participant robot(options());
  ParticipantOptions away = options();
  away.domain = elsewhere.number();
  Participant stranger(away);
  Participant neighbour(options());
  ASSERT_TRUE(eventually([&] { return robot.peers().size() == 1; }));
  EXPECT_THAT(stranger.peers(), IsEmpty());
}

TEST_F(CitizenTest, OffFindsNobody) {
  ParticipantOptions off = options();
  off.discovery.range = DiscoveryRange::Off;
  Participant alone(off);
  Writer& writer = alone.write("chatter", kTypeOf<String>);
  Participant one(options());
  Participant other(options());
  ASSERT_TRUE(eventually([&] { return one.peers().size() == 1 && other.peers().size() == 1; }));
  EXPECT_THAT(alone.peers(), IsEmpty());
  writer.publish(text("to nobody"));
  EXPECT_TRUE(alone.flush(30.0));
}

TEST_F(CitizenTest, AStaticPeerThatIsNowhereIsSaid) {
  ParticipantOptions with_peer = options();
  with_peer.discovery.static_peers = {"no.such.host.invalid"};
  EXPECT_THAT(message_of([&] { Participant robot(with_peer); }), HasSubstr("no.such.host.invalid"));
}

}  // namespace
}  // namespace scrubjay::ros
