/// \file
/// A robot of ours as a node of ROS 2: publishes what it knows, and takes what others want of it.
#pragma once

#include <map>
#include <memory>
#include <scrubjay/messages/message_sink.hpp>
#include <scrubjay/ros2/commands.hpp>
#include <scrubjay/ros2/participant.hpp>

namespace scrubjay::ros {

/// What a bridge of this name has: a writer for each of `written`, and a reader for all that Bridge::listen() hears.
std::vector<Endpoint> bridge_endpoints(const NodeNames& names, std::span<const TopicInfo> written);

class Bridge final : public MessageSink {
 public:
  /// Makes a writer for each of `topics` that there is to publish on, so that others see them before anything is said.
  /// Throws Error as Participant does.
  Bridge(ParticipantOptions options, std::span<const TopicInfo> topics);

  /// Has `commands` filled from now on, which must outlive the bridge.
  void listen(Commands& commands);
  /// Of all topics.
  WriterTally tally() const;
  /// Never waits: see Writer::publish().
  void publish(const TopicInfo& topic, std::int64_t nanoseconds, const std::shared_ptr<const Bytes>& bytes) override;
  /// What its writers did with messages, and whether any was lost since this was last asked for.
  std::optional<DiagnosticStatus> status() override;
  /// As Participant::flush().
  bool flush(double seconds) { return participant_.flush(seconds); }
  Participant& participant() { return participant_; }

 private:
  Participant participant_;
  std::map<std::string_view, Writer*> writers_;  // by topic, as the table of topics has it
  std::uint64_t lost_ = 0;                       // of which status() told
};

}  // namespace scrubjay::ros
