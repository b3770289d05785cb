#include "domain_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "report_rows.hpp"

namespace scrubjay::apps {
namespace {

using nlohmann::json;
using ros::Endpoint;
using ros::Peer;
using ros::Survey;

std::string_view range_name(ros::DiscoveryRange range) {
  switch (range) {
    case ros::DiscoveryRange::Off:
      return "off";
    case ros::DiscoveryRange::Localhost:
      return "localhost";
    case ros::DiscoveryRange::Subnet:
      return "subnet";
    case ros::DiscoveryRange::SystemDefault:
      return "system default";
  }
  return "";
}

/// Others choose their names: nothing in them is to move the cursor.
std::string shown(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) >= 0x7f) c = '?';
  }
  return text;
}

std::string settings_rows(const Survey& survey) {
  const ros::ParticipantOptions& settings = survey.settings;
  std::string text =
      row("domain", fmt::format("{}, {}, discovery range: {}", settings.domain, ros::name_of(settings.distribution),
                                range_name(settings.discovery.range)));
  if (!settings.discovery.static_peers.empty()) {
    text += row("static peers", fmt::format("{}", fmt::join(settings.discovery.static_peers, ", ")));
  }
  text += row("security", settings.security ? "on, with " + settings.security->certificate : "off");
  text += row("as node", fmt::format("{}, enclave {}", settings.names.full_name(), settings.enclave));
  if (survey.runs.empty()) return text + row("compared", "others with what scrubjay bridge would have");
  return text + row("compared", "others with the run of that name, which is there");
}

/// `Cyclone DDS at 127.0.0.1, enclave /`
std::string place_of(const Peer& peer) {
  std::string text = peer.vendor;
  if (!peer.address.empty()) text += " at " + peer.address;
  text += peer.enclave.empty() ? ", no enclave" : ", enclave " + peer.enclave;
  if (!peer.name.empty() && peer.name != peer.enclave) text += fmt::format(", calls itself {}", peer.name);
  return shown(text);
}

std::string_view hash_words(ros::HashState state) {
  switch (state) {
    case ros::HashState::Same:
      return "hash as ours";
    case ros::HashState::Other:
      return "HASH NOT OURS";
    case ros::HashState::NotTold:
      return "no hash told";
    case ros::HashState::Unknown:
      return "not a type of ours";
  }
  return "";
}

std::string fit_words(const ros::Judgement& judgement) {
  switch (judgement.fit) {
    case ros::Fit::Matched:
      return "matched";
    case ros::Fit::Refused:
      return "NOT MATCHED: " + judgement.why;
    case ros::Fit::SameSide:
      return "we do, too";
    case ros::Fit::NotOurs:
      return "not a topic of ours";
  }
  return "";
}

std::string endpoint_rows(const Survey& survey, const Endpoint& endpoint) {
  const ros::Judgement judgement = ros::judge(survey.ours, endpoint);
  return row(endpoint.writes ? "  writes" : "  reads", shown(endpoint.topic + " " + endpoint.type)) +
         row("", shown(fmt::format("{}; {}; {}", ros::text_of(endpoint.qos), hash_words(judgement.hash),
                                   fit_words(judgement))));
}

/// What a node has, or what nobody says to be theirs; by topic.
std::vector<Endpoint> endpoints_of(const Peer& peer, const std::string& node) {
  std::vector<Endpoint> endpoints;
  std::ranges::copy_if(peer.endpoints, std::back_inserter(endpoints),
                       [&](const Endpoint& endpoint) { return endpoint.node == node; });
  std::ranges::stable_sort(endpoints, {}, [](const Endpoint& e) { return std::pair(e.topic, e.writes); });
  return endpoints;
}

std::string node_rows(const Survey& survey, const Peer& peer, const std::string& node) {
  std::string text;
  std::size_t services = 0;
  for (const Endpoint& endpoint : endpoints_of(peer, node)) {
    if (ros::is_of_service(endpoint)) {
      ++services;
    } else if (endpoint.topic != ros::kDiscoveryInfoTopic) {
      text += endpoint_rows(survey, endpoint);
    }
  }
  if (services > 0)
    text += row("  and", fmt::format("{} {} of services", services, services == 1 ? "topic" : "topics"));
  return text;
}

std::string peer_rows(const Survey& survey, const Peer& peer) {
  std::string text = row("peer", place_of(peer));
  for (const std::string& node : peer.nodes) text += row("node", shown(node)) + node_rows(survey, peer, node);
  const std::string nobodys = node_rows(survey, peer, "");
  if (nobodys.empty() || peer.nodes.empty()) return text + nobodys;
  return text + row("of no node", "") + nobodys;
}

json endpoint_json(const Survey& survey, const Endpoint& endpoint) {
  const ros::Judgement judgement = ros::judge(survey.ours, endpoint);
  return {{"writes", endpoint.writes},
          {"topic", endpoint.topic},
          {"type", endpoint.type},
          {"hash", endpoint.hash},
          {"hash_state", ros::name_of(judgement.hash)},
          {"reliability", endpoint.qos.reliability == ros::Reliability::Reliable ? "reliable" : "best_effort"},
          {"durability", endpoint.qos.durability == ros::Durability::Volatile ? "volatile" : "transient_local"},
          {"node", endpoint.node},
          {"fit", ros::name_of(judgement.fit)},
          {"why", judgement.why}};
}

json peer_json(const Survey& survey, const Peer& peer) {
  json endpoints = json::array();
  for (const Endpoint& endpoint : peer.endpoints) endpoints.push_back(endpoint_json(survey, endpoint));
  return {{"name", peer.name},       {"enclave", peer.enclave}, {"vendor", peer.vendor},
          {"address", peer.address}, {"nodes", peer.nodes},     {"endpoints", endpoints}};
}

}  // namespace

std::string domain_text(const Survey& survey, const std::vector<Finding>& findings) {
  std::string text = settings_rows(survey) + '\n';
  for (const Peer& run : survey.runs) {
    text +=
        row("our run", fmt::format("{}: {} topics, {}", shown(run.nodes.front()), run.endpoints.size(), place_of(run)));
  }
  if (!survey.runs.empty()) text += '\n';
  for (const Peer& peer : survey.others) text += peer_rows(survey, peer) + '\n';
  std::vector<Finding> harmless;
  for (const auto& [kind, what, advice] : findings) harmless.push_back({kind, shown(what), shown(advice)});
  return text + findings_text(harmless);
}

std::string domain_json(const Survey& survey, const std::vector<Finding>& findings) {
  const ros::ParticipantOptions& settings = survey.settings;
  json report;
  report["healthy"] = healthy(findings);
  report["settings"] = {{"domain", settings.domain},
                        {"distribution", ros::name_of(settings.distribution)},
                        {"discovery_range", range_name(settings.discovery.range)},
                        {"static_peers", settings.discovery.static_peers},
                        {"security", settings.security.has_value()},
                        {"node", settings.names.full_name()},
                        {"enclave", settings.enclave}};
  report["runs"] = json::array();
  for (const Peer& run : survey.runs) report["runs"].push_back(peer_json(survey, run));
  report["peers"] = json::array();
  for (const Peer& peer : survey.others) report["peers"].push_back(peer_json(survey, peer));
  report["findings"] = findings_json(findings);
  // What others call themselves may be no UTF-8.
  return report.dump(2, ' ', false, json::error_handler_t::replace) + '\n';
}

}  // namespace scrubjay::apps
