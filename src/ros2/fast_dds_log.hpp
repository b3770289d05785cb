/// \file
/// What Fast DDS itself has to say of errors.
#pragma once

#include <functional>
#include <string>

namespace scrubjay::ros {

/// As long as it is there, it hears of Fast DDS's errors, one from each place in its code. Nothing of them goes to
/// standard output, where Fast DDS would have them.
class LogEar {
 public:
  /// `hear` is called from the log's thread, one call at a time for all ears.
  explicit LogEar(std::function<void(const std::string& message)> hear);
  LogEar(const LogEar&) = delete;
  LogEar& operator=(const LogEar&) = delete;
  ~LogEar();  // hears all that was logged so far
};

/// The reason why something of Fast DDS fails: the first error that is logged, others follow from it.
class FirstError {
 public:
  /// Of all so far, since this was made; empty if there was none.
  std::string text();

 private:
  std::string first_;  // before the ear, which writes it
  LogEar ear_{[this](const std::string& message) {
    if (first_.empty()) first_ = message;
  }};
};

}  // namespace scrubjay::ros
