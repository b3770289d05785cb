/// \file
/// A stand-in for the BRC pin, which a pseudo-terminal doesn't have.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace scrubjay::apps {

/// Pulses come as SIGUSR1, for every robot, or as lines on stdin: "brc", or "brc 2" for robot 2. While it lives,
/// SIGUSR1 does nothing else.
class BrcPin {
 public:
  explicit BrcPin(std::size_t robots);
  BrcPin(const BrcPin&) = delete;
  BrcPin& operator=(const BrcPin&) = delete;
  ~BrcPin();

  /// Robots whose pin was pulsed since the last call. Never waits; says on stderr what a line was that it didn't
  /// understand.
  std::vector<std::size_t> pulsed();

 private:
  void read_lines(std::vector<std::size_t>& robots);
  void obey(const std::string& line, std::vector<std::size_t>& robots) const;

  std::size_t count_;
  bool listens_ = true;  // to stdin
  std::string line_;     // so far
};

}  // namespace scrubjay::apps
