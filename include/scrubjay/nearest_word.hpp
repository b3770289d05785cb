/// \file
/// What a user may have meant.
#pragma once

#include <algorithm>
#include <numeric>
#include <string_view>
#include <vector>

namespace scrubjay {

/// How many letters to change, add or drop to get from one word to the other (Levenshtein, 1966).
inline std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({changed, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

/// The one of `known` (not empty) that begins with `word`, or else is spelled most like it.
inline std::string_view nearest_word(std::string_view word, const std::vector<std::string_view>& known) {
  const auto distance = [&](std::string_view name) {
    return !word.empty() && name.starts_with(word) ? 0 : edit_distance(word, name);
  };
  return *std::min_element(known.begin(), known.end(), [&](auto a, auto b) { return distance(a) < distance(b); });
}

}  // namespace scrubjay
