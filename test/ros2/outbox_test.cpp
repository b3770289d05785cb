#include "ros2/outbox.hpp"

#include <gmock/gmock.h>

#include <condition_variable>
#include <string>

#include "ros2/wire_fixture.hpp"

namespace scrubjay::ros {
namespace {

using ::testing::ElementsAre;

/// What is sent, once it is let through.
class Gate {
 public:
  Outbox::Send send() {
    return [this](const Bytes& message) {
      std::unique_lock lock(mutex_);
      ++came_;
      changed_.notify_all();
      changed_.wait(lock, [&] { return open_; });
      sent_.push_back(std::to_integer<int>(message.front()));
      return true;
    };
  }
  void open() {
    const std::scoped_lock lock(mutex_);
    open_ = true;
    changed_.notify_all();
  }
  /// Waits until somebody stands in front of it.
  void wait() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return came_ > 0; });
  }
  std::vector<int> sent() const {
    const std::scoped_lock lock(mutex_);
    return sent_;
  }

 private:
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  bool open_ = false;
  int came_ = 0;
  std::vector<int> sent_;
};

std::shared_ptr<const Bytes> message(int number) {
  return std::make_shared<const Bytes>(1, static_cast<std::byte>(number));
}

TEST(OutboxTest, SendsInTheOrderOfPublicationWhateverTheTopic) {
  Gate gate;
  {
    Outbox outbox;
    Outbox::Queue& one = outbox.add(10, gate.send());
    Outbox::Queue& other = outbox.add(10, gate.send());
    one.push(message(1));
    other.push(message(2));
    one.push(message(3));
    other.push(message(4));
    gate.open();
  }
  EXPECT_THAT(gate.sent(), ElementsAre(1, 2, 3, 4));
}

TEST(OutboxTest, WhileNothingIsTakenTheOldestAreDroppedAndCounted) {
  Gate gate;
  Outbox outbox;
  Outbox::Queue& queue = outbox.add(3, gate.send());
  queue.push(message(0));
  gate.wait();  // it is on its way: three more may wait
  for (int i = 1; i <= 10; ++i) queue.push(message(i));
  EXPECT_EQ(queue.tally(), (WriterTally{.published = 0, .dropped = 7, .refused = 0}));
  gate.open();
  ASSERT_TRUE(eventually([&] { return queue.tally().published == 4; }));
  EXPECT_THAT(gate.sent(), ElementsAre(0, 8, 9, 10));
}

TEST(OutboxTest, OneThatIsLatchedKeepsTheNewest) {
  Gate gate;
  Outbox outbox;
  Outbox::Queue& map = outbox.add(1, gate.send());
  map.push(message(0));
  gate.wait();
  for (int i = 1; i <= 5; ++i) map.push(message(i));
  gate.open();
  ASSERT_TRUE(outbox.flush(std::chrono::steady_clock::now() + std::chrono::seconds(30)));
  EXPECT_THAT(gate.sent(), ElementsAre(0, 5));
}

TEST(OutboxTest, AFloodOfOneTopicDropsNothingOfAnother) {
  Gate gate;
  Outbox outbox;
  Outbox::Queue& flood = outbox.add(2, gate.send());
  Outbox::Queue& other = outbox.add(2, gate.send());
  other.push(message(0));
  gate.wait();
  other.push(message(1));
  for (int i = 100; i < 200; ++i) flood.push(message(i));
  other.push(message(2));
  gate.open();
  ASSERT_TRUE(outbox.flush(std::chrono::steady_clock::now() + std::chrono::seconds(30)));
  EXPECT_THAT(gate.sent(), ElementsAre(0, 1, 198, 199, 2));
}

TEST(OutboxTest, WhatDdsRefusesIsCounted) {
  Outbox outbox;
  Outbox::Queue& queue = outbox.add(10, [](const Bytes& bytes) { return bytes.front() != std::byte{1}; });
  for (int i = 0; i < 3; ++i) queue.push(message(i));
  ASSERT_TRUE(outbox.flush(std::chrono::steady_clock::now() + std::chrono::seconds(30)));
  EXPECT_EQ(queue.tally(), (WriterTally{.published = 2, .dropped = 0, .refused = 1}));
}

TEST(OutboxTest, AFlushThatTakesTooLongSaysSo) {
  Gate gate;
  Outbox outbox;
  outbox.add(1, gate.send()).push(message(0));
  EXPECT_FALSE(outbox.flush(std::chrono::steady_clock::now()));
  gate.open();
}

}  // namespace
}  // namespace scrubjay::ros
