/// \file
/// What the environment variables of ROS 2 ask for.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scrubjay::ros {

/// Releases of ROS 2 that differ on the wire or in what they read from the environment.
enum class Distribution : std::uint8_t { Humble, Iron, Jazzy, Kilted, Rolling };

std::string_view name_of(Distribution distribution);
/// `humble`, `iron`, `jazzy`, `kilted`, `rolling`; none for other words.
std::optional<Distribution> distribution_named(std::string_view name);

/// How far a participant looks for others by itself (REP-2005's successor in rmw, `ROS_AUTOMATIC_DISCOVERY_RANGE`).
enum class DiscoveryRange : std::uint8_t {
  Off,           ///< nobody is found, nobody finds it
  Localhost,     ///< on this machine alone; nothing leaves it
  Subnet,        ///< as far as multicast goes
  SystemDefault  ///< whatever the middleware's own configuration says
};

struct Discovery {
  DiscoveryRange range = DiscoveryRange::Subnet;
  std::vector<std::string> static_peers{};  ///< further hosts to ask, by name or address

  bool operator==(const Discovery&) const = default;
};

/// Security (SROS 2) that is asked for.
struct SecurityRequest {
  bool enforce = false;  ///< without it, what isn't there is told and done without
  std::string keystore;  ///< a folder; may be empty
  std::string enclave_override;

  bool operator==(const SecurityRequest&) const = default;
};

struct Environment {
  int domain = 0;  ///< 0..232
  Distribution distribution = Distribution::Jazzy;
  Discovery discovery{};
  std::optional<SecurityRequest> security{};
  std::vector<std::string> warnings{};  ///< a line each, for whoever set a variable in vain
};

/// The value of a variable; none if it isn't set.
using Variables = std::function<std::optional<std::string>(const char* name)>;

/// Those of this process.
std::optional<std::string> process_variable(const char* name);

/// Reads `ROS_DOMAIN_ID`, `ROS_LOCALHOST_ONLY`, `ROS_AUTOMATIC_DISCOVERY_RANGE`, `ROS_STATIC_PEERS`, `ROS_SECURITY_*`
/// and `ROS_DISTRO` as rcl does (discovery_options.c, localhost.c, domain_id.c, security.c); an empty value is none.
/// What differs by distribution:
///
/// | | Humble | Iron, Jazzy | Kilted, Rolling |
/// |---|---|---|---|
/// | `ROS_LOCALHOST_ONLY` | read | read, wins | no more |
/// | range and peers | not yet | read | read |
///
/// `told`: the distribution, whatever `ROS_DISTRO` says. Throws Error if the domain isn't one.
Environment read_environment(const Variables& variables = process_variable, std::optional<Distribution> told = {});

}  // namespace scrubjay::ros
