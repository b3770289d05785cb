#include <gmock/gmock.h>

#include <map>
#include <scrubjay/ros2/environment.hpp>

#include "io/temporary_folder.hpp"

namespace scrubjay::ros {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Set = std::map<std::string, std::string>;

Environment read(const Set& set, std::optional<Distribution> told = {}) {
  const auto look_up = [&](const char* name) -> std::optional<std::string> {
    const auto found = set.find(name);
    return found == set.end() ? std::nullopt : std::optional(found->second);
  };
  return read_environment(look_up, told);
}

TEST(EnvironmentTest, WithoutAnyVariableItIsJazzyOnTheSubnetInDomainZero) {
  const Environment environment = read({});
  EXPECT_EQ(environment.domain, 0);
  EXPECT_EQ(environment.distribution, Distribution::Jazzy);
  EXPECT_EQ(environment.discovery, Discovery{});
  EXPECT_EQ(environment.discovery.range, DiscoveryRange::Subnet);
  EXPECT_FALSE(environment.security);
  EXPECT_THAT(environment.warnings, IsEmpty());
}

TEST(EnvironmentTest, EmptyIsAsGoodAsNotSet) {
  const Environment environment = read({{"ROS_DOMAIN_ID", ""},
                                        {"ROS_DISTRO", ""},
                                        {"ROS_LOCALHOST_ONLY", ""},
                                        {"ROS_AUTOMATIC_DISCOVERY_RANGE", ""},
                                        {"ROS_STATIC_PEERS", ""},
                                        {"ROS_SECURITY_ENABLE", ""}});
  EXPECT_EQ(environment.domain, 0);
  EXPECT_EQ(environment.discovery, Discovery{});
  EXPECT_FALSE(environment.security);
  EXPECT_THAT(environment.warnings, IsEmpty());
}

TEST(EnvironmentTest, ADomainIsANumberThatPortsAreMadeOf) {
  EXPECT_EQ(read({{"ROS_DOMAIN_ID", "42"}}).domain, 42);
  EXPECT_THAT(read({{"ROS_DOMAIN_ID", "101"}}).warnings, IsEmpty());
  EXPECT_EQ(read({{"ROS_DOMAIN_ID", "232"}}).domain, 232);
  EXPECT_THAT(read({{"ROS_DOMAIN_ID", "102"}}).warnings, ElementsAre(HasSubstr("ROS_DOMAIN_ID is 102")));
  for (const char* bad : {"233", "-1", "seven", "7x", " 7", "1.5", "99999999999999999999"}) {
    EXPECT_THAT(message_of([&] {
                  read({{"ROS_DOMAIN_ID", bad}});
                }),
                HasSubstr("ROS_DOMAIN_ID is '" + std::string(bad) + "'; want a number from 0 to 232"));
  }
}

TEST(EnvironmentTest, ADistributionIsKnownByName) {
  for (const auto each :
       {Distribution::Humble, Distribution::Iron, Distribution::Jazzy, Distribution::Kilted, Distribution::Rolling}) {
    EXPECT_EQ(distribution_named(name_of(each)), each);
    EXPECT_EQ(read({{"ROS_DISTRO", std::string(name_of(each))}}).distribution, each);
  }
  EXPECT_FALSE(distribution_named("Humble"));
}

TEST(EnvironmentTest, AnUnknownDistributionIsTakenForJazzyAndSaid) {
  const Environment environment = read({{"ROS_DISTRO", "noetic"}});
  EXPECT_EQ(environment.distribution, Distribution::Jazzy);
  EXPECT_THAT(environment.warnings, ElementsAre(HasSubstr("ROS_DISTRO is 'noetic'")));
}

TEST(EnvironmentTest, WhatIsToldGoesBeforeTheDistributionThatIsSet) {
  const Environment environment = read({{"ROS_DISTRO", "noetic"}}, Distribution::Humble);
  EXPECT_EQ(environment.distribution, Distribution::Humble);
  EXPECT_THAT(environment.warnings, IsEmpty());
}

struct Range {
  Distribution distribution;
  const char* localhost_only;
  const char* range;
  DiscoveryRange expected;
  bool warned = false;
};

class RangeTest : public ::testing::TestWithParam<Range> {};

TEST_P(RangeTest, IsWhatThisDistributionMakesOfTheVariables) {
  const Environment environment =
      read({{"ROS_LOCALHOST_ONLY", GetParam().localhost_only}, {"ROS_AUTOMATIC_DISCOVERY_RANGE", GetParam().range}},
           GetParam().distribution);
  EXPECT_EQ(environment.discovery.range, GetParam().expected);
  EXPECT_EQ(!environment.warnings.empty(), GetParam().warned);
}

INSTANTIATE_TEST_SUITE_P(
    Tables, RangeTest,
    ::testing::Values(Range{Distribution::Humble, "", "", DiscoveryRange::Subnet},
                      Range{Distribution::Humble, "1", "", DiscoveryRange::Localhost},
                      Range{Distribution::Humble, "0", "", DiscoveryRange::Subnet},
                      Range{Distribution::Humble, "true", "", DiscoveryRange::Subnet},
                      Range{Distribution::Humble, "", "LOCALHOST", DiscoveryRange::Subnet},
                      Range{Distribution::Humble, "1", "SUBNET", DiscoveryRange::Localhost},
                      Range{Distribution::Iron, "", "LOCALHOST", DiscoveryRange::Localhost},
                      Range{Distribution::Iron, "1", "SUBNET", DiscoveryRange::Localhost, true},
                      Range{Distribution::Jazzy, "", "OFF", DiscoveryRange::Off},
                      Range{Distribution::Jazzy, "", "SUBNET", DiscoveryRange::Subnet},
                      Range{Distribution::Jazzy, "", "SYSTEM_DEFAULT", DiscoveryRange::SystemDefault},
                      Range{Distribution::Jazzy, "0", "SUBNET", DiscoveryRange::Subnet},
                      Range{Distribution::Jazzy, "1", "OFF", DiscoveryRange::Localhost, true},
                      Range{Distribution::Jazzy, "", "localhost", DiscoveryRange::Localhost, true},
                      Range{Distribution::Jazzy, "", "EVERYWHERE", DiscoveryRange::Localhost, true},
                      Range{Distribution::Kilted, "1", "", DiscoveryRange::Subnet, true},
                      Range{Distribution::Kilted, "1", "OFF", DiscoveryRange::Off, true},
                      Range{Distribution::Rolling, "", "LOCALHOST", DiscoveryRange::Localhost}));

TEST(EnvironmentTest, StaticPeersStandBetweenSemicolons) {
  EXPECT_THAT(read({{"ROS_STATIC_PEERS", "192.168.1.7;;robot.local;"}}).discovery.static_peers,
              ElementsAre("192.168.1.7", "robot.local"));
}

TEST(EnvironmentTest, APeerThatIsTooLongIsLeftOut) {
  const Environment environment =
      read({{"ROS_STATIC_PEERS", "a;" + std::string(256, 'b') + ";" + std::string(255, 'c')}});
  EXPECT_THAT(environment.discovery.static_peers, ElementsAre("a", std::string(255, 'c')));
  EXPECT_THAT(environment.warnings, ElementsAre(HasSubstr("256 characters")));
}

TEST(EnvironmentTest, HumbleKnowsNoStaticPeersAndLocalhostOnlyIgnoresThem) {
  EXPECT_THAT(read({{"ROS_STATIC_PEERS", "a"}}, Distribution::Humble).discovery.static_peers, IsEmpty());
  EXPECT_THAT(read({{"ROS_STATIC_PEERS", "a"}, {"ROS_LOCALHOST_ONLY", "1"}}).discovery.static_peers, IsEmpty());
}

TEST(EnvironmentTest, SecurityIsOnByOneWordAlone) {
  const auto with = [](const char* enable, const char* strategy) {
    return read({{"ROS_SECURITY_ENABLE", enable},
                 {"ROS_SECURITY_STRATEGY", strategy},
                 {"ROS_SECURITY_KEYSTORE", "keys"},
                 {"ROS_SECURITY_ENCLAVE_OVERRIDE", "/robot1"}})
        .security;
  };
  EXPECT_FALSE(with("1", "Enforce"));
  EXPECT_FALSE(with("True", "Enforce"));
  EXPECT_EQ(with("true", "Enforce"), (SecurityRequest{true, "keys", "/robot1"}));
  EXPECT_EQ(with("true", "enforce"), (SecurityRequest{false, "keys", "/robot1"}));
  EXPECT_EQ(with("true", ""), (SecurityRequest{false, "keys", "/robot1"}));
}

}  // namespace
}  // namespace scrubjay::ros
