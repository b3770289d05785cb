#include <fmt/format.h>

#include <scrubjay/error.hpp>
#include <scrubjay/ros2/participant.hpp>
#include <scrubjay/ros2/socket_buffers.hpp>

#include "fast_dds.hpp"
#include "outbox.hpp"
#include "wire.hpp"

namespace scrubjay::ros {

struct Writer::State {
  Endpoint endpoint;
  dds::DataWriter* entity = nullptr;
  Outbox::Queue* queue = nullptr;
};

struct Reader::State {
  Endpoint endpoint;
  dds::DataReader* entity = nullptr;
  std::atomic<std::uint64_t> received{0};
};

void Writer::publish(std::shared_ptr<const Bytes> message) {
  state_.queue->push(std::move(message));
}

void Writer::publish(Bytes message) {
  publish(std::make_shared<const Bytes>(std::move(message)));
}

const std::string& Writer::topic() const {
  return state_.endpoint.topic;
}

int Writer::readers() const {
  dds::PublicationMatchedStatus status;
  state_.entity->get_publication_matched_status(status);
  return status.current_count;
}

WriterTally Writer::tally() const {
  return state_.queue->tally();
}

const std::string& Reader::topic() const {
  return state_.endpoint.topic;
}

int Reader::writers() const {
  dds::SubscriptionMatchedStatus status;
  state_.entity->get_subscription_matched_status(status);
  return status.current_count;
}

std::uint64_t Reader::received() const {
  return state_.received;
}

struct Participant::State {
  struct OurWriter {
    Writer::State state;
    Writer writer{state};
  };
  struct OurReader {
    Reader::State state;
    Reader reader{state};
  };

  explicit State(ParticipantOptions given) : options(std::move(given)), ears{.sink = Sink(options.tell)} {}

  Wire& wire_for(const std::string& topic, const MessageType& type);
  Endpoint endpoint(bool writes, const std::string& topic, const MessageType& type, const Qos& qos) const {
    return {writes, topic, std::string(type.name), std::string(type.hash), qos, options.names.full_name()};
  }

  ParticipantOptions options;
  Ears ears;
  mutable std::mutex mutex;
  std::vector<Endpoint> endpoints;
  std::vector<std::unique_ptr<OurWriter>> writers;
  std::vector<std::unique_ptr<OurReader>> readers;
  std::vector<std::unique_ptr<Wire>> wires;  // the first one is the node's own; their threads use the readers
  Outbox outbox;                             // its thread uses the writers
};

/// One that has the topic with this type, or can have it.
Wire& Participant::State::wire_for(const std::string& topic, const MessageType& type) {
  for (const std::unique_ptr<Wire>& wire : wires) {
    if (wire->can_have(topic, type)) return *wire;
  }
  // Its node has a name that `ros2 node list` doesn't show: two nodes of one name would be a mistake.
  const std::string node = fmt::format("_{}_{}", options.names.name(), wires.size() + 1);
  wires.push_back(std::make_unique<Wire>(options, node, ears));
  return *wires.back();
}

ParticipantOptions participant_options(const Environment& environment, const RosArguments& arguments,
                                       std::vector<std::string>& warnings) {
  warnings.insert(warnings.end(), environment.warnings.begin(), environment.warnings.end());
  warnings.insert(warnings.end(), arguments.warnings.begin(), arguments.warnings.end());
  ParticipantOptions options{.domain = environment.domain,
                             .distribution = environment.distribution,
                             .discovery = environment.discovery,
                             .names = NodeNames("scrubjay", "/", arguments.remappings),
                             .enclave = arguments.enclave};
  if (environment.security) {
    options.security = find_security_files(*environment.security, options.enclave, warnings);
  }
  return options;
}

Participant::Participant(ParticipantOptions options) : state_(std::make_unique<State>(std::move(options))) {
  if (const std::optional<Finding> clamped = clamped_buffers()) {
    state_->ears.sink.tell(clamped->what + "; " + clamped->advice);
  }
  state_->wires.push_back(std::make_unique<Wire>(state_->options, state_->options.names.name(), state_->ears));
}

Participant::~Participant() = default;

Writer& Participant::write(std::string_view topic, const MessageType& type, const Qos& qos) {
  const std::string full = state_->options.names.topic(topic);
  const std::scoped_lock lock(state_->mutex);
  auto ours = std::make_unique<State::OurWriter>();
  Writer::State& state = ours->state;
  state.endpoint = state_->endpoint(true, full, type, qos);
  state.entity = state_->wire_for(full, type).write(full, type, qos);
  state.queue = &state_->outbox.add(static_cast<std::size_t>(qos.depth),
                                    [&state](const Bytes& message) { return write_message(*state.entity, message); });
  state_->endpoints.push_back(state.endpoint);
  return state_->writers.emplace_back(std::move(ours))->writer;
}

Reader& Participant::read(std::string_view topic, const MessageType& type, const Qos& qos, Receive receive) {
  const std::string full = state_->options.names.topic(topic);
  const std::scoped_lock lock(state_->mutex);
  auto ours = std::make_unique<State::OurReader>();
  Reader::State& state = ours->state;
  state.endpoint = state_->endpoint(false, full, type, qos);
  const auto count = [&state, receive = std::move(receive)](std::span<const std::byte> message) {
    ++state.received;
    receive(message);
  };
  // Messages come from now on.
  Reader& reader = state_->readers.emplace_back(std::move(ours))->reader;
  try {
    state.entity = state_->wire_for(full, type).read(full, type, qos, count);
  } catch (const Error&) {
    state_->readers.pop_back();
    throw;
  }
  state_->endpoints.push_back(state.endpoint);
  return reader;
}

bool Participant::flush(double seconds) {
  const auto deadline =
      std::chrono::steady_clock::now() +
      std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::duration<double>(seconds));
  if (!state_->outbox.flush(deadline)) return false;
  const std::scoped_lock lock(state_->mutex);
  bool acknowledged = true;
  for (const auto& ours : state_->writers) {
    const auto left = deadline - std::chrono::steady_clock::now();
    acknowledged = wait_for_acknowledgments(*ours->state.entity, left) && acknowledged;
  }
  return acknowledged;
}

std::vector<std::string> Participant::unheard() const {
  const std::scoped_lock lock(state_->mutex);
  std::vector<std::string> topics;
  for (const auto& ours : state_->writers) {
    if (ours->writer.readers() == 0) topics.push_back(ours->writer.topic());
  }
  return topics;
}

std::vector<Peer> Participant::peers() const {
  const std::scoped_lock lock(state_->mutex);
  std::vector<Guid> ours;
  for (const std::unique_ptr<Wire>& wire : state_->wires) ours.push_back(wire->guid());
  return state_->ears.graph.peers(ours);
}

std::vector<Endpoint> Participant::endpoints() const {
  const std::scoped_lock lock(state_->mutex);
  return state_->endpoints;
}

std::uint64_t Participant::strange_discovery_infos() const {
  return state_->ears.strange_infos;
}

}  // namespace scrubjay::ros
