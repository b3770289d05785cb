#include <scrubjay/ros2/node_name.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <scrubjay/error.hpp>

namespace scrubjay::ros {
namespace {

// Of the tokens in a name; ROS's are those of C, whatever the locale.
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool is_word(char c) {
  return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

constexpr std::size_t kLongestNode = 255;   // RMW_NODE_NAME_MAX_NAME_LENGTH
constexpr std::size_t kLongestTopic = 247;  // RMW_TOPIC_MAX_NAME_LENGTH: DDS's 255, less the prefix
constexpr std::size_t kLongestSpace = 245;  // RMW_NAMESPACE_MAX_LENGTH: room for a topic of one letter

/// What is wrong with one token; empty if nothing.
std::string_view fault_of_token(std::string_view token) {
  if (token.empty()) return "has an empty part";
  if (is_digit(token.front())) return "has a part that begins with a digit";
  if (!std::all_of(token.begin(), token.end(), is_word)) return "has other characters than letters, digits and _";
  return {};
}

/// What is wrong with `/all/the/parts`; empty if nothing.
std::string_view fault_of_path(std::string_view path) {
  if (!path.starts_with('/')) return "doesn't begin with /";
  while (!path.empty()) {
    path.remove_prefix(1);
    const std::string_view token = path.substr(0, path.find('/'));
    if (const std::string_view fault = fault_of_token(token); !fault.empty()) return fault;
    path.remove_prefix(token.size());
  }
  return {};
}

std::string checked_space(std::string space) {
  if (space.empty()) return "/";
  if (space == "/") return space;
  if (!space.starts_with('/')) space = fmt::format("/{}", space);
  if (const std::string_view fault = fault_of_path(space); !fault.empty()) {
    throw Error(fmt::format("the namespace {} {}; want one like /robot1", space, fault));
  }
  if (space.size() > kLongestSpace) {
    throw Error(fmt::format("the namespace {} is longer than {} characters", space, kLongestSpace));
  }
  return space;
}

std::string checked_name(std::string name) {
  if (const std::string_view fault = fault_of_token(name); !fault.empty()) {
    throw Error(fmt::format("the node's name '{}' {}; want one like scrubjay_1", name, fault));
  }
  if (name.size() > kLongestNode) {
    throw Error(fmt::format("the node's name {} is longer than {} characters", name, kLongestNode));
  }
  return name;
}

bool is_for(const Remapping& rule, const std::string& node) {
  return rule.node.empty() || rule.node == node;
}

/// What the first of a node's rules about one of `froms` says; `otherwise` if there is none.
std::string remapped(const std::vector<Remapping>& rules, const std::string& node,
                     std::initializer_list<std::string_view> froms, const std::string& otherwise) {
  const auto rule = std::find_if(rules.begin(), rules.end(), [&](const Remapping& r) {
    return is_for(r, node) && std::find(froms.begin(), froms.end(), r.from) != froms.end();
  });
  return rule == rules.end() ? otherwise : rule->to;
}

bool is_about_node(const Remapping& rule) {
  return rule.from == "__node" || rule.from == "__name" || rule.from == "__ns";
}

void replace_all(std::string& text, std::string_view what, std::string_view by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
}

constexpr std::string_view kTopicScheme = "rostopic://";

}  // namespace

NodeNames::NodeNames(const std::string& name, const std::string& space, std::vector<Remapping> remappings)
    : name_(checked_name(remapped(remappings, name, {"__node", "__name"}, name))),
      space_(checked_space(remapped(remappings, name_, {"__ns"}, space))),
      remappings_(std::move(remappings)) {}

std::string NodeNames::full_name() const {
  return fmt::format("{}/{}", space_ == "/" ? "" : space_, name_);
}

std::string NodeNames::topic(std::string_view topic) const {
  const std::string full = expanded(topic);
  for (const Remapping& rule : remappings_) {
    if (is_about_node(rule) || !is_for(rule, name_)) continue;
    std::string_view from = rule.from;
    if (from.starts_with(kTopicScheme)) from.remove_prefix(kTopicScheme.size());
    if (expanded(from) == full) return expanded(rule.to);
  }
  return full;
}

/// As rcl_expand_topic_name does it.
std::string NodeNames::expanded(std::string_view topic) const {
  std::string full(topic);
  replace_all(full, "{node}", name_);
  // In the root namespace what follows has its own slash.
  const std::string space = space_ == "/" ? "" : space_;
  replace_all(full, "{ns}", space);
  replace_all(full, "{namespace}", space);
  if (full == "~" || full.starts_with("~/")) {
    full.replace(0, 1, full_name());
  } else if (!full.starts_with('/')) {
    full = fmt::format("{}/{}", space, full);
  }
  if (const std::string_view fault = fault_of_path(full); !fault.empty()) {
    throw Error(fmt::format("the topic '{}' {}; want one like scan, ~/plan or /robot1/scan", topic, fault));
  }
  if (full.size() > kLongestTopic) {
    throw Error(fmt::format("the topic {} is longer than {} characters", full, kLongestTopic));
  }
  return full;
}

std::string dds_topic(std::string_view full_name) {
  return fmt::format("rt{}", full_name);
}

std::optional<std::string> topic_of_dds(std::string_view dds_name) {
  if (!dds_name.starts_with("rt/")) return std::nullopt;
  return std::string(dds_name.substr(2));
}

}  // namespace scrubjay::ros
