#include "outbox.hpp"

#include <algorithm>

namespace scrubjay::ros {

void Outbox::Queue::push(std::shared_ptr<const Bytes> message) {
  std::shared_ptr<const Bytes> oldest;  // let go of without the lock: it may be a map of megabytes
  {
    const std::scoped_lock lock(outbox_.mutex_);
    if (waiting_.size() == depth_) {
      oldest = std::move(waiting_.front());
      waiting_.pop_front();
      ++tally_.dropped;
    } else {
      outbox_.turns_.push_back(this);
    }
    waiting_.push_back(std::move(message));
  }
  outbox_.changed_.notify_all();
}

WriterTally Outbox::Queue::tally() const {
  const std::scoped_lock lock(outbox_.mutex_);
  return tally_;
}

Outbox::Outbox() : thread_([this](const std::stop_token& end) { run(end); }) {}

Outbox::~Outbox() = default;

Outbox::Queue& Outbox::add(std::size_t depth, Send send) {
  const std::scoped_lock lock(mutex_);
  queues_.push_back(std::make_unique<Queue>(*this, std::max<std::size_t>(depth, 1), std::move(send)));
  return *queues_.back();
}

bool Outbox::flush(std::chrono::steady_clock::time_point deadline) {
  std::unique_lock lock(mutex_);
  return changed_.wait_until(lock, deadline, [&] { return turns_.empty() && !sending_; });
}

void Outbox::run(const std::stop_token& end) {
  std::unique_lock lock(mutex_);
  while (changed_.wait(lock, end, [&] { return !turns_.empty(); })) {
    Queue& queue = *turns_.front();
    turns_.pop_front();
    std::shared_ptr<const Bytes> message = std::move(queue.waiting_.front());
    queue.waiting_.pop_front();
    sending_ = true;
    lock.unlock();
    const bool taken = queue.send_(*message);
    message = {};
    lock.lock();
    sending_ = false;
    ++(taken ? queue.tally_.published : queue.tally_.refused);
    if (turns_.empty()) changed_.notify_all();
  }
}

}  // namespace scrubjay::ros
