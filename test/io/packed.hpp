/// \file
/// What gzip makes of a text.
#pragma once

#include <zlib.h>

#include <cstdint>
#include <string>
#include <vector>

namespace scrubjay {

inline std::vector<std::uint8_t> unpacked(const std::string& text) {
  return {text.begin(), text.end()};
}

inline std::vector<std::uint8_t> packed(const std::string& text) {
  constexpr int kGzip = 16 + MAX_WBITS;
  z_stream stream{};
  deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, kGzip, 8, Z_DEFAULT_STRATEGY);
  std::vector<std::uint8_t> input = unpacked(text);
  std::vector<std::uint8_t> out(deflateBound(&stream, static_cast<uLong>(input.size())) + 32);
  stream.next_in = input.data();
  stream.avail_in = static_cast<uInt>(input.size());
  stream.next_out = out.data();
  stream.avail_out = static_cast<uInt>(out.size());
  deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

}  // namespace scrubjay
