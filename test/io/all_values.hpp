/// \file
/// Bytes of every value, for whatever has to let all of them through.
#pragma once

#include <cstdint>
#include <numeric>
#include <vector>

namespace scrubjay {

inline std::vector<std::uint8_t> all_values() {
  std::vector<std::uint8_t> bytes(256);
  std::iota(bytes.begin(), bytes.end(), std::uint8_t{0});
  return bytes;
}

}  // namespace scrubjay
