/// \file
/// Participants that talk to one another through the loopback device, and who listens to them.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <mutex>
#include <scrubjay/messages/cdr.hpp>
#include <scrubjay/messages/std_msgs.hpp>
#include <scrubjay/ros2/participant.hpp>
#include <string>
#include <thread>
#include <vector>

#include "ros2/fresh_domain.hpp"

namespace scrubjay::ros {

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
  std::size_t size() const { return all().size(); }
  std::vector<Item> all() const {
    const std::scoped_lock lock(mutex_);
    return items_;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<Item> items_;
};

class Inbox : public Kept<Bytes> {
 public:
  Receive receive() {
    return [this](std::span<const std::byte> message) { add(Bytes(message.begin(), message.end())); };
  }
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
