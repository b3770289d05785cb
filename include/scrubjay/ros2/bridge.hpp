/// \file
/// A robot of ours as a node of ROS 2: publishes what it knows, and takes what others want of it.
#pragma once

#include <map>
#include <memory>
#include <scrubjay/messages/message_sink.hpp>
#include <scrubjay/ros2/commands.hpp>
#include <scrubjay/ros2/participant.hpp>

namespace scrubjay::ros {

class Bridge final : public MessageSink {
 public:
  /// Makes a writer for each of `topics` that there is to publish on, so that others see them before anything is said.
  /// Throws Error as Participant does.
  Bridge(ParticipantOptions options, std::span<const TopicInfo> topics);

  /// Has `commands` filled from now on, which must outlive the bridge.
  void listen(Commands& commands);
  /// Never waits: see Writer::publish().
  void publish(const TopicInfo& topic, std::int64_t nanoseconds, const std::shared_ptr<const Bytes>& bytes) override;
  /// As Participant::flush().
  bool flush(double seconds) { return participant_.flush(seconds); }
  Participant& participant() { return participant_; }

 private:
  Participant participant_;
  std::map<std::string_view, Writer*> writers_;  // by topic, as the table of topics has it
};

}  // namespace scrubjay::ros
