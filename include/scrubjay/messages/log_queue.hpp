/// \file
/// Lines for /rosout, from any thread, until somebody publishes them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <string>

namespace scrubjay::ros {

struct LogLine {
  std::uint8_t level = 0;  ///< Log's
  std::string text{};

  bool operator==(const LogLine&) const = default;
};

/// At most so many lines wait; one more drops the oldest.
class LogQueue {
 public:
  static constexpr std::size_t kMost = 1000;  ///< as many as the topic keeps

  void add(std::uint8_t level, std::string text) {
    const std::scoped_lock lock(mutex_);
    if (lines_.size() == kMost) lines_.pop_front();
    lines_.push_back({level, std::move(text)});
  }
  /// All that wait, the oldest first; they wait no more.
  std::deque<LogLine> take() {
    std::deque<LogLine> lines;
    const std::scoped_lock lock(mutex_);
    lines.swap(lines_);
    return lines;
  }

 private:
  std::mutex mutex_;
  std::deque<LogLine> lines_;
};

}  // namespace scrubjay::ros
