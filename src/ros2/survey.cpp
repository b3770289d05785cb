#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <scrubjay/messages/topics.hpp>
#include <scrubjay/ros2/survey.hpp>

namespace scrubjay::ros {
namespace {

/// Where everybody writes what is their own.
constexpr std::array<std::string_view, 6> kShared{"/tf",          "/tf_static",        "/rosout",
                                                  "/diagnostics", "/parameter_events", kDiscoveryInfoTopic};

bool is_shared(std::string_view topic) {
  return std::ranges::find(kShared, topic) != kShared.end();
}

HashState hash_state(std::span<const Endpoint> ours, const Endpoint& theirs) {
  const auto known = std::ranges::find(ours, theirs.type, &Endpoint::type);
  if (known == ours.end()) return HashState::Unknown;
  if (theirs.hash.empty() || known->hash.empty()) return HashState::NotTold;
  return theirs.hash == known->hash ? HashState::Same : HashState::Other;
}

/// By which a reader of the report knows whom it is about.
std::string name_of(const Peer& peer, const Endpoint& endpoint) {
  if (!endpoint.node.empty()) return endpoint.node;
  if (!peer.nodes.empty()) return peer.nodes.front();
  return peer.address.empty() ? "somebody" : "somebody at " + peer.address;
}

/// A run's own participant, or one that it has besides for a second type of a topic.
bool is_run(const Peer& peer, const NodeNames& names) {
  const std::string helper = fmt::format("{}/_{}_", names.space() == "/" ? "" : names.space(), names.name());
  return std::ranges::any_of(
      peer.nodes, [&](const std::string& node) { return node == names.full_name() || node.starts_with(helper); });
}

std::string advice_about(const Endpoint& theirs, std::span<const Endpoint> ours) {
  const auto facing = [&](const Endpoint& one) { return one.topic == theirs.topic && one.writes != theirs.writes; };
  const auto fits = std::ranges::find_if(ours, [&](const Endpoint& o) { return facing(o) && o.type == theirs.type; });
  if (fits == ours.end()) {
    return fmt::format("one of the two is to be remapped, as by --ros-args -r {}:=another", theirs.topic);
  }
  return theirs.writes ? fmt::format("have it offer what we ask for: {}", text_of(fits->qos))
                       : fmt::format("have it ask for what we offer: {}", text_of(fits->qos));
}

class Diagnosis {
 public:
  explicit Diagnosis(const Survey& survey) : survey_(survey) {}

  std::vector<Finding> findings() && {
    if (survey_.others.empty()) nobody();
    if (survey_.strange_infos > 0) strange_infos();
    for (const Peer& peer : survey_.others) {
      for (const Endpoint& endpoint : peer.endpoints) add(peer, endpoint);
      same_topics(peer);
      nodes(peer);
    }
    worst_first(findings_);
    return std::move(findings_);
  }

 private:
  void problem(std::string what, std::string advice) {
    note(Finding::Kind::Problem, std::move(what), std::move(advice));
  }
  void remark(std::string what, std::string advice) { note(Finding::Kind::Remark, std::move(what), std::move(advice)); }
  void note(Finding::Kind kind, std::string what, std::string advice) {
    Finding finding{kind, std::move(what), std::move(advice)};
    if (std::ranges::find(findings_, finding) == findings_.end()) findings_.push_back(std::move(finding));
  }

  /// Each reason with what helps against it.
  void nobody() {
    const ParticipantOptions& settings = survey_.settings;
    problem(survey_.runs.empty() ? "Nobody else is in the domain" : "Nobody but a run of ours is in the domain",
            fmt::format("ROS_DOMAIN_ID={} for the others, too", settings.domain));
    switch (settings.discovery.range) {
      case DiscoveryRange::Off:
        remark("The discovery range is off, so that nobody is found", "another ROS_AUTOMATIC_DISCOVERY_RANGE");
        return;
      case DiscoveryRange::Localhost:
        remark("Only others on this machine are found, and only if they look no further, too",
               "ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST for them, or ROS_LOCALHOST_ONLY=1 up to Humble");
        break;
      case DiscoveryRange::Subnet:
      case DiscoveryRange::SystemDefault:
        remark(fmt::format("Others are found by multicast (UDP, from port {}), which firewalls, Wi-Fi and virtual "
                           "networks may swallow",
                           7400 + 250 * settings.domain),  // RTPS 2.3, 9.6.1.1
               "ROS_STATIC_PEERS with the others' addresses");
        break;
    }
    remark("Others in a container, or by shared memory alone, aren't heard",
           "docker run --net=host for a container, and UDP among the transports of the others");
    if (settings.security) {
      remark("Security is on: who has no certificate of this keystore isn't there for us", "");
    } else {
      remark("Security is off: who has it on isn't there for us", "ROS_SECURITY_ENABLE=true with their keystore");
    }
  }

