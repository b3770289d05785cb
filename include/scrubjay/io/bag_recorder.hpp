/// \file
/// All that is published, into a bag.
#pragma once

#include <map>
#include <memory>
#include <scrubjay/io/bag.hpp>
#include <scrubjay/messages/message_sink.hpp>

namespace scrubjay {

/// Adds each topic when it is first published on. Writes while it is told: what a disc can't take at once makes the
/// robot wait, and nothing is left out.
class BagRecorder final : public ros::MessageSink {
 public:
  explicit BagRecorder(std::unique_ptr<BagWriter> bag) : bag_(std::move(bag)) {}

  void publish(const ros::TopicInfo& topic, std::int64_t nanoseconds,
               const std::shared_ptr<const ros::Bytes>& bytes) override;
  /// As BagWriter::close().
  void close() { bag_->close(); }

 private:
  std::unique_ptr<BagWriter> bag_;
  std::map<std::string_view, std::size_t> numbers_;  // of topics, by name; the table of topics lives on
};

}  // namespace scrubjay
