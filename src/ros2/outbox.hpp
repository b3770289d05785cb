/// \file
/// Messages that wait for a thread of their own to send them.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <scrubjay/messages/cdr.hpp>
#include <scrubjay/ros2/participant.hpp>
#include <thread>
#include <vector>

namespace scrubjay::ros {

/// Sends in the order of publication, whatever the topic. Destroyed, it sends what still waits.
class Outbox {
 public:
  /// Gives bytes to DDS; false if it didn't take them. May take its time.
  using Send = std::function<bool(const Bytes& message)>;

  /// The messages of one topic.
  class Queue {
   public:
    Queue(Outbox& outbox, std::size_t depth, Send send) : outbox_(outbox), depth_(depth), send_(std::move(send)) {}

    /// Never waits for a sending.
    void push(std::shared_ptr<const Bytes> message);
    WriterTally tally() const;

   private:
    friend class Outbox;

    Outbox& outbox_;
    std::size_t depth_;
    Send send_;
    std::deque<std::shared_ptr<const Bytes>> waiting_;
    WriterTally tally_;
  };

  Outbox();
  Outbox(const Outbox&) = delete;
  Outbox& operator=(const Outbox&) = delete;
  ~Outbox();

  /// It stays where it is as long as the outbox does. `depth`: at least one.
  Queue& add(std::size_t depth, Send send);
  /// Waits until everything is sent; false if that took longer.
  bool flush(std::chrono::steady_clock::time_point deadline);

 private:
  void run(const std::stop_token& end);

  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  std::vector<std::unique_ptr<Queue>> queues_;
  std::deque<Queue*> turns_;  ///< whose message is next: as often as it has messages
  bool sending_ = false;
  std::jthread thread_;  // the last member: it uses all others
};

}  // namespace scrubjay::ros
