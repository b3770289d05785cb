#include <fmt/format.h>

#include <scrubjay/ros2/peers.hpp>

namespace scrubjay::ros {
namespace {

std::string_view name_of(Reliability reliability) {
  return reliability == Reliability::Reliable ? "reliable" : "best_effort";
}

std::string_view name_of(Durability durability) {
  return durability == Durability::TransientLocal ? "transient_local" : "volatile";
}

}  // namespace

std::string text_of(const Qos& qos) {
  return fmt::format("{}, {}", name_of(qos.reliability), name_of(qos.durability));
}

std::string mismatch(const Endpoint& one, const Endpoint& other) {
  if (one.writes == other.writes || one.topic != other.topic) return {};
  const Endpoint& writer = one.writes ? one : other;
  const Endpoint& reader = one.writes ? other : one;
  if (writer.type != reader.type) return fmt::format("written as {}, read as {}", writer.type, reader.type);
  // DDS 1.4, 2.2.3: what is offered must be as much as what is asked for, in the order of these enumerations.
  if (writer.qos.reliability < reader.qos.reliability) {
    return fmt::format("reliability: {} is asked for, {} is offered", name_of(reader.qos.reliability),
                       name_of(writer.qos.reliability));
  }
  if (writer.qos.durability < reader.qos.durability) {
    return fmt::format("durability: {} is asked for, {} is offered", name_of(reader.qos.durability),
                       name_of(writer.qos.durability));
  }
  return {};
}

std::string mismatch(std::span<const Endpoint> ours, const Endpoint& theirs) {
  std::string reason;
  for (const Endpoint& one : ours) {
    if (one.writes == theirs.writes || one.topic != theirs.topic) continue;
    reason = mismatch(one, theirs);
    if (reason.empty()) break;
  }
  return reason;
}

}  // namespace scrubjay::ros
