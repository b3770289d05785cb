/// \file
/// A few lines on a terminal that are redrawn in place.
#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace scrubjay::apps {

/// By plain ANSI sequences (ECMA-48). A terminal that takes nothing at the moment is passed over, never waited for.
class LiveText {
 public:
  /// `file`: an open terminal, which must stay open for longer.
  explicit LiveText(int file) : file_(file) {}

  /// Draws the lines over those before, cut to the terminal's size; at most every 100 ms, unless `now`.
  void show(const std::vector<std::string>& lines, bool now = false);

 private:
  int file_;
  std::size_t drawn_ = 0;  // lines
  std::chrono::steady_clock::time_point last_{};
};

}  // namespace scrubjay::apps
