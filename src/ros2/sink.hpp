/// \file
/// Lines about what goes wrong, each once.
#pragma once

#include <functional>
#include <mutex>
#include <set>
#include <string>

namespace scrubjay::ros {

/// May be told from any thread.
class Sink {
 public:
  explicit Sink(std::function<void(const std::string& line)> tell) : tell_(std::move(tell)) {}

  void tell(const std::string& line) {
    const std::scoped_lock lock(mutex_);
    // Others' doings make lines, too: so many, and no more.
    if (line.empty() || told_.size() >= kMost || !told_.insert(line).second) return;
    if (tell_) tell_(line);
  }

 private:
  static constexpr std::size_t kMost = 256;

  std::function<void(const std::string& line)> tell_;
  std::mutex mutex_;
  std::set<std::string> told_;
};

}  // namespace scrubjay::ros
