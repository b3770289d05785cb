#include "ros2/fast_dds.hpp"

#include <fastdds/rtps/transport/ChainingTransportDescriptor.h>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <gmock/gmock.h>
#include <stdlib.h>

#include "io/temporary_folder.hpp"

namespace scrubjay::ros {
namespace {

using ::testing::ElementsAre;
using ::testing::ExitedWithCode;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using Udp = eprosima::fastdds::rtps::UDPv4TransportDescriptor;

ParticipantOptions in_range(DiscoveryRange range, std::vector<std::string> static_peers = {}) {
  ParticipantOptions options;
  options.discovery = {range, std::move(static_peers)};
  return options;
}

/// The one transport, of UDP; a user's own isn't shielded.
const Udp& udp(const dds::DomainParticipantQos& qos) {
  using Chain = eprosima::fastdds::rtps::ChainingTransportDescriptor;
  const auto& first = *qos.transport().user_transports.at(0);
  const auto* shield = dynamic_cast<const Chain*>(&first);
  return dynamic_cast<const Udp&>(shield != nullptr ? *shield->low_level_descriptor : first);
}

TEST(ParticipantQosTest, OnLocalhostNothingLeavesThisMachine) {
  const dds::DomainParticipantQos qos = participant_qos(in_range(DiscoveryRange::Localhost));
  EXPECT_FALSE(qos.transport().use_builtin_transports);
  EXPECT_THAT(qos.transport().user_transports, SizeIs(1));
  EXPECT_THAT(udp(qos).interfaceWhiteList, ElementsAre("127.0.0.1"));
  EXPECT_THAT(qos.wire_protocol().builtin.initialPeersList, SizeIs(1));
  EXPECT_EQ(udp(qos).maxInitialPeersRange, 32U);
  EXPECT_THAT(udp(participant_qos(in_range(DiscoveryRange::Off))).interfaceWhiteList, ElementsAre("127.0.0.1"));
}

TEST(ParticipantQosTest, APeerElsewhereIsAskedFromAllInterfaces) {
  const auto white_list = [](const char* peer) {
    return udp(participant_qos(in_range(DiscoveryRange::Localhost, {peer}))).interfaceWhiteList;
  };
  EXPECT_THAT(white_list("192.0.2.77"), IsEmpty());
  EXPECT_THAT(white_list("127.0.0.1"), ElementsAre("127.0.0.1"));
}

TEST(ParticipantQosTest, OnTheSubnetStaticPeersComeBesidesMulticast) {
  const dds::DomainParticipantQos alone = participant_qos(in_range(DiscoveryRange::Subnet));
  EXPECT_THAT(udp(alone).interfaceWhiteList, IsEmpty());
  EXPECT_TRUE(alone.wire_protocol().builtin.initialPeersList.empty());
  const dds::DomainParticipantQos two = participant_qos(in_range(DiscoveryRange::Subnet, {"192.0.2.77", "192.0.2.78"}));
  EXPECT_THAT(two.wire_protocol().builtin.initialPeersList, SizeIs(3));
}

TEST(ParticipantQosTest, SharedMemoryIsThereOnRequestAlone) {
  ParticipantOptions options = in_range(DiscoveryRange::Localhost);
  options.shared_memory = true;
  EXPECT_THAT(participant_qos(options).transport().user_transports, SizeIs(2));
}

TEST(ParticipantQosTest, BuffersHaveRoomForAMap) {
  const dds::DomainParticipantQos qos = participant_qos(in_range(DiscoveryRange::Subnet));
  EXPECT_EQ(udp(qos).sendBufferSize, 4U * 1024 * 1024);
  EXPECT_EQ(udp(qos).receiveBufferSize, 4U * 1024 * 1024);
}

/// What the user's profile, which sets a lease of seven seconds and an interface, leaves of our settings; 0 if it is as
/// it should be. In a process of its own: Fast DDS reads profiles once.
[[noreturn]] void make_with_profile(const std::filesystem::path& profile, DiscoveryRange range, const char* interface) {
  ::setenv("FASTRTPS_DEFAULT_PROFILES_FILE", profile.c_str(), 1);
  const dds::DomainParticipantQos qos = participant_qos(in_range(range));
  const bool lease = qos.wire_protocol().builtin.discovery_config.leaseDuration.seconds == 7;
  const bool transport = qos.transport().user_transports.size() == 1 && udp(qos).interfaceWhiteList.at(0) == interface;
  ::_exit((lease ? 0 : 1) + (transport ? 0 : 2));
}

TEST(ParticipantQosDeathTest, AProfileOfTheUserIsRespected) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const TemporaryFolder folder;
  const auto profile = folder.write("profile.xml", R"(<?xml version="1.0" encoding="UTF-8"?>
<dds xmlns="http://www.eprosima.com/XMLSchemas/fastRTPS_Profiles"><profiles>
  <transport_descriptors><transport_descriptor>
    <transport_id>mine</transport_id><type>UDPv4</type>
    <interfaceWhiteList><address>127.0.0.2</address></interfaceWhiteList>
  </transport_descriptor></transport_descriptors>
  <participant profile_name="mine" is_default_profile="true"><rtps>
    <userTransports><transport_id>mine</transport_id></userTransports>
    <useBuiltinTransports>false</useBuiltinTransports>
    <builtin><discovery_config><leaseDuration><sec>7</sec></leaseDuration></discovery_config></builtin>
  </rtps></participant>
</profiles></dds>
)");
  EXPECT_EXIT(make_with_profile(profile, DiscoveryRange::Subnet, "127.0.0.2"), ExitedWithCode(0), "");
  // But for what mustn't leave this machine.
  EXPECT_EXIT(make_with_profile(profile, DiscoveryRange::Localhost, "127.0.0.1"), ExitedWithCode(0), "");
}

}  // namespace
}  // namespace scrubjay::ros
