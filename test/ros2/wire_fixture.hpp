/// \file
/// Participants that talk to one another through the loopback device, and who listens to them.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <mutex>
#include <scrubjay/messages/cdr.hpp>
#include <scrubjay/messages/std_msgs.hpp>
#include <scrubjay/ros2/participant.hpp>
#include <string>
#include <thread>
#include <vector>

#include "ros2/fresh_domain.hpp"

namespace scrubjay::ros {

inline constexpr Qos kBestEffort{Reliability::BestEffort, Durability::Volatile, 10};

/// Whether it comes true, at last.
template <typename Condition>
bool eventually(Condition condition, std::chrono::seconds patience = std::chrono::seconds(30)) {
  const auto deadline = std::chrono::steady_clock::now() + patience;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > deadline) return false;
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  return true;
}

/// Keeps what a thread of DDS brings.
template <typename Item>
class Kept {
 public:
  void add(Item item) {
    const std::scoped_lock lock(mutex_);
    items_.push_back(std::move(item));
  }
  std::size_t size() const {
    const std::scoped_lock lock(mutex_);
    return items_.size();
  }
  std::vector<Item> all() const {
    const std::scoped_lock lock(mutex_);
    return items_;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<Item> items_;
};

/// What is kept outlives the inbox for as long as somebody may bring more: a participant that is declared before it
/// ends after it.
class Inbox {
 public:
  Receive receive() {
    return [kept = kept_](std::span<const std::byte> message) { kept->add(Bytes(message.begin(), message.end())); };
  }
  std::size_t size() const { return kept_->size(); }
  std::vector<Bytes> all() const { return kept_->all(); }

 private:
  std::shared_ptr<Kept<Bytes>> kept_ = std::make_shared<Kept<Bytes>>();
};

inline Bytes text(const std::string& content) {
  return encode(String{content});
}

class WireTest : public ::testing::Test {
 protected:
  /// In a domain of this test's own, and nowhere but on this machine.
  ParticipantOptions options(const NodeNames& names = NodeNames{}) {
    ParticipantOptions options{.domain = domain_.number()};
    options.discovery.range = DiscoveryRange::Localhost;
    options.names = names;
    options.tell = [this](const std::string& line) { told_.add(line); };
    return options;
  }

  FreshDomain domain_;
  Kept<std::string> told_;  ///< by all of them
};

}  // namespace scrubjay::ros
