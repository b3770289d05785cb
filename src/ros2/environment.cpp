#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <scrubjay/error.hpp>
#include <scrubjay/ros2/environment.hpp>

namespace scrubjay::ros {
namespace {

constexpr std::array<std::string_view, 5> kDistributions{"humble", "iron", "jazzy", "kilted", "rolling"};

// RTPS 2.3, 9.6.1.1: ports from 7400 + 250 * domain, which end at 65535; on Linux, those of other sockets begin at
// 32768.
constexpr int kLastDomain = 232;
constexpr int kLastSafeDomain = 101;
constexpr std::size_t kLongestPeer = 255;  // RMW_DISCOVERY_OPTIONS_STATIC_PEERS_MAX_LENGTH

/// Reads variables one by one, and notes what was wrong with them.
class Reading {
 public:
  explicit Reading(const Variables& variables) : variables_(variables) {}

  int domain() {
    const std::string text = value("ROS_DOMAIN_ID");
    if (text.empty()) return 0;
    int domain = -1;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), domain);
    if (error != std::errc() || end != text.data() + text.size() || domain < 0 || domain > kLastDomain) {
      throw Error(fmt::format("ROS_DOMAIN_ID is '{}'; want a number from 0 to {}", text, kLastDomain));
    }
    if (domain > kLastSafeDomain) {
      warn(fmt::format("ROS_DOMAIN_ID is {}, whose ports other programs may have; up to {} none has", domain,
                       kLastSafeDomain));
    }
    return domain;
  }

  Distribution distribution() {
    const std::string text = value("ROS_DISTRO");
    if (const std::optional<Distribution> found = distribution_named(text)) return *found;
    if (!text.empty()) {
      warn(fmt::format("ROS_DISTRO is '{}'; taken for jazzy, as it is none of {}", text,
                       fmt::join(kDistributions, ", ")));
    }
    return Distribution::Jazzy;
  }

  Discovery discovery(Distribution distribution) {
    const bool localhost_only = value("ROS_LOCALHOST_ONLY") == "1";
    if (distribution == Distribution::Humble) {
      return {.range = localhost_only ? DiscoveryRange::Localhost : DiscoveryRange::Subnet};
    }
    if (localhost_only && distribution <= Distribution::Jazzy) {
      warn(
          "ROS_LOCALHOST_ONLY is deprecated, but holds: ROS_AUTOMATIC_DISCOVERY_RANGE and ROS_STATIC_PEERS are "
          "ignored");
      return {.range = DiscoveryRange::Localhost};
    }
    if (localhost_only) {
      warn(fmt::format("ROS_LOCALHOST_ONLY means nothing to {}; want ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST",
                       name_of(distribution)));
    }
    return {.range = range(), .static_peers = static_peers()};
  }

  std::optional<SecurityRequest> security() {
    if (value("ROS_SECURITY_ENABLE") != "true") return std::nullopt;
    return SecurityRequest{.enforce = value("ROS_SECURITY_STRATEGY") == "Enforce",
                           .keystore = value("ROS_SECURITY_KEYSTORE"),
                           .enclave_override = value("ROS_SECURITY_ENCLAVE_OVERRIDE")};
  }

  std::vector<std::string> warnings() && { return std::move(warnings_); }

 private:
  std::string value(const char* name) const { return variables_(name).value_or(""); }
  void warn(std::string line) { warnings_.push_back(std::move(line)); }

  DiscoveryRange range() {
    const std::string text = value("ROS_AUTOMATIC_DISCOVERY_RANGE");
    if (text.empty() || text == "SUBNET") return DiscoveryRange::Subnet;
    if (text == "OFF") return DiscoveryRange::Off;
    if (text == "SYSTEM_DEFAULT") return DiscoveryRange::SystemDefault;
    if (text != "LOCALHOST") {
      warn(fmt::format(
          "ROS_AUTOMATIC_DISCOVERY_RANGE is '{}'; taken for LOCALHOST, as it is none of OFF, LOCALHOST, SUBNET, "
          "SYSTEM_DEFAULT",
          text));
    }
    return DiscoveryRange::Localhost;
  }

  std::vector<std::string> static_peers() {
    std::vector<std::string> peers;
    std::string_view rest;
    const std::string text = value("ROS_STATIC_PEERS");
    for (rest = text; !rest.empty();) {
      const std::string_view peer = rest.substr(0, rest.find(';'));
      rest.remove_prefix(std::min(rest.size(), peer.size() + 1));
      if (peer.size() > kLongestPeer) {
        warn(fmt::format("ROS_STATIC_PEERS has one of {} characters, which is left out; {} may be", peer.size(),
                         kLongestPeer));
      } else if (!peer.empty()) {
        peers.emplace_back(peer);
      }
    }
    return peers;
  }

  const Variables& variables_;
  std::vector<std::string> warnings_;
};

}  // namespace

std::string_view name_of(Distribution distribution) {
  return kDistributions[static_cast<std::size_t>(distribution)];
}

std::optional<Distribution> distribution_named(std::string_view name) {
  const auto found = std::find(kDistributions.begin(), kDistributions.end(), name);
  if (found == kDistributions.end()) return std::nullopt;
  return static_cast<Distribution>(found - kDistributions.begin());
}

std::optional<std::string> process_variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::nullopt : std::optional<std::string>(value);
}

Environment read_environment(const Variables& variables, std::optional<Distribution> told) {
  Reading reading(variables);
  Environment environment;
  environment.domain = reading.domain();
  environment.distribution = told ? *told : reading.distribution();
  environment.discovery = reading.discovery(environment.distribution);
  environment.security = reading.security();
  environment.warnings = std::move(reading).warnings();
  return environment;
}

}  // namespace scrubjay::ros
