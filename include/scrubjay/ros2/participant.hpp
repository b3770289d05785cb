/// \file
/// A participant of DDS that is a node of ROS 2: bytes of messages out and in.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <scrubjay/messages/message_type.hpp>
#include <scrubjay/messages/qos.hpp>
#include <scrubjay/ros2/environment.hpp>
#include <scrubjay/ros2/keystore.hpp>
#include <scrubjay/ros2/node_name.hpp>
#include <scrubjay/ros2/peers.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace scrubjay::ros {

/// What a participant does with `ros_discovery_info`, the topic by which nodes say which endpoints are theirs.
enum class Presence : std::uint8_t {
  Unseen,    ///< nothing
  Onlooker,  ///< hears whose everything is, and is no node itself: `ros2 node list` shows nothing of it
  Node,      ///< tells what is its own, too
};

/// What Fast DDS itself calls an error is told with these words before it.
inline constexpr std::string_view kFromFastDds = "Fast DDS: ";

struct ParticipantOptions {
  int domain = 0;
  Distribution distribution = Distribution::Jazzy;
  Discovery discovery{};
  NodeNames names{};
  std::string enclave = "/";
  std::optional<SecurityFiles> security{};
  bool shared_memory = false;  ///< besides UDP: for peers of the same user, container and Fast DDS alone
  Presence presence = Presence::Node;
  std::size_t most_read = 256 * 1024;  ///< a longer message isn't taken [bytes]
  /// Is given what goes wrong, a line each and each line once, from any thread but never two at a time. Mustn't call
  /// the participant.
  std::function<void(const std::string& line)> tell = nullptr;
};

/// Options as the environment and the command line have them, for a node `scrubjay`. What they ask for in vain goes to
/// `warnings`. Throws Error where security is to be enforced and isn't to be had.
ParticipantOptions participant_options(const Environment& environment, const RosArguments& arguments,
                                       std::vector<std::string>& warnings);

struct WriterTally {
  std::uint64_t published = 0;  ///< handed to DDS
  std::uint64_t dropped = 0;    ///< as too many waited: the oldest ones
  std::uint64_t refused = 0;    ///< by DDS

  bool operator==(const WriterTally&) const = default;
};

/// One topic of ours that others listen to.
class Writer {
 public:
  struct State;

  explicit Writer(State& state) : state_(state) {}
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  /// Has a message sent (its bytes with the encapsulation, as `encode` gives them) and never waits: it is sent from the
  /// participant's own thread. At most Qos::depth messages wait; one more drops the oldest.
  void publish(std::shared_ptr<const std::vector<std::byte>> message);
  void publish(std::vector<std::byte> message);
  const std::string& topic() const;  ///< full name
  int readers() const;               ///< that are matched
  WriterTally tally() const;

 private:
  State& state_;
};

/// One topic of others that we listen to.
class Reader {
 public:
  struct State;

  explicit Reader(State& state) : state_(state) {}
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  const std::string& topic() const;  ///< full name
  int writers() const;               ///< that are matched
  std::uint64_t received() const;    ///< messages

 private:
  State& state_;
};

/// Takes a message's bytes, whatever they are, on a thread of DDS. Mustn't throw nor wait.
using Receive = std::function<void(std::span<const std::byte> message)>;

/// Until it is destroyed, it is in the domain. Its calls may come from any thread.
///
/// What is told of by ParticipantOptions::tell: readers and writers that don't match by their quality of service,
/// system limits that clamp the sockets' buffers, and peers of a distribution whose `ros_discovery_info` isn't ours.
class Participant {
 public:
  /// Throws Error (Kind::Failure) if DDS can't join the domain, such as with security files that don't fit.
  explicit Participant(ParticipantOptions options);
  Participant(const Participant&) = delete;
  Participant& operator=(const Participant&) = delete;
  ~Participant();

  /// `topic` as NodeNames::topic takes it. Several types under one topic are several writers or readers. Throws Error
  /// if DDS can't, such as where the permissions forbid it.
  Writer& write(std::string_view topic, const MessageType& type, const Qos& qos = {});
  Reader& read(std::string_view topic, const MessageType& type, const Qos& qos, Receive receive);

  /// Waits until all that was published is sent, and reliable readers have it; false if that took longer than
  /// `seconds`.
  bool flush(double seconds);

  /// Full names of the topics that we write and nobody listens to.
  std::vector<std::string> unheard() const;
  /// Everybody else, the longest known first.
  std::vector<Peer> peers() const;
  /// Our own readers and writers, in the order in which they were made.
  std::vector<Endpoint> endpoints() const;
  /// Messages of `ros_discovery_info` that another distribution had sent: with identifiers of another size, or garbage.
  std::uint64_t strange_discovery_infos() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace scrubjay::ros
