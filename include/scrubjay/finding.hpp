/// \file
/// What a doctor finds, and what to do about it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace scrubjay {

struct Finding {
  enum class Kind : std::uint8_t {
    Remark,   ///< good to know; healthy all the same
    Problem,  ///< not healthy
  };
  Kind kind = Kind::Problem;
  std::string what;      ///< one sentence, without a full stop
  std::string advice{};  ///< what to try; of a remark it may be empty

  bool operator==(const Finding&) const = default;
};

/// Whether there is no problem among them.
inline bool healthy(const std::vector<Finding>& findings) {
  return std::ranges::none_of(findings, [](const Finding& finding) { return finding.kind == Finding::Kind::Problem; });
}

/// Problems first, each kind in its order.
inline void worst_first(std::vector<Finding>& findings) {
  std::ranges::stable_sort(findings, [](const Finding& a, const Finding& b) { return a.kind > b.kind; });
}

}  // namespace scrubjay