  void strange_infos() {
    const bool humble = survey_.settings.distribution == Distribution::Humble;
    problem(
        fmt::format("Somebody's ros_discovery_info has other identifiers than that of {}: their nodes and ours don't "
                    "see one another, and may fail over it",
                    name_of(survey_.settings.distribution)),
        fmt::format("tell whose to use by ROS_DISTRO or --ros-distro: {}",
                    humble ? "jazzy or another one after Humble" : "humble"));
  }

  void add(const Peer& peer, const Endpoint& endpoint) {
    const Judgement judgement = judge(survey_.ours, endpoint);
    const std::string who = name_of(peer, endpoint);
    if (judgement.fit == Fit::Refused) {
      problem(fmt::format("{}: {} {}: {}", endpoint.topic, who, endpoint.writes ? "isn't heard" : "doesn't hear us",
                          judgement.why),
              advice_about(endpoint, survey_.ours));
    }
    if (judgement.fit == Fit::Matched && judgement.hash == HashState::Other) {
      problem(fmt::format("{}: {} has another definition of {} than ours: what arrives can't be read", endpoint.topic,
                          who, endpoint.type),
              fmt::format("its package {} is to be that of ROS 2", endpoint.type.substr(0, endpoint.type.find('/'))));
    }
  }

  /// What others write as we do: whoever listens hears both.
  void same_topics(const Peer& peer) {
    std::string topics;
    std::string who;
    for (const Endpoint& endpoint : peer.endpoints) {
      const bool both = endpoint.writes && judge(survey_.ours, endpoint).fit == Fit::SameSide;
      if (!both || is_shared(endpoint.topic)) continue;
      who = name_of(peer, endpoint);
      if (endpoint.topic == kClockTopic.name) {
        remark(fmt::format("{} is written by {}: beside a simulation or a replay of ours, time jumps", endpoint.topic,
                           who),
               "another ROS_DOMAIN_ID for one of the two");
      } else {
        topics += (topics.empty() ? "" : ", ") + endpoint.topic;
      }
    }
    if (topics.empty()) return;
    remark(fmt::format("Both we and {} write {}: who listens hears both", who, topics),
           "a namespace for one of the two, as by --ros-args -r __ns:=/robot1");
  }

  void nodes(const Peer& peer) {
    if (!peer.nodes.empty()) return;
    const std::string who =
        fmt::format("A participant of {}{}", peer.vendor, peer.address.empty() ? "" : " at " + peer.address);
    if (peer.enclave.empty()) {
      remark(who + " is no node of ROS 2, as it tells no enclave", "");
    } else {
      remark(who + " told of no node: it has none, or its ros_discovery_info didn't arrive",
             "--listen with more seconds");
    }
  }

  const Survey& survey_;
  std::vector<Finding> findings_;
};

}  // namespace

std::string_view name_of(HashState state) {
  constexpr std::array<std::string_view, 4> kNames{"same", "other", "not told", "unknown type"};
  return kNames[static_cast<std::size_t>(state)];
}

std::string_view name_of(Fit fit) {
  constexpr std::array<std::string_view, 4> kNames{"matched", "refused", "same side", "not ours"};
  return kNames[static_cast<std::size_t>(fit)];
}

Judgement judge(std::span<const Endpoint> ours, const Endpoint& theirs) {
  Judgement judgement{.hash = hash_state(ours, theirs)};
  const auto is_facing = [&](const Endpoint& one) { return one.topic == theirs.topic && one.writes != theirs.writes; };
  if (std::ranges::any_of(ours, is_facing)) {
    judgement.why = mismatch(ours, theirs);
    judgement.fit = judgement.why.empty() ? Fit::Matched : Fit::Refused;
  } else if (std::ranges::find(ours, theirs.topic, &Endpoint::topic) != ours.end()) {
    judgement.fit = Fit::SameSide;
  }
  return judgement;
}

bool is_of_service(const Endpoint& endpoint) {
  return endpoint.topic.starts_with("rq/") || endpoint.topic.starts_with("rr/");
}

Survey survey(ParticipantOptions settings, std::vector<Peer> peers, std::vector<Endpoint> planned,
              std::uint64_t strange_infos) {
  Survey survey{.settings = std::move(settings), .strange_infos = strange_infos};
  for (Peer& peer : peers) {
    const bool is_ours = is_run(peer, survey.settings.names);
    if (is_ours) survey.ours.insert(survey.ours.end(), peer.endpoints.begin(), peer.endpoints.end());
    (is_ours ? survey.runs : survey.others).push_back(std::move(peer));
  }
  if (survey.ours.empty()) survey.ours = std::move(planned);
  return survey;
}

std::vector<Finding> diagnose(const Survey& survey) {
  return Diagnosis(survey).findings();
}

}  // namespace scrubjay::ros
