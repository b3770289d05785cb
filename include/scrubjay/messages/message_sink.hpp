/// \file
/// Where messages go: over DDS, or into a recording.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <scrubjay/messages/cdr.hpp>
#include <scrubjay/messages/topics.hpp>

namespace scrubjay::ros {

class MessageSink {
 public:
  virtual ~MessageSink() = default;
  /// Takes a message and doesn't wait, nor throw: the robot may be moving. The bytes are shared by all sinks.
  virtual void publish(const TopicInfo& topic, std::int64_t nanoseconds, const std::shared_ptr<const Bytes>& bytes) = 0;
  /// How it fares, for /diagnostics, by a name that the node's stands before; none if it has nothing to tell.
  virtual std::optional<DiagnosticStatus> status() { return std::nullopt; }
};

}  // namespace scrubjay::ros
